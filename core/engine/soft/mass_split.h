#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/engine/soft/lanes/soft_lanes.h"

namespace rubble {

/// A body that the passes see as several, each with its share of the mass and of the inertia.
struct SplitBody {
    std::uint32_t slot = 0;       ///< of the body; its first copy has the same
    std::uint32_t firstCopy = 0;  ///< slot of the second copy; the others follow
    std::uint32_t copies = 1;     ///< with the first
};

/// Bodies that so many contacts act on that these cannot go side by side: no two contacts of a group may move the same body. Copies
/// take the contacts in turn; after each pass all get the mean of their velocities, which keeps momentum. Tonge, Benevolenski &
/// Voroshilov 2012, Mass splitting for jitter-free parallel rigid body simulation.
class MassSplit {
public:
    /// Splits what has too many contacts and gives each of these its copy.
    /// @param ends     [contacts] slots that each is between; those that do not move get slots behind the copies
    /// @param movable  slots below this one move
    void split(std::span<std::pair<std::uint32_t, std::uint32_t>> ends, std::size_t movable);
    void clear();

    std::span<const SplitBody> bodies() const { return m_bodies; }
    /// Slots that the copies take, behind those that move.
    std::uint32_t added() const { return m_added; }

private:
    std::vector<SplitBody> m_bodies;
    std::uint32_t m_added = 0;
};

/// Calls visit(body, copy) with the slots of each split body and of each of its copies but the first.
template <class Visit>
void forEachCopy(std::span<const SplitBody> split, Visit visit) {
    for (const SplitBody& body : split) {
        for (std::uint32_t k = 0; k + 1 < body.copies; ++k) {
            visit(body.slot, body.firstCopy + k);
        }
    }
}
/// What contacts did to one copy they did to its share of the body: all get the mean velocity and spin.
/// @param bodies  [copies]
void joinVelocities(std::span<const SplitBody> split, std::span<LaneBody> bodies);
/// The same of ways by position only.
void joinWays(std::span<const SplitBody> split, std::span<LaneWay> ways);

}  // namespace rubble
