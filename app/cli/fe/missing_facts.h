#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/fe/fe_result.h"

namespace rubble::cli {

/// Something that a simulation needs and an FE result does not say.
struct MissingFact {
    std::string what;        ///< stable: "density", "thickness", "section", "velocity", "death_time", "units"
    std::int64_t count = 0;  ///< elements that it is missing for; 0 for what concerns the result as a whole
    std::string instead;     ///< what is done without it, and how to say it
};

/// What a result leaves open, in a fixed order; the user's settings and assumptions are not looked at.
std::vector<MissingFact> missingFacts(const FeResult& fe);

}  // namespace rubble::cli
