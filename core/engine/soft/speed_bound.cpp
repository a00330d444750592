#include "core/engine/soft/speed_bound.h"

#include <algorithm>
#include <cmath>

#include "core/engine/world/constants.h"

namespace rubble {

void SpeedBound::begin(std::size_t slots, std::size_t movable) {
    m_movable = movable;
    m_inverse.assign(slots, 0.0);
    m_own.assign(slots, 0.0);
    m_reach.assign(slots, 0.0);
}

void SpeedBound::set(std::size_t slot, double inverseMass, double speed) {
    m_inverse[slot] = inverseMass;
    m_own[slot] = m_reach[slot] = speed;
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

/// m/s that a far lighter body gets to by what strikes it. Seen from the point that strikes, it slides on as it came, and parts no
/// faster than it parts by now, bounces (Newton) or is pushed out. What strikes it may have got faster in the step itself.
double SpeedBound::struckBy(std::uint32_t from, std::uint32_t to, bool fromA, const ContactConstraint& contact, std::size_t points,
                            std::span<const SolverBody> bodies) const {
    const Vec3 away = fromA ? contact.normal : Vec3(-contact.normal);
    double struck = 0.0;
    for (const SolverPoint& point : std::span(contact.points).first(points)) {
        const Vec3 strikes = bodies[from].velocity + bodies[from].spin.cross(fromA ? point.fromA : point.fromB);
        const Vec3 seen = bodies[to].velocity - strikes;
        const double parting = seen.dot(away);
        const double parts = std::max({parting, -contact.restitution * parting, pushOutSpeed});
        struck = std::max(struck, strikes.norm() + std::sqrt((seen - parting * away).squaredNorm() + parts * parts));
    }
    return struck + (1.0 + contact.restitution) * (m_reach[from] - m_own[from]);
}

std::pair<double, double> SpeedBound::struck(const SlotPair& ends, const ContactConstraint& contact, std::size_t points,
                                             std::span<const SolverBody> bodies) const {
    const std::size_t still = m_reach.size() - 1;
    const auto of = [&](std::uint32_t to, std::uint32_t from, bool fromA) {
        const bool farLighter = to < m_movable && from != still && m_inverse[to] > mostMassRatio * m_inverse[from];
        return farLighter ? struckBy(from, to, fromA, contact, points, bodies) : 0.0;
    };
    return {of(ends.first, ends.second, false), of(ends.second, ends.first, true)};
}

std::vector<double> SpeedBound::bounds(std::span<const SlotPair> ends, std::span<const std::pair<double, double>> struck,
                                       double fall) const {
    std::vector<double> most(m_movable, 0.0);
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const auto take = [&](std::uint32_t slot, double speed) {
            if (speed > 0.0) {
                most[slot] = std::max(most[slot], speed);
            }
        };
        take(ends[k].first, struck[k].first);
        take(ends[k].second, struck[k].second);
    }
    for (std::size_t i = 0; i < m_movable; ++i) {
        most[i] = (most[i] > 0.0 ? most[i] : 2.0 * m_reach[i] + pushOutSpeed) + fall;
    }
    return most;
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
