#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/message.h"
#include "core/evidence/ensembles/cause_comparison.h"
#include "core/evidence/ensembles/ensemble.h"

namespace rubble {

/// What must be known of the members of an ensemble beside whatever is made of them.
struct MemberDoubt {
    Message what;
    Message remedy;
};

/// Members whose bodies still moved where they count as at rest, and members that passed limits of health.
std::vector<MemberDoubt> memberDoubts(const EnsembleReport& report);
/// The same of the members of several causes together.
std::vector<MemberDoubt> memberDoubts(std::span<const Hypothesis> causes);

/// All members lay at rest where they count as at rest.
bool allAtRest(const EnsembleReport& report);
/// What a map of an ensemble shows: at rest, at the end of the FE result, or where each member ended.
std::string ensembleClass(const EnsembleReport& report);

/// What was found of the members of several causes. What must be known of members is counted over all causes.
Findings findingsOfMembers(std::span<const Hypothesis> causes);

}  // namespace rubble
