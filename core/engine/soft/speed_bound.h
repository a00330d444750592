#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/engine/soft/soft_solver.h"

namespace rubble {

/// How fast bodies may get in a step. None gets faster than what it touches, directly or through others, could make it: a light
/// body between heavy ones keeps what is left over where their passes have not converged, and would be shot out.
class SpeedBound {
public:
    using SlotPair = std::pair<std::uint32_t, std::uint32_t>;

    /// Begins a step. @param movable  bodies below this one move; the last slot is that of all that is still
    void begin(std::size_t slots, std::size_t movable);
    /// A body that moves, or what moves it. Any number of threads for different ones.
    /// @param inverseMass  1/kg, as the solver takes it; 0: immovable
    /// @param speed        m/s, of its farthest corner
    void set(std::size_t slot, double inverseMass, double speed);
    void setInverseMass(std::size_t slot, double inverseMass) { m_inverse[slot] = inverseMass; }
    double inverseMass(std::size_t slot) const { return m_inverse[slot]; }
    double speed(std::size_t slot) const { return m_reach[slot]; }

    /// Hands speeds on through contacts, whose ends these are.
    void spread(std::span<const SlotPair> ends);
    /// m/s that the two of a contact, of so many points, get to at most by what strikes them, where one is far lighter than the
    /// other; else 0. After speeds were handed on; any number of threads.
    /// @param bodies  [slots] with their velocities
    std::pair<double, double> struck(const SlotPair& ends, const ContactConstraint& contact, std::size_t points,
                                     std::span<const SolverBody> bodies) const;
    /// m/s that each body that moves may get to where contacts act on it.
    /// @param struck  beside the ends
    /// @param fall    m/s, that gravity adds in the step, at most
    std::vector<double> bounds(std::span<const SlotPair> ends, std::span<const std::pair<double, double>> struck,
                               double fall) const;
    /// Slows a body down to its bound, if contacts act on it; true: it was too fast.
    static bool holdBack(SolverBody& body);

private:
    double struckBy(std::uint32_t from, std::uint32_t to, bool fromA, const ContactConstraint& contact, std::size_t points,
                    std::span<const SolverBody> bodies) const;

    std::size_t m_movable = 0;
    std::vector<double> m_inverse;  ///< 1/kg, [slots], as the solver takes it
    std::vector<double> m_own;      ///< m/s, [slots] of its farthest corner
    std::vector<double> m_reach;    ///< m/s, [slots] that its corners may get to
};

}  // namespace rubble
