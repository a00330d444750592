#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/ids.h"
#include "core/fe/activity.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// One unbroken run of active states of an element that ended with its death.
struct Lifetime {
    ElementIndex element{};
    std::uint32_t firstActive = 0;        ///< first state of the run
    std::uint32_t lastActive = 0;         ///< last state of the run: the hand-over, unless a birth window begins before it
    std::uint32_t firstDead = 0;          ///< the state after it
    std::optional<std::uint32_t> backAt;  ///< state at which the element is active again (policy Follow only)
};

/// The lifetimes that end with a death, ordered by lastActive, then the number of the element. Under Latch an element has at most
/// one and what comes back is counted; under Follow each death makes one. An element that is inactive at first and appears later
/// begins its first life then, which is no revival; one that is never active has no life. Both are counted. Throws UsageError under
/// Refuse if an element comes back to life, naming it and the state; Cancelled.
std::vector<Lifetime> endedLifetimes(const FeResult& fe, const Components& components, Revival policy, Findings& findings,
                                     const Execution& execution);

/// Activity as the policy sees it: under Latch an element that has died stays inactive; otherwise as the file says.
Activity activityUnder(const Activity& file, Revival policy);

}  // namespace rubble
