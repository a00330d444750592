#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "app/gui/session/worker.h"
#include "core/pipeline/time_left.h"
#include "core/scenario/case.h"
#include "io/jobs/distributed_study.h"

class QWidget;

namespace rubble {

class Document;

/// A study on a Slurm cluster, submitted and followed in the background. Whatever becomes of this program, the tasks go on: only
/// cancelJob() takes them from the cluster.
class ClusterWork : public QObject {
    Q_OBJECT

public:
    /// Parts of a study; both run on the worker's thread.
    struct Study {
        /// Submits it or finds it among those that were. @return  the id of its job; empty: all its worlds are there; unset:
        /// there is nothing to follow
        std::function<std::optional<std::string>(const Execution& execution)> begin;
        /// Takes up what the store has by now.
        std::function<void(const io::JobProgress& progress, const Execution& execution)> collect;
    };

    /// @param store  folder of the store that worlds are made into
    explicit ClusterWork(std::string store, QObject* parent = nullptr);

    /// Answers with progressed() and ended().
    void start(Study study);
    /// The same for a study that may have been submitted earlier: silent if there is none.
    void resume(Study study);
    /// Takes the tasks from the cluster; what is made stays, and ended() follows.
    void cancelJob();
    /// Follows no longer and takes nothing any more; the tasks go on.
    void forget();
    bool running() const { return m_running; }
    /// Tells once more how far it has got.
    void tellProgress() { m_worker.tellProgress(); }
    /// Asks whether Slurm answers; answers with reached(). Not more often than every few seconds.
    void probe();

signals:
    void begun();
    /// @param secondsLeft  NaN: not known yet
    void progressed(const QString& what, double fraction, double secondsLeft);
    /// @param failure  null: nothing is under way any more
    void ended(const rubble::Failure* failure);
    /// @param why  studies cannot be given to Slurm; empty: they can
    void reached(const QString& why, const QString& remedy);

private:
    void run(Study study, bool told);
    void follow(const Study& study, const Execution& execution, const std::function<void()>& found);
    void finish(int generation, const std::exception_ptr& thrown);

    std::string m_store;
    bool m_running = false;
    int m_generation = 0;                 // what comes in from an older start is not taken
    std::atomic<bool> m_cancels = false;  // the worker is to cancel the job
    TimeLeft m_left;
    QElapsedTimer m_probed;
    // Last, so that they have ended before anything they use goes.
    Worker m_asking;
    Worker m_worker;
};

/// The command line that makes worlds beside this program. Throws WorldError if it is not there.
std::string commandLineProgram();

/// A case as the tasks of a job read it.
struct JobCase {
    Case theCase;
    std::string base;     ///< what its inputs are relative to
    std::string subject;  ///< what people know it by: its file
};

/// The case that is open.
JobCase jobCaseOf(const Document& document);

/// Keeps a case beside the record of a job, with absolute inputs: whatever becomes of it in the window, the tasks read this one.
/// @return  its path. Throws WorldError
std::string keepJobCase(const std::string& store, const std::string& id, const JobCase& of);

/// Asks whether the worlds of a study are to be taken from the cluster.
bool mayCancelJob(QWidget* parent);

/// Findings of the worlds that the cluster did not make.
Findings findingsOf(const io::JobProgress& progress);

}  // namespace rubble
