#include "app/gui/accuracy/accuracy_work.h"

#include <algorithm>

#include "app/gui/accuracy/comparison_memory.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/jobs/slurm_words.h"
#include "io/run/study_files.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/live_screen.h"

namespace rubble {

namespace {

std::string storeFolder() {
    try {
        return io::cacheFolder();
    } catch (const WorldError&) {
        // Whoever needs the folder says that there is none.
        return {};
    }
}

}  // namespace

/// What is compared.
struct AccuracyWork::Comparison {
    Inputs inputs;
    Scenario scenario;
    widgets::AccuracyPanel::Request request;
    std::string machine;
    int generation = 0;

    std::vector<AccuracySetting> settings() const { return sweepSettings(scenario, request.multiples, request.varied); }
    AccuracyOptions options(io::StudyFiles& files) const {
        AccuracyOptions options;
        options.study.repeats = request.repeats;
        options.settingRepeats = request.settingRepeats;
        options.study.measures.tolerances = request.tolerances;
        options.machine = machine;
        options.store = &files;
        options.retimed = request.retimed;
        return options;
    }
    /// The same with nothing simulated here. Tasks of a cluster have one thread.
    AccuracyOptions optionsElsewhere(io::StudyFiles& files) const {
        AccuracyOptions options = this->options(files);
        options.study.threads = 1;
        options.retimed = false;
        options.choice = WorldChoice::none();
        return options;
    }
    /// Submits the worlds that are missing. Runs on a worker's thread.
    std::string submit(const JobCase& of, const Execution& execution) const {
        io::StudyFiles files(io::cacheFolder());
        io::DistributedStudy study;
        study.name = "accuracy";
        study.subject = of.subject;
        study.store = files.folder();
        study.tasks = accuracyTasks(inputs, scenario, settings(), optionsElsewhere(files), execution);
        study.kept = [&files](const WorldOrigin& origin) { return files.keeps(origin); };
        study.request = wordsOf(request);
        study.sbatchOptions = request.sbatchOptions;
        if (io::missingTasks(study, execution).empty()) {
            return {};
        }
        study.setCommand(commandLineProgram(), keepJobCase(study.store, io::jobId(study.jobTasks()), of));
        std::size_t submitted = 0;
        return io::submitStudy(study, submitted);
    }
};

AccuracyWork::AccuracyWork(QObject* parent) : QObject(parent), m_machine(io::machineText()), m_cluster(storeFolder()) {
    connect(&m_worker, &Worker::progressed, this, [this](Worker::Kind, const Progress& progress) { showProgress(progress); });
    connect(&m_cluster, &ClusterWork::begun, this, &AccuracyWork::begun);
    connect(&m_cluster, &ClusterWork::progressed, this, &AccuracyWork::progressed);
    connect(&m_cluster, &ClusterWork::ended, this, &AccuracyWork::ended);
}

QString AccuracyWork::folder() {
    return QString::fromStdString(storeFolder());
}

void AccuracyWork::start(const Inputs& inputs, const Scenario& scenario, const widgets::AccuracyPanel::Request& request,
                         const JobCase& of) {
    const auto comparison = std::make_shared<Comparison>(Comparison{inputs, scenario, request, m_machine, 0});
    comparison->settings();  // says at once what cannot be swept
    comparison->generation = ++m_generation;
    if (request.onCluster) {
        m_cluster.start(
            {[comparison, of](const Execution& execution) { return comparison->submit(of, execution); }, collecting(comparison)});
        return;
    }
    m_running = true;
    m_left.restart();
    auto made = std::make_shared<std::shared_ptr<const AccuracyReport>>();
    m_worker.start({Worker::Kind::Study,
                    [this, comparison, made](const Execution& execution) {
                        *made = std::make_shared<const AccuracyReport>(compare(*comparison, execution));
                    },
                    [this, generation = m_generation, made](const std::exception_ptr& thrown) {
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

void AccuracyWork::resume(const Inputs& inputs, const Scenario& scenario, const widgets::AccuracyPanel::Request& request) {
    const auto comparison = std::make_shared<Comparison>(Comparison{inputs, scenario, request, m_machine, ++m_generation});
    const auto found = [this, comparison](const io::JobRecord& record) -> std::string {
        comparison->request = requestFrom(record.request, comparison->request);
        comparison->request.onCluster = true;
        QMetaObject::invokeMethod(
            this,
            [this, comparison] {
                if (comparison->generation == m_generation) {
                    emit resumed(comparison->request);
                }
            },
            Qt::QueuedConnection);
        return io::allMade(storeFolder(), record) ? std::string() : record.id;
    };
    m_cluster.resume({[comparison, found](const Execution& execution) -> std::optional<std::string> {
                          const Scenario reference = referenceScenario(comparison->scenario);
                          const std::string key = originOf(comparison->inputs, reference, 0, 0.0, comparison->machine).key.hex();
                          const auto record = io::newestJob(storeFolder(), "accuracy", [&](const io::JobRecord& each) {
                              execution.check();
                              return std::any_of(each.tasks.begin(), each.tasks.end(),
                                                 [&](const io::JobTask& task) { return task.key == key; });
                          });
                          return record ? std::optional(found(*record)) : std::nullopt;
                      },
                      collecting(comparison)});
}

std::function<void(const io::JobProgress&, const Execution&)> AccuracyWork::collecting(
    const std::shared_ptr<Comparison>& comparison) {
    return [this, comparison](const io::JobProgress& progress, const Execution& execution) {
        const auto report = std::make_shared<const AccuracyReport>(collect(*comparison, progress, execution));
        QMetaObject::invokeMethod(
            this, [this, report, generation = comparison->generation] { take(generation, report); }, Qt::QueuedConnection);
    };
}

AccuracyReport AccuracyWork::collect(const Comparison& comparison, const io::JobProgress& progress,
                                     const Execution& execution) const {
    // Its progress would stand in the way of that of the cluster.
    const Execution silent([&execution](const Progress&) { execution.check(); });
    io::StudyFiles files(io::cacheFolder());
    AccuracyReport report = accuracyStudy(comparison.inputs, comparison.scenario, comparison.settings(),
                                          comparison.optionsElsewhere(files), silent.withThreads(execution.threads()));
    execution.check();
    for (const io::JobTask& task : progress.failed) {
        const auto take = [&](AccuracyPoint& point) {
            if (!point.done && point.origin.key.hex() == task.key) {
                point.failure = io::taskReason(task).what;
            }
        };
        take(report.reference);
        std::for_each(report.points.begin(), report.points.end(), take);
    }
    report.findings.append(findingsOf(progress));
    io::keepPoints(files, report);
    return report;
}

AccuracyReport AccuracyWork::compare(const Comparison& comparison, const Execution& execution) {
    io::StudyFiles files(io::cacheFolder());
    std::string renderer;
    AccuracyOptions options = comparison.options(files);
    if (comparison.request.liveFps) {
        options.screen = [&renderer](const RunDescription& run, std::shared_ptr<const TrajectoryReader> trajectory) {
            return figures::liveScreen(run, std::move(trajectory), renderer);
        };
    }
    options.grown = [this, generation = comparison.generation](const AccuracyReport& report) {
        auto copy = std::make_shared<const AccuracyReport>(report);
        QMetaObject::invokeMethod(this, [this, generation, copy] { take(generation, copy); }, Qt::QueuedConnection);
    };
    AccuracyReport report = accuracyStudy(comparison.inputs, comparison.scenario, comparison.settings(), options, execution);
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
    m_cluster.forget();
    m_running = false;
    m_report.reset();
    emit grew();
}

void AccuracyWork::tellProgress() {
    m_worker.tellProgress();
    m_cluster.tellProgress();
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
