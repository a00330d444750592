#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/fe/state_read_ahead.h"

namespace rubble::render {

/// s; a view's time that went through text still hits its state.
inline constexpr double sameTime = 1e-6;

/// Where the nodes are at any time: linear between two FE states. A node that no element holds at the later state (its elements die
/// there) flies on with its last velocity instead: files let such nodes freeze or run away.
class NodeMotion {
public:
    /// @param states  may be shared with others that show the same times
    NodeMotion(std::shared_ptr<const FeResult> fe, std::shared_ptr<StateReadAhead> states);

    /// Moves to a time, s; before the first and after the last state the nodes stand still. Throws what the state source throws.
    /// @param exact  between the states next to that time, which are read if need be; else between the nearest that are at hand
    void moveTo(double time, bool exact = true);

    /// Last state at or before the time of moveTo().
    std::size_t state() const { return m_state; }
    /// True if that time lies between two states.
    bool interpolated() const { return m_between; }
    /// States from the one to the other between which nodes move: more than 1 where those next to the time were not at hand.
    std::size_t statesApart() const { return m_interval.to - m_interval.from; }
    /// It was asked for exactly; else nodes may lie otherwise than between the states next to the time.
    bool exact() const { return m_exact; }
    /// Position of a node at that time, m, single precision.
    Eigen::Vector3f operator[](std::size_t node) const;

private:
    /// The nodes that an active element holds at a state, brought from one state to another by the elements that differ.
    class Held {
    public:
        void moveTo(const FeResult& fe, std::size_t state);
        bool operator[](std::size_t node) const { return m_elements[node] != 0; }

    private:
        std::size_t m_state = 0;
        std::vector<std::uint32_t> m_elements;  ///< active ones, by node
    };

    std::shared_ptr<const FeResult> m_fe;
    std::shared_ptr<StateReadAhead> m_states;
    std::size_t m_state = 0;
    bool m_between = false;
    bool m_exact = true;
    StateReadAhead::Interval m_interval;
    Held m_held;
    float m_share = 0.0f;  ///< of the interval that has passed
    double m_step = 0.0;   ///< s, of the interval
    double m_ratio = 0.0;  ///< of the interval to the one before it
};

}  // namespace rubble::render
