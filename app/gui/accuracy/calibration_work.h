#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/worker.h"
#include "core/pipeline/time_left.h"
#include "widgets/accuracy/calibration_plot.h"

namespace rubble {

/// Calibrates this machine in the background, on a worker of its own, and keeps the outcome in the user's cache as the command line
/// does.
class CalibrationWork : public QObject {
    Q_OBJECT

public:
    explicit CalibrationWork(QObject* parent = nullptr);

    /// Reads what is kept of this machine and fits its curves; answers with changed().
    void load(double target);
    /// Measures; answers with progressed() and ended().
    void start(double target);
    void cancel();
    bool running() const { return m_running; }
    /// Tells once more how far it has got.
    void tellProgress() { m_worker.tellProgress(); }
    /// Numbers of bodies to measure with; empty: those of core.
    void setBodies(std::vector<std::int64_t> bodies) { m_bodies = std::move(bodies); }
    /// Null: not calibrated.
    const std::shared_ptr<const Calibration>& calibration() const { return m_calibration; }
    const widgets::CalibrationPlotContent& plot() const { return m_plot; }

signals:
    /// Another calibration, or other curves of it.
    void changed();
    /// @param secondsLeft  NaN: not known yet
    void progressed(double fraction, double secondsLeft);
    /// @param failure  null: it came to its end or was cancelled
    void ended(const rubble::Failure* failure);

private:
    struct Outcome {
        std::shared_ptr<const Calibration> calibration;
        widgets::CalibrationPlotContent plot;
    };
    std::shared_ptr<const Calibration> measure(double target, const Execution& execution) const;
    void take(const Outcome& outcome);

    std::string m_machine;
    std::vector<std::int64_t> m_bodies;
    std::shared_ptr<const Calibration> m_calibration;
    widgets::CalibrationPlotContent m_plot;
    bool m_running = false;
    TimeLeft m_left;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
