#pragma once

#include <vector>

#include "core/base/message.h"
#include "core/evidence/ensembles/ensemble.h"

namespace rubble {

/// What must be known of the members of an ensemble beside whatever is made of them.
struct MemberDoubt {
    Message what;
    Message remedy;
};

/// Members whose bodies still moved where they count as at rest, and members that passed limits of health.
std::vector<MemberDoubt> memberDoubts(const EnsembleReport& report);

}  // namespace rubble
