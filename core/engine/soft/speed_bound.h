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

    /// m/s that each body that moves may get to where contacts act on it.
    /// @param ends      [contacts] the slots that each is between
    /// @param contacts  beside them
    /// @param points    of the contacts
    /// @param bodies    [slots] with their velocities
    /// @param fall      m/s, that gravity adds in the step, at most
    std::vector<double> find(std::span<const SlotPair> ends, std::span<const SolverContact> contacts,
                             std::span<const SolverPoint> points, std::span<const SolverBody> bodies, double fall);
    /// Slows a body down to its bound, if contacts act on it; true: it was too fast.
    static bool holdBack(SolverBody& body);

private:
    void spread(std::span<const SlotPair> ends);
    double struckBy(std::uint32_t from, std::uint32_t to, bool fromA, const SolverContact& contact,
                    std::span<const SolverPoint> points, std::span<const SolverBody> bodies) const;

    std::size_t m_movable = 0;
    std::vector<double> m_inverse;  ///< 1/kg, [slots], as the solver takes it
    std::vector<double> m_own;      ///< m/s, [slots] of its farthest corner
    std::vector<double> m_reach;    ///< m/s, [slots] that its corners may get to
};

}  // namespace rubble
