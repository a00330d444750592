#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evidence/ensemble.h"
#include "core/scenario/case.h"
#include "io/geo/ensemble_origin.h"

namespace rubble::io {

/// A case with all that the members of its ensemble stand on.
struct EnsembleSource {
    std::string name;  ///< of the case, or of its scenario where one was asked for
    std::vector<EnsembleScene> scenes;
    std::vector<EnsembleInput> inputs;
    Frame frame;
    Site site;
    Findings findings;  ///< of what was read
};

/// An FE result that is open already: it is not read a second time.
struct OpenResult {
    std::string path;
    ImportSettings import;
    std::shared_ptr<const FeResult> fe;
};

/// Ids of the scenarios that members are drawn from, each once; empty: the scenario is not varied.
std::vector<std::string> variedScenarios(const EnsembleSettings& settings);

/// Opens the scenarios of a case that its ensemble draws from; one alone if it is named, or if scenarios are not varied the one
/// that is worked on.
/// @param base  the file that inputs are relative to; @param copies  through compressed copies in the cache folder
/// Throws what the readers throw; UsageError for a scenario or an input that the case does not have; Cancelled.
EnsembleSource openEnsemble(const Case& theCase, const std::string& base, const std::optional<std::string>& scenario,
                            const EnsembleSettings& settings, const OpenResult& open, bool copies, const Execution& execution);

}  // namespace rubble::io
