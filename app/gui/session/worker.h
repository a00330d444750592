#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/execution.h"
#include "widgets/basics/wording.h"

namespace rubble {

/// The one thread that does long work. Jobs run one after another; one that is started replaces a waiting one of its kind and
/// cancels a running one of its kind (latest wins). Lives on the GUI thread.
class Worker : public QObject {
    Q_OBJECT

public:
    /// Kinds of work; a new job supersedes an older one of its kind.
    enum class Kind { Open, Update, Simulate, Reopen, Write, Study };

    struct Job {
        Kind kind;
        /// Runs on the worker's thread.
        std::function<void(const Execution&)> work;
        /// Runs on the GUI thread afterwards, with what the work threw (null: it succeeded). Not called for jobs that never
        /// started, but for queued ones: those that were cancelled while they waited get Cancelled.
        std::function<void(std::exception_ptr)> finish;
        bool queued = false;  ///< by queue()
    };

    /// How many threads the work of all workers may use from its next start on; 0: all of the machine.
    static void useThreads(int threads);

    explicit Worker(QObject* parent = nullptr);
    /// Cancels and waits.
    ~Worker() override;

    void start(Job job);
    /// The same, but what runs of its kind comes to its end first: for work so short that a stream of it would cancel itself for
    /// ever.
    void startNext(Job job);
    /// The same, but nothing gives way to it: what was asked for before is done first.
    void queue(Job job);
    /// Cancels what runs and drops what waits.
    void cancel();
    /// The same for one kind.
    void cancel(Kind kind);
    bool busy() const;
    bool busy(Kind kind) const;
    /// Tells once more how far the work that runs has got, for those who have come to listen since.
    void tellProgress();
    /// How many jobs wait for the one that runs.
    int waiting() const;

signals:
    void progressed(rubble::Worker::Kind kind, const rubble::Progress& progress);
    /// Something started or ended.
    void changed();

private:
    /// Progress that comes faster than it can be drawn is not drawn late: the latest is told once the thread of the window has
    /// time.
    void noteProgress(Kind kind, const Progress& progress);
    void enqueue(Job job);
    void dropWaiting(Kind kind);
    void loop();
    void runOne(Job& job, const Execution& execution);
    /// Tells on the GUI thread that a job has ended, which is among those that finish.
    void tellEnd(std::function<void(std::exception_ptr)> finish, const std::exception_ptr& thrown);

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<Job> m_waiting;
    std::optional<Kind> m_running;
    // Done, but not yet told on the GUI thread: busy until then.
    std::vector<Kind> m_finishing;
    Execution m_execution;
    std::mutex m_progressMutex;
    std::optional<std::pair<Kind, Progress>> m_latest;  ///< progress that is not told yet
    std::optional<std::pair<Kind, Progress>> m_told;    ///< the newest that was told, on the GUI thread
    bool m_stopping = false;
    std::thread m_thread;
};

/// A message for people: what went wrong, and what to do about it, in the language that is spoken when it is shown.
struct Failure {
    widgets::Wording what;
    widgets::Wording remedy;
    std::string id;

    /// Both in one line.
    QString inOneLine() const;
};
/// The message of any exception; none for Cancelled and null.
std::optional<Failure> failureOf(std::exception_ptr exception);

}  // namespace rubble
