#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/fe/fe_result.h"

namespace rubble::render {

/// Where the nodes are at any time: linear between two FE states. A node that no element holds at the later state (its elements die
/// there) flies on with its last velocity instead: files let such nodes freeze or run away.
class NodeMotion {
public:
    explicit NodeMotion(std::shared_ptr<const FeResult> fe);

    /// Moves to a time, s; before the first and after the last state the nodes stand still. Reads at most three states, and only
    /// when the interval changes. Throws what the state source throws.
    void moveTo(double time);

    /// Last state at or before the time of moveTo().
    std::size_t state() const { return m_state; }
    /// True if that time lies between two states.
    bool interpolated() const { return m_share > 0.0f; }
    /// Position of a node at that time, m, single precision.
    Eigen::Vector3f operator[](std::size_t node) const { return m_base[node] + m_share * m_delta[node]; }

private:
    void load(std::size_t state);

    std::shared_ptr<const FeResult> m_fe;
    std::size_t m_state = 0;
    std::size_t m_loaded;  ///< state that m_base and m_delta belong to
    float m_share = 0.0f;
    std::vector<Eigen::Vector3f> m_base;
    std::vector<Eigen::Vector3f> m_delta;  ///< over the whole interval
};

}  // namespace rubble::render
