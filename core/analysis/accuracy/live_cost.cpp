#include "core/analysis/accuracy/live_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "core/analysis/accuracy/machine_load.h"
#include "core/base/elapsed.h"
#include "core/base/error.h"
#include "core/trajectory/sink_relay.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the drawing thread looks for a cancel while it waits for a frame.
constexpr std::chrono::milliseconds lookEvery{50};

/// Frames recorded for each live one: frames stand at the ends of steps, so that recording at the target itself would give fewer.
constexpr double recordedRate = 2.0;

/// Which frames are live ones: the first of each 1 / target s. FE states are recorded too, between them.
class LiveGrid {
public:
    explicit LiveGrid(double target) : m_target(target) {}
    bool isNext(double time) {
        if (!m_first) {
            m_first = time;
        }
        // A step ends a little before or after its frame's time.
        const auto index = static_cast<std::int64_t>(std::floor((time - *m_first) * m_target + 1e-6));
        if (index <= m_last) {
            return false;
        }
        m_last = index;
        return true;
    }

private:
    double m_target;
    std::optional<double> m_first;
    std::int64_t m_last = -1;
};

/// The newest live frame of a run and nothing else, handed from the thread that simulates to the one that draws. A frame is handed
/// over when the one before has been drawn, so what is drawn never changes meanwhile.
class NewestFrame : public TrajectorySink, public TrajectoryReader {
public:
    explicit NewestFrame(double target) : m_grid(target) {}

    // On the thread that simulates.
    void begin(const RunDescription&) override {}
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override {
        m_newBodies.insert(m_newBodies.end(), bodies.begin(), bodies.end());
        m_newCarriers.insert(m_newCarriers.end(), carriers.begin(), carriers.end());
    }
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow&) override {
        m_newIslands.insert(m_newIslands.end(), islands.begin(), islands.end());
    }
    void commit(const TrajectoryFrame& frame) override {
        if (!m_grid.isNext(frame.time)) {
            return;
        }
        auto kept = std::make_shared<const TrajectoryFrame>(frame);
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return !m_full || m_stopped; });
        if (m_stopped) {
            return;
        }
        m_frame = std::move(kept);
        m_bodies.insert(m_bodies.end(), m_newBodies.begin(), m_newBodies.end());
        m_carriers.insert(m_carriers.end(), m_newCarriers.begin(), m_newCarriers.end());
        m_islands.insert(m_islands.end(), m_newIslands.begin(), m_newIslands.end());
        m_newBodies.clear();
        m_newCarriers.clear();
        m_newIslands.clear();
        m_full = true;
        lock.unlock();
        m_changed.notify_all();
    }
    void addLedger(const LedgerRow&) override {}
    void finish(const SimulationResult&) override {}
    void end(std::exception_ptr error) {
        {
            const std::scoped_lock lock(m_mutex);
            m_ended = true;
            m_error = std::move(error);
        }
        m_changed.notify_all();
    }

    // On the thread that draws.
    /// Waits until there is a frame; false when the run has ended. Throws its error.
    /// @param look  called now and then meanwhile; may throw
    bool wait(const std::function<void()>& look) {
        std::unique_lock lock(m_mutex);
        while (!m_full && !m_ended) {
            m_changed.wait_for(lock, lookEvery);
            look();
        }
        if (!m_full && m_error) {
            std::rethrow_exception(m_error);
        }
        return m_full;
    }
    void drawn() {
        {
            const std::scoped_lock lock(m_mutex);
            m_full = false;
        }
        m_changed.notify_all();
    }
    void stop() {
        {
            const std::scoped_lock lock(m_mutex);
            m_stopped = true;
        }
        m_changed.notify_all();
    }

    std::size_t frameCount() const override { return m_frame ? 1 : 0; }
    double frameTime(std::size_t) const override { return m_frame->time; }
    std::shared_ptr<const TrajectoryFrame> frame(std::size_t) const override { return m_frame; }
    std::vector<BodyRecord> bodies() const override { return ends().first; }
    std::vector<Carrier> carriers() const override { return ends().second; }
    std::vector<IslandRecord> islands() const override { return m_islands; }
    bool complete() const override { return false; }

private:
    std::pair<std::vector<BodyRecord>, std::vector<Carrier>> ends() const {
        std::pair<std::vector<BodyRecord>, std::vector<Carrier>> ended{m_bodies, m_carriers};
        endReplaced(ended.first, ended.second);
        return ended;
    }

    LiveGrid m_grid;
    std::vector<BodyRecord> m_newBodies;
    std::vector<Carrier> m_newCarriers;
    std::vector<IslandRecord> m_newIslands;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_full = false;  ///< a frame is there that has not been drawn
    bool m_ended = false;
    bool m_stopped = false;
    std::exception_ptr m_error;
    std::shared_ptr<const TrajectoryFrame> m_frame;
    std::vector<BodyRecord> m_bodies;
    std::vector<Carrier> m_carriers;
    std::vector<IslandRecord> m_islands;
};

/// First and last birth, s.
std::pair<double, double> birthSpan(const FragmentSet& fragments) {
    std::pair<double, double> span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Fragment& fragment : fragments.list) {
        span.first = std::min(span.first, fragment.birthTime);
        span.second = std::max(span.second, fragment.birthTime);
    }
    return span;
}

