#pragma once

#include <limits>
#include <map>

#include "core/base/resumable_hash.h"
#include "core/engine/world/rigid_world.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Makes frames of a world, feeds them to the sink and to the hash of the trajectory.
class FrameRecorder {
public:
    FrameRecorder(TrajectorySink& sink, double frameRate) : m_sink(sink), m_interval(1.0 / frameRate) {}

    /// True when it is time for a frame. Frames follow their own beat, so that their rate holds in the mean whatever the steps.
    bool due(double time) const { return time >= m_due - 1e-9; }
    /// From now on a body is recorded here, whatever the world says: it is no number there.
    void hold(BodyId body, const BodyMotion& motion) { m_held[body] = motion; }
    void commit(const RigidWorld& world, double time, FrameKind kind);
    /// Digest of time, positions and orientations of every committed frame in double precision.
    Digest hash() const { return m_hasher.finish(); }
    double lastTime() const { return m_last; }
    std::int64_t frames() const { return m_frames; }
    void keep(Archive& archive);

private:
    TrajectorySink& m_sink;
    double m_interval;
    double m_last = -std::numeric_limits<double>::infinity();
    double m_due = -std::numeric_limits<double>::infinity();  ///< s
    std::int64_t m_frames = 0;
    ResumableHasher m_hasher;
    std::map<BodyId, BodyMotion> m_held;
};

}  // namespace rubble
