#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/components.h"
#include "core/fe/live_islands.h"

namespace rubble {

/// How a loose island ends.
enum class IslandEnd : std::uint8_t {
    Died,       ///< none of its elements is active any more
    Joined,     ///< what was left of it hangs on a larger island again, by elements that came back
    Supported,  ///< what was left of it is held again
    Alive       ///< at the last state
};

/// Live structure without a path to a support, from the state in which it came loose. It keeps its identity while it loses
/// elements; where it falls apart, its largest part does, and the others are new islands that came out of it.
struct LooseIsland {
    std::uint32_t from = 0;  ///< first state in which it is loose
    std::uint32_t to = 0;    ///< last state in which it is loose and active
    IslandEnd end = IslandEnd::Died;
    std::optional<std::uint32_t> parent;  ///< index of the island that it came out of; unset: it broke off what stands
    std::vector<ElementIndex> elements;   ///< at its first state, ascending
};

/// In place of the index of an island.
constexpr std::uint32_t inNoIsland = 0xffffffffu;

/// All that is loose in an FE result, state by state.
struct LooseStructure {
    std::vector<LooseIsland> islands;  ///< in the order in which they came loose, then of their first elements
    /// Island of each element at each state, inNoIsland where it is none: elements in ascending order, one list a state.
    struct Member {
        ElementIndex element{};
        std::uint32_t island = 0;
    };
    std::vector<std::vector<Member>> members;  ///< [states]

    /// Island of an element at a state, or inNoIsland.
    std::uint32_t islandOf(std::size_t state, ElementIndex element) const;
};

/// Finds the islands of every state by the rule of Supports and follows them through the states. Reads each FE state once.
/// @param activity  under the revival policy
/// Throws Cancelled.
LooseStructure looseStructure(const FeResult& fe, const Activity& activity, const SiteSurface& ground, const Execution& execution);

/// Some element is loose at a state and still active at the next. Looks from the last state backwards and reads no more states than
/// it needs.
bool comesLoose(const FeResult& fe, const Activity& activity, const SiteSurface& ground);

/// The state at which most elements are loose and live on to the next: what an engine that moves them has to move at one time.
struct LooseAtOnce {
    double time = 0.0;          ///< s
    std::int64_t islands = 0;   ///< that live on there, in whole or in part
    std::int64_t elements = 0;  ///< of those; 0: nothing ever comes loose that lives on
};

/// As comesLoose(), but counted. Reads each FE state once and keeps none. Throws Cancelled.
LooseAtOnce mostLooseAtOnce(const FeResult& fe, const Activity& activity, const SiteSurface& ground, const Execution& execution);

/// One island for people: how much of it there was and how long until it died.
struct IslandFate {
    std::uint32_t island = 0;  ///< index in LooseStructure
    double from = 0.0;         ///< s
    double to = 0.0;           ///< s
    std::int64_t elements = 0;
    double mass = 0.0;           ///< kg, when it came loose; elements of unknown density left out
    std::int64_t died = 0;       ///< of its elements, while it was loose
    double medianSeconds = 0.0;  ///< s, from when it came loose to the last active state of those that died; NaN if none did
};

/// Figures over all islands.
struct LooseAccount {
    std::vector<IslandFate> islands;  ///< the heaviest first
    std::int64_t dead = 0;            ///< elements that die
    std::int64_t deadLoose = 0;       ///< of these, in a loose island at their last active state
    double median = 0.0;              ///< s that those had been loose; this and the next two NaN where none were
    double tenth = 0.0;               ///< s, 10 % of them shorter
    double ninetieth = 0.0;           ///< s, 90 % of them shorter
    std::int64_t largeAtOnce = 0;     ///< islands of at least 50 elements at one state, at most
    double largeMean = 0.0;           ///< the same, mean over the states that have any island
    std::int64_t looseAtOnce = 0;     ///< loose elements at one state, at most
};

LooseAccount accountOf(const LooseStructure& loose, const FeResult& fe, const Activity& activity, const Components& components);

}  // namespace rubble
