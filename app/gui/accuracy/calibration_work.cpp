#include "app/gui/accuracy/calibration_work.h"

#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/run/study_files.h"
#include "widgets/figures/live_screen.h"

namespace rubble {

namespace {

/// What is kept of a machine; null if nothing is, or there is no place for it.
std::shared_ptr<const Calibration> keptCalibration(const std::string& machine) {
    try {
        Findings ignored;
        if (auto kept = io::StudyFiles(io::cacheFolder()).calibration(machine, ignored)) {
            return std::make_shared<const Calibration>(std::move(*kept));
        }
    } catch (const WorldError&) {
        // No folder for what can be made again: there is nothing kept.
    }
    return nullptr;
}

}  // namespace

CalibrationWork::CalibrationWork(QObject* parent) : QObject(parent), m_machine(io::machineText()) {
    connect(&m_worker, &Worker::progressed, this, [this](Worker::Kind kind, const Progress& progress) {
        if (kind != Worker::Kind::Study || !m_running) {
            return;
        }
        emit progressed(progress.fraction, m_left.after(progress));
    });
}

void CalibrationWork::load(double target) {
    auto outcome = std::make_shared<Outcome>();
    m_worker.startNext({Worker::Kind::Open,
                        [machine = m_machine, target, outcome](const Execution&) {
                            outcome->calibration = keptCalibration(machine);
                            outcome->plot = widgets::calibrationPlotContent(outcome->calibration.get(), target);
                        },
                        [this, outcome](const std::exception_ptr& thrown) {
                            if (thrown == nullptr) {
                                take(*outcome);
                            }
                        }});
}

std::shared_ptr<const Calibration> CalibrationWork::measure(double target, const Execution& execution) const {
    CalibrationSettings settings;
    if (!m_bodies.empty()) {
        settings.bodies = m_bodies;
    }
    settings.target = target;
    settings.machine = m_machine;
    std::string renderer;
    settings.screen = [&renderer](const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory) {
        return figures::liveScreen(run, std::move(trajectory), renderer);
    };
    settings.renderer = [&renderer] { return renderer; };
    Calibration made = calibrate(settings, execution);
    if (!made.complete) {
        throw Cancelled();
    }
    try {
        io::StudyFiles(io::cacheFolder()).keep(made);
    } catch (const WorldError& error) {
        made.findings.add({"calibration.not_kept", "The calibration could not be kept.", {}}, error.remedy(), error.what());
    }
    return std::make_shared<const Calibration>(std::move(made));
}

void CalibrationWork::start(double target) {
    if (m_running) {
        return;
    }
    m_running = true;
    m_left.restart();
    auto outcome = std::make_shared<Outcome>();
    m_worker.start({Worker::Kind::Study,
                    [this, target, outcome](const Execution& execution) {
                        outcome->calibration = measure(target, execution);
                        outcome->plot = widgets::calibrationPlotContent(outcome->calibration.get(), target);
                    },
                    [this, outcome](const std::exception_ptr& thrown) {
                        m_running = false;
                        if (thrown == nullptr) {
                            take(*outcome);
                        }
                        const auto failure = failureOf(thrown);
                        emit ended(failure ? &*failure : nullptr);
                    }});
}

void CalibrationWork::take(const Outcome& outcome) {
    m_calibration = outcome.calibration;
    m_plot = outcome.plot;
    emit changed();
}

void CalibrationWork::cancel() {
    m_worker.cancel();
    // What had not started yet never ends by itself.
    if (m_running && !m_worker.busy(Worker::Kind::Study)) {
        m_running = false;
        emit ended(nullptr);
    }
}

}  // namespace rubble
