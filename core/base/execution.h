#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "core/base/message.h"

namespace rubble {

/// How far a piece of work is.
struct Progress {
    Message stage;          ///< what is being done
    double fraction = 0.0;  ///< [0, 1] of this stage
};

/// What long work needs from its caller: a place to report progress, and a sticky cancel flag. Cheap to copy; copies share the
/// flag. progress is called on the worker's thread, at most about 20 times a second.
class Execution {
public:
    using Listener = std::function<void(const Progress&)>;

    explicit Execution(Listener listener = {});

    /// How many threads one piece of work may use; all there are unless withThreads() said otherwise. No result depends on it.
    int threads() const { return m_threads; }
    /// The same execution for work that shares the machine with other work.
    Execution withThreads(int threads) const;

    void cancel() const { m_shared->cancelled.store(true); }
    bool cancelled() const { return m_shared->cancelled.load(std::memory_order_relaxed); }
    /// Throws Cancelled once cancel() has been called.
    void check() const;
    /// Reports progress (thinned out by time; fractions 0 and 1 always pass) and then checks for cancel.
    void report(const Message& stage, double fraction) const;

private:
    struct Shared {
        std::atomic<bool> cancelled{false};
        std::atomic<std::int64_t> lastReport{0};
        Listener listener;
    };
    std::shared_ptr<Shared> m_shared;
    int m_threads;
};

}  // namespace rubble
