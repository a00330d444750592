#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/worker.h"
#include "app/gui/studies/cluster_work.h"
#include "core/analysis/accuracy/accuracy_study.h"
#include "core/pipeline/time_left.h"
#include "widgets/accuracy/accuracy_panel.h"

namespace rubble {

/// Compares settings in the background, on a worker of its own so that the case can be edited meanwhile, or has their worlds made
/// on a cluster. Points are there as they are done, and are kept in the user's cache as those of the command line are: a second
/// start goes on from there.
class AccuracyWork : public QObject {
    Q_OBJECT

public:
    explicit AccuracyWork(QObject* parent = nullptr);

    /// Starts a comparison; answers with grew(), progressed() and ended(). Throws UsageError for settings that cannot be swept.
    /// @param of  the same case, for the tasks of a cluster
    void start(const Inputs& inputs, const Scenario& scenario, const widgets::AccuracyPanel::Request& request, const JobCase& of);
    /// Goes on with the comparison that was given to the cluster last, if there is one of this reference; answers with resumed()
    /// and as start() does.
    void resume(const Inputs& inputs, const Scenario& scenario, const widgets::AccuracyPanel::Request& request);
    /// Ends what this machine does; a cluster goes on.
    void cancel();
    /// Cancels and forgets; a cluster goes on.
    void clear();
    bool running() const { return m_running || m_cluster.running(); }
    /// Tells once more how far it has got.
    void tellProgress();
    /// This machine simulates.
    bool simulatesHere() const { return m_running; }
    ClusterWork& cluster() { return m_cluster; }
    /// What there is; null before the first settings are known.
    const std::shared_ptr<const AccuracyReport>& report() const { return m_report; }
    const std::string& machine() const { return m_machine; }
    /// Where worlds and costs are kept; empty if there is no place for them.
    static QString folder();

signals:
    /// An earlier comparison goes on.
    void begun();
    void grew();
    /// What the cluster was asked for earlier.
    void resumed(const rubble::widgets::AccuracyPanel::Request& request);
    /// @param secondsLeft  NaN: not known yet
    void progressed(const QString& what, double fraction, double secondsLeft);
    /// @param failure  null: it came to its end or was cancelled
    void ended(const rubble::Failure* failure);

private:
    struct Comparison;
    std::function<void(const io::JobProgress&, const Execution&)> collecting(const std::shared_ptr<Comparison>& comparison);
    AccuracyReport collect(const Comparison& comparison, const io::JobProgress& progress, const Execution& execution) const;
    AccuracyReport compare(const Comparison& comparison, const Execution& execution);
    void take(int generation, std::shared_ptr<const AccuracyReport> report);
    void showProgress(const Progress& progress);

    std::string m_machine;
    std::shared_ptr<const AccuracyReport> m_report;
    bool m_running = false;
    int m_generation = 0;  // what comes in from an older start is not taken
    TimeLeft m_left;
    ClusterWork m_cluster;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
