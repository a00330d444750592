#include "core/fragments/corner_motion.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace rubble {

namespace {

const Vec3 unknownVelocity = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

/// Corners without a velocity move with the mean of those that have one.
void completeVelocities(CornerMotion& motion) {
    Vec3 sum = Vec3::Zero();
    for (int a = 0; a < motion.corners; ++a) {
        if (motion.velocities.col(a).allFinite()) {
            sum += motion.velocities.col(a);
            ++motion.known;
        }
    }
    if (motion.known < motion.corners) {
        const Vec3 mean = motion.known > 0 ? Vec3(sum / motion.known) : Vec3::Zero();
        for (int a = 0; a < motion.corners; ++a) {
            if (!motion.velocities.col(a).allFinite()) {
                motion.velocities.col(a) = mean;
            }
        }
    }
}

}  // namespace

Vec3 backwardDerivative(const Vec3& newest, const Vec3& middle, const Vec3& oldest, double recent, double former) {
    const Vec3 recentSlope = (newest - middle) / recent;
    const Vec3 formerSlope = (middle - oldest) / former;
    return recentSlope + (recentSlope - formerSlope) * (recent / (recent + former));
}

CornerMotionReader::CornerMotionReader(const FeResult& fe, Revival policy) : m_fe(fe), m_policy(policy) {}

std::vector<bool> CornerMotionReader::statesNeeded(const std::vector<Lifetime>& lifetimes) const {
    std::vector<bool> needed(m_fe.stateCount(), false);
    for (const Lifetime& life : lifetimes) {
        const std::uint32_t last = life.lastActive;
        needed[last] = true;
        if (!m_fe.contents().hasVelocity && last > 0) {
            needed[last - 1] = true;
            if (last >= life.firstActive + 2) {
                needed[last - 2] = true;
            }
        }
    }
    return needed;
}

void CornerMotionReader::advance(std::uint32_t state) {
    assert(!m_reads[0].fields || m_reads[0].state < state);
    m_reads[2] = std::move(m_reads[1]);
    m_reads[1] = std::move(m_reads[0]);
    m_reads[0] = {state, m_fe.state(state)};
    assert(m_reads[0].fields->positions.size() == m_fe.mesh().nodeCount());
}

const FeState* CornerMotionReader::fieldsOf(std::uint32_t state) const {
    for (const Read& read : m_reads) {
        if (read.fields && read.state == state) {
            return read.fields.get();
        }
    }
    return nullptr;
}

CornerMotion CornerMotionReader::motionOf(const Lifetime& life) {
    const FeState* now = fieldsOf(life.lastActive);
    assert(now);
    CornerMotion motion;
    for (const std::uint32_t node : m_fe.mesh().cornersOf(life.element)) {
        motion.positions.col(motion.corners) = now->positions[node];
        motion.finite = motion.finite && now->positions[node].allFinite();
        motion.velocities.col(motion.corners) = velocityOf(node, life);
        ++motion.corners;
    }
    completeVelocities(motion);
    return motion;
}

Vec3 CornerMotionReader::velocityOf(std::uint32_t node, const Lifetime& life) {
    const std::uint32_t state = life.lastActive;
    if (m_fe.contents().hasVelocity) {
        const FeState* now = fieldsOf(state);
        return now->velocities.empty() ? unknownVelocity : now->velocities[node];
    }
    if (state >= life.firstActive + 2) {
        const Vec3 velocity = differenceOf(node, state, true);
        return velocity.allFinite() ? velocity : differenceOf(node, state, false);
    }
    if (state == life.firstActive + 1 || (state > 0 && heldBefore(node, state))) {
        return differenceOf(node, state, false);
    }
    return unknownVelocity;
}

Vec3 CornerMotionReader::differenceOf(std::uint32_t node, std::uint32_t state, bool secondOrder) const {
    const std::vector<double>& times = m_fe.times();
    const Vec3& now = fieldsOf(state)->positions[node];
    const Vec3& before = fieldsOf(state - 1)->positions[node];
    const double recent = times[state] - times[state - 1];
    if (!secondOrder) {
        return (now - before) / recent;
    }
    return backwardDerivative(now, before, fieldsOf(state - 2)->positions[node], recent, times[state - 1] - times[state - 2]);
}

bool CornerMotionReader::heldBefore(std::uint32_t node, std::uint32_t state) {
    if (m_activity.states() == 0) {
        m_activity = activityUnder(m_fe.activity(), m_policy);
    }
    if (m_heldState != state) {
        const Mesh& mesh = m_fe.mesh();
        m_held.assign(mesh.nodeCount(), false);
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            const auto element = idAt<ElementIndex>(e);
            if (m_activity.active(state, element) && m_activity.active(state - 1, element)) {
                for (const std::uint32_t corner : mesh.cornersOf(element)) {
                    m_held[corner] = true;
                }
            }
        }
        m_heldState = state;
    }
    return m_held[node];
}

}  // namespace rubble
