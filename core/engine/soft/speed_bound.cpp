#include "core/engine/soft/speed_bound.h"

#include <algorithm>

#include "core/engine/world/constants.h"

namespace rubble {

void SpeedBound::begin(std::size_t slots, std::size_t movable) {
    m_movable = movable;
    m_inverse.assign(slots, 0.0);
    m_reach.assign(slots, 0.0);
}

void SpeedBound::set(std::size_t slot, double inverseMass, double speed) {
    m_inverse[slot] = inverseMass;
    m_reach[slot] = speed;
}

/// Hands speeds on from body to body, a few times through the contacts in both directions.
void SpeedBound::spread(std::span<const SlotPair> ends) {
    const auto hand = [&](std::uint32_t from, std::uint32_t to) {
        if (to < m_movable) {
            // Of a blow in the middle, two masses m and M: at most 2 M / (m + M) of the speed.
            const double share = std::min(1.0, 2.0 * m_inverse[to] / (m_inverse[to] + m_inverse[from]));
            m_reach[to] = std::max(m_reach[to], share * m_reach[from]);
        }
    };
    const auto between = [&](const SlotPair& pair) {
        hand(pair.first, pair.second);
        hand(pair.second, pair.first);
    };
    for (int sweep = 0; sweep < 2; ++sweep) {
        std::for_each(ends.begin(), ends.end(), between);
        std::for_each(ends.rbegin(), ends.rend(), between);
    }
}

std::vector<double> SpeedBound::find(std::span<const SlotPair> ends, std::span<const SolverContact> contacts,
                                     std::span<const SolverBody> bodies, double fall) {
    spread(ends);
    const std::size_t still = m_reach.size() - 1;
    std::vector<double> struck(m_movable, 0.0);  // what is far lighter than what it meets
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const auto [a, b] = ends[k];
        for (const auto& [to, from] : {SlotPair{a, b}, SlotPair{b, a}}) {
            if (to < m_movable && from != still && m_inverse[to] > mostMassRatio * m_inverse[from]) {
                // Seen from what strikes it, it leaves no faster than it came.
                const Vec3& strikes = bodies[from].velocity;
                const double own = strikes.norm();
                struck[to] = std::max(struck[to], own + (bodies[to].velocity - strikes).norm() +
                                                      (1.0 + contacts[k].restitution) * std::max(0.0, m_reach[from] - own));
            }
        }
    }
    std::vector<double> bounds(m_movable);
    for (std::size_t i = 0; i < m_movable; ++i) {
        bounds[i] = (struck[i] > 0.0 ? struck[i] : 2.0 * m_reach[i]) + pushOutSpeed + fall;
    }
    return bounds;
}

bool SpeedBound::holdBack(SolverBody& body) {
    if (!body.active) {
        return false;
    }
    const double speed = body.velocity.norm();
    const double turning = body.spin.norm() * body.radius;
    if (speed > body.fastest) {
        body.velocity *= body.fastest / speed;
    }
    if (turning > body.fastest) {
        body.spin *= body.fastest / turning;
    }
    return speed > body.fastest || turning > body.fastest;
}

}  // namespace rubble
