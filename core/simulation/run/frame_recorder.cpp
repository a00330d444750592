#include "core/simulation/run/frame_recorder.h"

#include <array>

#include "core/simulation/health/value_archive.h"

namespace rubble {

void FrameRecorder::keep(Archive& archive) {
    archive(m_last, m_due, m_frames, m_hasher, m_held);
}

void FrameRecorder::commit(const RigidWorld& world, double time, FrameKind kind) {
    TrajectoryFrame frame;
    frame.time = time;
    frame.kind = kind;
    const std::size_t count = world.bodyCount();
    frame.positions.reserve(count);
    frame.orientations.reserve(count);
    frame.speeds.reserve(count);
    frame.states.reserve(count);
    m_hasher.value(time).value(static_cast<std::uint64_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const auto held = m_held.find(idAt<BodyId>(i));
        const BodyMotion motion = held != m_held.end() ? held->second : world.motion(idAt<BodyId>(i));
        const Vec3& p = motion.pose.position;
        const Quat& q = motion.pose.orientation;
        const std::array<double, 7> exact{p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
        m_hasher.bytes(exact.data(), sizeof exact);
        frame.positions.push_back(p.cast<float>());
        frame.orientations.push_back(q.cast<float>());
        frame.states.push_back(world.state(idAt<BodyId>(i)));
        frame.speeds.push_back(frame.states.back() == BodyState::Removed ? 0.0f : static_cast<float>(motion.velocity.norm()));
    }
    m_sink.commit(frame);
    m_last = time;
    if (due(time)) {
        m_due += m_interval;
        if (due(time)) {
            m_due = time + m_interval;
        }
    }
    ++m_frames;
}

}  // namespace rubble
