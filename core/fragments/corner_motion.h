#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/ids.h"
#include "core/fe/activity.h"
#include "core/fe/fe_result.h"
#include "core/fragments/consistent_mass.h"
#include "core/fragments/lifetimes.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// Positions and velocities of the corners of an element at the end of a lifetime, one column a corner.
struct CornerMotion {
    Corners positions = Corners::Zero();   ///< m
    Corners velocities = Corners::Zero();  ///< m/s
    bool finite = true;                    ///< all positions are numbers
    int corners = 0;
    int known = 0;  ///< corners whose velocity is known; the others move with the mean of those, or rest where there is none
};

/// Reads corner motions from the last three states of an FE result. Velocities come from the file; where it has none, from
/// differences of positions at states at which the element was active: of second order over its last three, of first order over its
/// last two. Positions after its death are never looked at. An element that was active at one state only takes the velocity of
/// those of its nodes that another element held at the state before as well; at the first state there is nothing to take.
class CornerMotionReader {
public:
    CornerMotionReader(const FeResult& fe, Revival policy);

    /// Which states advance() has to be called for, so that motionOf() knows what it needs for each of these lifetimes [states].
    std::vector<bool> statesNeeded(const std::vector<Lifetime>& lifetimes) const;
    /// Reads the next state needed; they come in ascending order.
    void advance(std::uint32_t state);
    /// Motion at the lifetime's lastActive, which must be the state read last.
    CornerMotion motionOf(const Lifetime& life);

private:
    struct Read {
        std::uint32_t state = 0;
        std::shared_ptr<const FeState> fields;
    };
    const FeState* fieldsOf(std::uint32_t state) const;
    Vec3 velocityOf(std::uint32_t node, const Lifetime& life);
    Vec3 differenceOf(std::uint32_t node, std::uint32_t state, bool secondOrder) const;
    bool heldBefore(std::uint32_t node, std::uint32_t state);

    const FeResult& m_fe;
    Revival m_policy;
    std::array<Read, 3> m_reads;    ///< newest first
    Activity m_activity;            ///< under the policy; made when first needed
    std::vector<bool> m_held;       ///< nodes held by one element at m_heldState and the state before
    std::uint32_t m_heldState = 0;  ///< 0: m_held is not made yet
};

/// Derivative at the newest of three points of the parabola through them.
/// @param newest, middle, oldest  values at t, t - recent and t - recent - former
Vec3 backwardDerivative(const Vec3& newest, const Vec3& middle, const Vec3& oldest, double recent, double former);

}  // namespace rubble
