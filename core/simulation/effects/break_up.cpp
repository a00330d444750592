#include "core/simulation/effects/break_up.h"

#include <algorithm>

#include "core/fe/material.h"
#include "core/trajectory/record_archive.h"

namespace rubble {

BreakUp::BreakUp(const RunDescription& description)
    : m_description(description),
      m_threshold(description.scenario.effects.breakUpSpeed),
      m_gravity(description.scenario.simulation.gravity) {}

void BreakUp::entered(std::span<const BodyRecord> bodies, RigidWorld& world) {
    for (const BodyRecord& record : bodies) {
        m_candidateOf.resize(std::max(m_candidateOf.size(), at(record.body) + 1), -1);
        if (record.isIsland()) {
            continue;
        }
        const Cluster& cluster = m_description.clustering->list[at(record.cluster)];
        const Component& component = m_description.components->list[at(cluster.component)];
        // What a cluster has fallen into is one fragment each.
        const bool whole = record.from <= cluster.handOverTime;
        // The elements of a body of a table are no pieces that it could break into.
        const bool ofPieces = cluster.memberCount > 1 && !m_description.fe->contents().looseBodies;
        if (whole && ofPieces && fallsApart(component.material) && !component.reinforced) {
            m_candidateOf[at(record.body)] = static_cast<std::int32_t>(m_candidates.size());
            m_candidates.push_back(
                {record, std::int64_t{cluster.memberCount} - 1, world.motion(record.body).velocity, Vec3::Zero(), Vec3::Zero()});
        }
    }
}

void BreakUp::leaving(BodyId body) {
    if (at(body) >= m_candidateOf.size() || m_candidateOf[at(body)] < 0) {
        return;
    }
    const auto gone = static_cast<std::size_t>(m_candidateOf[at(body)]);
    m_candidateOf[at(body)] = -1;
    m_candidates.erase(m_candidates.begin() + static_cast<std::ptrdiff_t>(gone));
    for (std::size_t i = gone; i < m_candidates.size(); ++i) {
        m_candidateOf[at(m_candidates[i].record.body)] = static_cast<std::int32_t>(i);
    }
}

void BreakUp::Candidate::keep(Archive& archive) {
    archive(record, more, velocity, change, excused);
}

void BreakUp::keep(Archive& archive) {
    archive(m_candidates, m_candidateOf, m_broken, m_held);
}

void BreakUp::excuse(BodyId body, const Vec3& change) {
    if (at(body) < m_candidateOf.size() && m_candidateOf[at(body)] >= 0) {
        m_candidates[static_cast<std::size_t>(m_candidateOf[at(body)])].excused += change;
    }
}

std::vector<BodyRecord> BreakUp::brokenBy(const RigidWorld& world, double dt, std::int64_t& room) {
    const Vec3 fall(0.0, 0.0, -m_gravity * dt);
    std::vector<BodyRecord> broken;
    for (Candidate& candidate : m_candidates) {
        const Vec3 now = world.motion(candidate.record.body).velocity;
        const Vec3 change = now - candidate.velocity - fall - candidate.excused;
        // A hit may be spread over two steps, in one of which, about, what it lies on carries its weight.
        const double hit = (candidate.change + change).norm() - m_gravity * dt;
        candidate.velocity = now;
        candidate.change = change;
        candidate.excused = Vec3::Zero();
        if (hit <= m_threshold) {
            continue;
        }
        if (candidate.more > room) {
            ++m_held;
            continue;
        }
        room -= candidate.more;
        broken.push_back(candidate.record);
    }
    return broken;
}

std::optional<std::vector<FreedFragment>> freeFragments(const RunDescription& description, const BodyRecord& record,
                                                        std::span<const Carrier> carried, const BodyMotion& motion) {
    const Quat turn = motion.pose.orientation * record.inFe.orientation.conjugate();
    std::vector<FreedFragment> freed;
    for (const Carrier& carrier : carried) {
        const FragmentId f = carrier.fragment;
        std::optional<NewBody> body = bodyOfFragment(description, f);
        if (!body) {
            return std::nullopt;
        }
        const Pose atHandOver = body->pose;
        const Quat inverse = atHandOver.orientation.conjugate();
        body->pose.position = motion.pose.position + turn * (atHandOver.position - record.inFe.position);
        body->pose.orientation = (turn * atHandOver.orientation).normalized();
        body->velocity = motion.velocity + motion.angularVelocity.cross(body->pose.position - motion.pose.position);
        body->angularVelocity = motion.angularVelocity;
        freed.push_back({*body, f, {-(inverse * atHandOver.position), inverse}});
    }
    return freed;
}

}  // namespace rubble
