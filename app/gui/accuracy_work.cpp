#include "app/gui/accuracy_work.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/machine.h"
#include "io/study_files.h"
#include "widgets/figures/live_screen.h"
#include "widgets/wording.h"

namespace rubble {

AccuracyWork::AccuracyWork(QObject* parent) : QObject(parent), m_machine(io::machineText()) {
    connect(&m_worker, &Worker::progressed, this, [this](Worker::Kind, const Progress& progress) { showProgress(progress); });
}

QString AccuracyWork::folder() {
    try {
        return QString::fromStdString(io::cacheFolder());
    } catch (const WorldError&) {
        return {};
    }
}

void AccuracyWork::start(const Inputs& inputs, const Scenario& scenario, const widgets::AccuracyPanel::Request& request) {
    const std::vector<AccuracySetting> settings = sweepSettings(scenario, request.multiples, request.varied);
    const int generation = ++m_generation;
    m_running = true;
    m_left.restart();
    auto made = std::make_shared<std::shared_ptr<const AccuracyReport>>();
    m_worker.start({Worker::Kind::Study,
                    [this, inputs, scenario, settings, request, generation, made](const Execution& execution) {
                        *made = std::make_shared<const AccuracyReport>(
                            compare(inputs, scenario, settings, request, generation, execution));
                    },
                    [this, generation, made](const std::exception_ptr& thrown) {
                        if (generation != m_generation) {
                            return;
                        }
                        m_running = false;
                        if (*made != nullptr && !(*made)->points.empty()) {
                            take(generation, *made);
                        }
                        const auto failure = failureOf(thrown);
                        emit ended(failure ? &*failure : nullptr);
                    }});
}

AccuracyReport AccuracyWork::compare(const Inputs& inputs, const Scenario& scenario, const std::vector<AccuracySetting>& settings,
                                     const widgets::AccuracyPanel::Request& request, int generation, const Execution& execution) {
    io::StudyFiles files(io::cacheFolder());
    std::string renderer;
    AccuracyOptions options;
    options.study.repeats = request.repeats;
    options.study.measures.tolerances = request.tolerances;
    options.machine = m_machine;
    options.store = &files;
    options.retimed = request.retimed;
    if (request.liveFps) {
        options.screen = [&renderer](const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory) {
            return figures::liveScreen(run, std::move(trajectory), renderer);
        };
    }
    options.grown = [this, generation](const AccuracyReport& report) {
        auto copy = std::make_shared<const AccuracyReport>(report);
        QMetaObject::invokeMethod(this, [this, generation, copy] { take(generation, copy); }, Qt::QueuedConnection);
    };
    AccuracyReport report = accuracyStudy(inputs, scenario, settings, options, execution);
    io::keepPoints(files, report);
    return report;
}

void AccuracyWork::take(int generation, std::shared_ptr<const AccuracyReport> report) {
    if (generation == m_generation) {
        m_report = std::move(report);
        emit grew();
    }
}

void AccuracyWork::clear() {
    ++m_generation;
    m_worker.cancel();
    m_running = false;
    m_report.reset();
    emit grew();
}

void AccuracyWork::showProgress(const Progress& progress) {
    if (!m_running) {
        return;
    }
    emit progressed(widgets::worded(progress.stage), std::clamp(progress.fraction, 0.0, 1.0), m_left.after(progress));
}

void AccuracyWork::cancel() {
    m_worker.cancel();
    // What had not started yet never ends by itself.
    if (m_running && !m_worker.busy(Worker::Kind::Study)) {
        m_running = false;
        emit ended(nullptr);
    }
}

}  // namespace rubble
