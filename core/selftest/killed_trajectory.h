#pragma once

#include "core/base/execution.h"
#include "core/trajectory/trajectory.h"

namespace rubble::selftest {

/// Stops a run after so many frames, as a kill would, and keeps what was committed.
class KilledTrajectory : public MemoryTrajectory {
public:
    KilledTrajectory(const Execution& execution, std::size_t frames) : m_execution(execution), m_frames(frames) {}
    void commit(const TrajectoryFrame& frame) override {
        MemoryTrajectory::commit(frame);
        if (frameCount() >= m_frames) {
            m_execution.cancel();
        }
    }

private:
    const Execution& m_execution;
    std::size_t m_frames;
};

}  // namespace rubble::selftest