LiveRate rateOf(const std::vector<FrameStamp>& frames, const RunDescription& description) {
    const auto [first, last] = birthSpan(*description.fragments);
    return rubble::rateOf(frames, first, last);
}

/// A world that simulates on a thread of its own until this goes out of scope.
class LiveRun {
public:
    LiveRun(RunDescription description, NewestFrame& newest, int threads)
        : m_newest(newest), m_execution(Execution().withThreads(threads)), m_thread([this, run = std::move(description)] {
              std::exception_ptr error;
              try {
                  simulate(run, m_newest, m_execution);
              } catch (const Cancelled&) {
                  // Only the destructor cancels; nobody waits for frames then.
              } catch (...) {
                  error = std::current_exception();
              }
              m_newest.end(error);
          }) {}
    ~LiveRun() {
        m_execution.cancel();
        m_newest.stop();
    }
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

private:
    NewestFrame& m_newest;
    Execution m_execution;
    std::jthread m_thread;
};

Message liveStage() {
    return {"analysis.live", "measuring live frames", {}};
}

}  // namespace

LiveRate rateOf(const std::vector<FrameStamp>& frames, double from, double to) {
    LiveRate rate;
    rate.frames = static_cast<std::int64_t>(frames.size());
    if (frames.size() < 2) {
        return rate;
    }
    const auto within = [&](const FrameStamp& f) { return f.time >= from - 1e-9 && f.time <= to + 1e-9; };
    auto first = std::find_if(frames.begin(), frames.end(), within);
    auto end = std::find_if_not(first, frames.end(), within);
    if (end - first < 2) {
        first = frames.begin();
        end = frames.end();
    }
    const auto perSecond = [](auto a, auto b) { return static_cast<double>(b - a) / std::max(1e-9, b->wall - a->wall); };
    rate.mean = perSecond(first, end - 1);
    // Windows of a second or, where one frame takes longer, of that frame.
    rate.worst = rate.mean;
    auto b = frames.begin();
    for (auto a = frames.begin(); a != frames.end(); ++a) {
        while (b != frames.end() && (b->wall - a->wall < 1.0 || b <= a)) {
            ++b;
        }
        if (b == frames.end()) {
            break;
        }
        rate.worst = std::min(rate.worst, perSecond(a, b));
    }
    return rate;
}

SettingCost timeRun(const RunDescription& description, const Execution& execution) {
    const SimulatedWorld world = simulateDebris(description, execution);
    SettingCost cost;
    cost.wallSeconds = world.wallSeconds;
    cost.stepMeanMs = world.stepMeanMs;
    cost.stepWorstMs = world.stepWorstMs;
    cost.othersShare = world.othersShare;
    cost.threads = execution.threads();
    return cost;
}

LiveRate measureLive(const RunDescription& description, double target, const ScreenMaker& makeScreen, const Execution& execution) {
    const auto newest = std::make_shared<NewestFrame>(target);
    const std::unique_ptr<LiveScreen> screen = makeScreen ? makeScreen(description, newest) : nullptr;
    RunDescription live = description;
    live.scenario.simulation.frameRate = recordedRate * target;
    const double end = description.fe->times().back();
    std::vector<FrameStamp> frames;
    execution.report(liveStage(), 0.0);
    const auto report = [&] {
        const double done = frames.empty() ? 0.0 : (frames.back().time - frames.front().time) / (end - frames.front().time);
        execution.report(liveStage(), std::clamp(done, 0.0, 0.999));
    };
    const Clock::time_point start = Clock::now();
    const MachineLoad load;
    double othersShare = 0.0;
    {
        const LiveRun run(std::move(live), *newest, execution.threads());
        while (newest->wait(report)) {
            const double time = newest->frameTime(0);
            if (screen) {
                screen->draw(time);
            }
            frames.push_back({time, secondsSince(start)});
            newest->drawn();
            if (time >= end) {
                break;
            }
            report();
        }
        othersShare = load.othersShare();
    }
    execution.report(liveStage(), 1.0);
    LiveRate rate = rateOf(frames, description);
    rate.othersShare = othersShare;
    return rate;
}

LiveRate measureDrawing(const RunDescription& description, const std::shared_ptr<const TrajectoryReader>& run, double target,
                        const ScreenMaker& makeScreen, const Execution& execution) {
    const std::unique_ptr<LiveScreen> screen = makeScreen(description, run);
    LiveGrid grid(target);
    std::vector<FrameStamp> frames;
    const Clock::time_point start = Clock::now();
    for (std::size_t i = 0; i < run->frameCount(); ++i) {
        const double time = run->frameTime(i);
        if (time > description.fe->times().back()) {
            break;
        }
        if (grid.isNext(time)) {
            screen->draw(time);
            frames.push_back({time, secondsSince(start)});
        }
        execution.report({"analysis.drawing", "measuring drawing", {}},
                         static_cast<double>(i) / static_cast<double>(run->frameCount()));
    }
    return rateOf(frames, description);
}

}  // namespace rubble
