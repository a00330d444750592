#include "core/validation/watched_world.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

Pose between(const Pose& a, const Pose& b, double share) {
    return {a.position + share * (b.position - a.position), a.orientation.slerp(share, b.orientation)};
}

}  // namespace

WatchedWorld::WatchedWorld(std::unique_ptr<RigidWorld> world, double begin, TraceRequest request, std::vector<BodyTrace>& traces)
    : ForwardingWorld(std::move(world)), m_time(begin), m_request(std::move(request)), m_traces(traces) {}

BodyId WatchedWorld::addBody(const NewBody& body) {
    const BodyId id = world().addBody(body);
    BodyTrace trace;
    trace.from = trace.movedLast = m_time;
    trace.start = trace.latest = body.pose;
    trace.topSpeed = body.velocity.norm();
    if (m_request.samplesPerSecond > 0.0) {
        trace.points.push_back({m_time, body.pose, trace.topSpeed});
    }
    m_traces.push_back(std::move(trace));
    return id;
}

void WatchedWorld::step(double dt) {
    world().step(dt);
    const double before = m_time;
    m_time += dt;
    for (std::size_t i = 0; i < m_traces.size(); ++i) {
        follow(i, before);
    }
}

void WatchedWorld::follow(std::size_t i, double before) {
    const BodyId id = idAt<BodyId>(i);
    const BodyState now = state(id);
    BodyTrace& trace = m_traces[i];
    if (now == BodyState::Removed) {
        return;
    }
    const BodyMotion moved = motion(id);
    const double speed = moved.velocity.norm();
    if (!moved.pose.position.allFinite() || !std::isfinite(speed)) {
        return;
    }
    sample(trace, i, before, moved.pose, speed);
    if (now == BodyState::Awake) {
        trace.path += (moved.pose.position - trace.latest.position).norm();
        trace.topSpeed = std::max(trace.topSpeed, speed);
        trace.movedLast = m_time;
        const bool touches = penetration(id) > 0.0;
        trace.contacts += touches && !trace.touching;
        trace.touching = touches;
    }
    trace.latest = moved.pose;
}

void WatchedWorld::sample(BodyTrace& trace, std::size_t i, double before, const Pose& now, double speed) const {
    const auto placeAt = [&](double time) { return between(trace.latest, now, (time - before) / (m_time - before)); };
    if (i < m_request.asked.size()) {
        const double wanted = trace.from + m_request.asked[i];
        if (wanted > before && wanted <= m_time) {
            trace.asked = placeAt(wanted);
        }
    }
    if (m_request.samplesPerSecond > 0.0) {
        // Counted from the entry: a sum of intervals would drift.
        for (double next = trace.from + static_cast<double>(trace.points.size()) / m_request.samplesPerSecond; next <= m_time;
             next = trace.from + static_cast<double>(trace.points.size()) / m_request.samplesPerSecond) {
            trace.points.push_back({next, placeAt(next), speed});
        }
    }
}

}  // namespace rubble
