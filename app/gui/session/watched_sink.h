#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "core/base/execution.h"
#include "core/trajectory/sink_relay.h"

namespace rubble {

/// Keeps the pace of live mode: one frame for each frame time of the collapse, handed on no sooner than the wall clock has got to
/// it, and no more than one frame ahead of what is on the screen. Shared by the worker, which waits, and the window, which
/// acknowledges.
class LivePace {
public:
    /// @param rate  live frames per second of collapse: the target
    explicit LivePace(double rate) : m_interval(1.0 / rate) {}

    /// On the worker: whether a recorded frame is the next live one. FE states are recorded too, between live frames.
    bool isNext(double time);
    /// On the worker: waits until the frame before this one is on the screen and the wall clock has got to `time` [s of the run].
    /// Returns early on cancel, and after half a second if the window shows nothing (it may be hidden).
    void waitFor(double time, const Execution& execution);
    /// On the GUI thread: a frame of this time is on the screen.
    void shown(double time);

private:
    using Clock = std::chrono::steady_clock;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    double m_interval;
    std::optional<double> m_last;
    std::int64_t m_lastIndex = -1;
    double m_shown = -std::numeric_limits<double>::infinity();
    double m_firstTime = 0.0;
    Clock::time_point m_start;
};

/// Hands a run on to another sink, tells how it grows, and keeps the pace of live mode if there is one.
class WatchedSink : public SinkRelay {
public:
    struct Listener {
        std::function<void(const RunDescription&)> begun;       ///< after the inner sink has begun
        std::function<void(double time, bool live)> committed;  ///< after every frame; live: a live frame, to be shown
    };
    WatchedSink(TrajectorySink& inner, Listener listener, std::shared_ptr<LivePace> pace, Execution execution);

    void begin(const RunDescription& description) override;
    void commit(const TrajectoryFrame& frame) override;

private:
    Listener m_listener;
    std::shared_ptr<LivePace> m_pace;
    Execution m_execution;
};

}  // namespace rubble
