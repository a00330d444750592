#include "core/analysis/accuracy/world_pool.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <numeric>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/simulation/run/checkpoint.h"

namespace rubble {

namespace {

/// How often the calling thread looks for a cancel and reports.
constexpr std::chrono::milliseconds lookEvery{50};

/// The pieces of work, their threads and how far each is.
class Pool {
public:
    Pool(std::size_t count, int threadsEach, std::vector<double> weights,
         const std::function<void(std::size_t, const Execution&)>& work)
        : m_work(work), m_weights(std::move(weights)), m_fractions(count, 0.0), m_errors(count) {
        m_weights.resize(count, 1.0);
        m_allWeight = std::accumulate(m_weights.begin(), m_weights.end(), 0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const Execution own([this, i](const Progress& progress) {
                const std::scoped_lock lock(m_mutex);
                noteResumed(progress.stage);
                // What prepares a world is next to nothing of it, though it is soon through.
                if (progress.stage.id == simulatingStage) {
                    m_fractions[i] = std::max(m_fractions[i], std::clamp(progress.fraction, 0.0, 0.999));
                }
            });
            m_executions.push_back(own.withThreads(threadsEach));
        }
    }

    void run(std::size_t threads, const Message& stage, const Execution& execution) {
        std::vector<std::jthread> workers;
        m_working = threads;
        for (std::size_t t = 0; t < threads; ++t) {
            workers.emplace_back([this, &execution] { workLoop(execution); });
        }
        const std::exception_ptr reporting = watch(stage, execution);
        workers.clear();
        if (reporting) {
            std::rethrow_exception(reporting);
        }
        for (const std::exception_ptr& error : m_errors) {
            if (error) {
                std::rethrow_exception(error);
            }
        }
        execution.report(stage, 1.0);
    }

private:
    /// A world that went on from a checkpoint is said for as long as the pool works, from now on.
    void noteResumed(const Message& stage) {
        if (stage.id == resumedStage) {
            m_changed.notify_all();
            m_resumed = {"analysis.resumed",
                         "simulating {0} worlds; {1} went on from checkpoints, the latest at {2}",
                         {m_fractions.size(), ++m_resumedCount, stage.arguments.front()}};
        }
    }

    void workLoop(const Execution& whole) {
        for (;;) {
            std::size_t i = 0;
            {
                const std::scoped_lock lock(m_mutex);
                // The watcher looks now and then only; no piece begins after a cancel.
                if (m_stopped || whole.cancelled() || m_next == m_executions.size()) {
                    --m_working;
                    m_changed.notify_all();
                    return;
                }
                i = m_next++;
            }
            try {
                m_work(i, m_executions[i]);
            } catch (const Cancelled&) {
                // Only the watcher cancels; it tells the caller.
            } catch (...) {
                const std::scoped_lock lock(m_mutex);
                m_errors[i] = std::current_exception();
                stop();
            }
            const std::scoped_lock lock(m_mutex);
            m_fractions[i] = 1.0;
        }
    }

    void stop() {
        m_stopped = true;
        for (const Execution& execution : m_executions) {
            execution.cancel();
        }
    }

    /// Until all threads have ended. Returns what the listener of the execution threw, if it did.
    std::exception_ptr watch(const Message& stage, const Execution& execution) {
        std::exception_ptr thrown;
        std::unique_lock lock(m_mutex);
        while (m_working > 0) {
            m_changed.wait_for(lock, lookEvery);
            if (execution.cancelled() || thrown) {
                stop();
                continue;
            }
            double done = 0.0;
            for (std::size_t i = 0; i < m_fractions.size(); ++i) {
                done += m_weights[i] * m_fractions[i];
            }
            const Message said = m_resumedCount > 0 ? m_resumed : stage;
            lock.unlock();
            try {
                execution.report(said, done / m_allWeight);
            } catch (const Cancelled&) {
                // Seen again at the top of the loop.
            } catch (...) {
                thrown = std::current_exception();
            }
            lock.lock();
        }
        return thrown;
    }

    const std::function<void(std::size_t, const Execution&)>& m_work;
    std::vector<Execution> m_executions;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<double> m_weights;
    double m_allWeight = 1.0;
    std::vector<double> m_fractions;
    std::vector<std::exception_ptr> m_errors;
    Message m_resumed;
    std::int64_t m_resumedCount = 0;
    std::size_t m_next = 0;
    std::size_t m_working = 0;
    bool m_stopped = false;
};

}  // namespace

void runInParallel(std::size_t count, const PoolShare& share, const Message& stage, const Execution& execution,
                   const std::function<void(std::size_t, const Execution&)>& work) {
    assert(share.weights.empty() || share.weights.size() == count);
    execution.check();
    if (count == 0) {
        return;
    }
    const std::size_t granted = static_cast<std::size_t>(std::max(1, share.threads > 0 ? share.threads : execution.threads()));
    const std::size_t atOnce = share.atOnce > 0 ? static_cast<std::size_t>(share.atOnce) : granted;
    const std::size_t workers = std::min(atOnce, count);
    const int threadsEach = static_cast<int>(std::max<std::size_t>(1, granted / workers));
    Pool(count, threadsEach, share.weights, work).run(workers, stage, execution);
}

}  // namespace rubble
