#include "app/gui/session/computation.h"

#include <QDir>
#include <QFile>
#include <QTimer>
#include <chrono>
#include <utility>

#include "app/gui/session/kept_runs.h"
#include "core/base/error.h"
#include "core/pipeline/stage_reports.h"
#include "core/scenario/parameters.h"
#include "io/case/case_file.h"
#include "io/run/acknowledgements.h"
#include "io/site/input_files.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

constexpr int growthsPerSecond = 25;
/// Between two questions whether what was opened may come now.
constexpr std::chrono::milliseconds patience(50);

/// Reads a case or an FE result with all that it stands on. One that was recognised but cannot be read as it is set leaves the
/// case, so that the settings can be changed.
void readContent(Opened& opened, io::CaseRequest request, const Keeping& keeping, const Execution& execution) {
    request.cached = keeping.copies;
    request.stateBytes = keeping.stateBytes();
    request.evenWithoutInputs = true;
    opened.content = io::openCase(request, execution);
    opened.theCase = opened.content.theCase;
    opened.base = QString::fromStdString(opened.content.base);
    opened.fe = opened.content.inputs.fe;
    opened.failure = failureOf(std::exchange(opened.content.failure, nullptr));
}

/// Looks where the case says that its inputs are; what was read already is not read again.
void findInputs(Opened& opened, const Execution& execution) {
    const io::OpenedCase& content = opened.content;
    for (const CaseInput& input : opened.theCase.inputs) {
        const std::string place = io::inputPath(content.base, input);
        io::InputDigest known;
        if (input.role == InputRole::Fe && opened.fe != nullptr && place == content.fePath) {
            known = {opened.fe->contents().sha256, opened.fe->contents().sha256};
        } else if (input.role == InputRole::Terrain && place == content.terrain.path) {
            known = {content.terrain.sha256, content.terrain.fileSha256};
        }
        for (const io::SiteFile& file : content.terrain.files) {
            known = file.input == input.id && file.path == place ? io::InputDigest{file.sha256, file.fileSha256} : known;
        }
        opened.found.push_back(io::findInput(content.base, input, known, execution));
    }
}

/// Names what the effects are decided for. How often frames are recorded is no part of it: live mode has its own rate.
Digest decisionKey(const Inputs& inputs, const Scenario& scenario) {
    Scenario seen = scenario;
    seen.simulation.frameRate = SimulationSettings().frameRate;
    return stageKey(inputs, seen, Stage::Simulation);
}

/// Writes how long it has lived when it ends, however that comes.
class WallClock {
public:
    explicit WallClock(double& seconds) : m_seconds(seconds) {}
    ~WallClock() { m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }
    WallClock(const WallClock&) = delete;
    WallClock& operator=(const WallClock&) = delete;

private:
    double& m_seconds;
    const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace

bool Opened::recognised() const {
    return fe != nullptr || recovered || !path.isEmpty() ||
           (failure && (failure->id.starts_with("exodus.") || failure->id.starts_with("terrain.")));
}

Computation::Computation(QObject* parent) : QObject(parent) {
    for (const Worker* each : {&m_worker, &m_opener}) {
        connect(each, &Worker::progressed, this, &Computation::showProgress);
        connect(each, &Worker::changed, this, [this] {
            if (!m_worker.busy()) {
                m_runningStage.reset();
            }
            if (!busy()) {
                emit progressed({}, 0.0);
            }
            emit stateChanged();
        });
    }
}

Computation::~Computation() = default;

void Computation::showProgress(Worker::Kind kind, const Progress& progress) {
    const bool opens = kind == Worker::Kind::Open;
    (opens ? m_openFraction : m_fraction) = progress.fraction;
    if (opens || !m_opener.busy()) {
        emit progressed(widgets::worded(progress.stage), progress.fraction);
    }
    emit stateChanged();
}

void Computation::tellProgress() {
    m_worker.tellProgress();
    m_opener.tellProgress();
}

void Computation::fail(const Failure& failure) {
    m_failure = failure;
    emit failed(failure);
}

void Computation::startOpening(std::function<Opened(const Execution&)> read) {
    auto result = std::make_shared<Opened>();
    const int opening = ++m_openings;
    m_failure.reset();
    m_openFraction = 0.0;
    emit progressed(tr("Opening"), 0.0);
    m_opener.start({Worker::Kind::Open, [result, read](const Execution& execution) { *result = read(execution); },
                    [this, result, opening](const std::exception_ptr& thrown) {
                        if (const auto failure = failureOf(thrown)) {
                            fail(*failure);
                        } else if (thrown == nullptr) {
                            whenWelcome(result, opening, [this, result, opening] { replaceBy(result, opening); });
                        }
                        emit stateChanged();
                    }});
}

void Computation::whenWelcome(const std::shared_ptr<const Opened>& opened, int opening, const std::function<void()>& go) {
    // Another one may have been asked for meanwhile.
    const Welcome welcome = opening != m_openings ? Welcome::Never : m_welcome ? m_welcome(*opened) : Welcome::Now;
    if (welcome == Welcome::Now) {
        go();
    } else if (welcome == Welcome::Later) {
        QTimer::singleShot(patience, this, [this, opened, opening, go] { whenWelcome(opened, opening, go); });
    }
}

void Computation::replaceBy(const std::shared_ptr<const Opened>& opened, int opening) {
    if (!opened->recognised()) {
        tell(*opened);
        return;
    }
    m_worker.cancel(Worker::Kind::Update);
    m_worker.cancel(Worker::Kind::Simulate);
    // What is being written of the case before is written whole.
    m_worker.start(
        {Worker::Kind::Open, [](const Execution&) {},
         [this, opened, opening](const std::exception_ptr&) { whenWelcome(opened, opening, [this, opened] { tell(*opened); }); }});
}

void Computation::tell(const Opened& opened) {
    // Also where what was open stays: the case may name files that are not there.
    m_found = opened.found;
    emit inputsFound();
    emit this->opened(opened);
    emit stateChanged();
}

void Computation::open(const QString& path) {
    const QString absolute = QDir().absoluteFilePath(path);
    startOpening([absolute, keep = m_keeping](const Execution& execution) {
        Opened result;
        io::CaseRequest request;
        request.path = absolute.toStdString();
        readContent(result, request, keep, execution);
        result.path = QString::fromStdString(result.content.casePath);
        findInputs(result, execution);
        return result;
    });
}

void Computation::reopen(const Case& theCase, const QString& path, const QString& base, bool recovered) {
    startOpening([theCase, path, base, recovered, keep = m_keeping](const Execution& execution) {
        Opened result;
        io::CaseRequest request;
        request.path = base.toStdString();
        request.theCase = theCase;
        readContent(result, request, keep, execution);
        result.path = path;
        result.recovered = recovered;
        findInputs(result, execution);
        return result;
    });
}

void Computation::take(const Opened& opened, const Scenario& scenario) {
    m_opened = opened.content;
    m_opened.theCase = opened.theCase;
    m_found = opened.found;
    m_import = opened.content.scenario.import;
    m_results = {};
    m_decisions.reset();
    m_run.reset();
    dropOthers();
    m_failure.reset();
    emit inputsFound();
    if (opened.failure) {
        fail(*opened.failure);
    }
    emit prepared();
    if (m_opened.inputs.fe != nullptr) {
        update(scenario);
    }
}

void Computation::clear() {
    cancel();
    m_opened = {};
    m_found.clear();
    m_results = {};
    m_decisions.reset();
    m_run.reset();
    dropOthers();
    m_failure.reset();
    emit prepared();
    emit stateChanged();
}

void Computation::cancel() {
    m_opener.cancel();
    m_worker.cancel();
}

void Computation::adopt(const Results& newer, Stage last) {
    const auto i = static_cast<std::size_t>(last);
    for (std::size_t k = 0; k <= i; ++k) {
        m_results.keys[k] = newer.keys[k];
        m_results.wallSeconds[k] = newer.wallSeconds[k];
    }
    m_results.components = newer.components != nullptr ? newer.components : m_results.components;
    m_results.fragments = newer.fragments != nullptr ? newer.fragments : m_results.fragments;
    m_results.sizing = newer.sizing != nullptr ? newer.sizing : m_results.sizing;
    m_results.clustering = newer.clustering != nullptr ? newer.clustering : m_results.clustering;
}

Results Computation::prepareOnWorker(const Inputs& inputs, const Scenario& scenario, const Results& previous,
                                     const Execution& execution) {
    StageObserver observer;
    observer.begins = [this](Stage stage) {
        const auto show = [this, stage] {
            m_runningStage = stage;
            m_fraction = 0.0;
            emit stateChanged();
        };
        QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
    };
    observer.made = [this, fe = inputs.fe](Stage stage, const Results& made) {
        const auto take = [this, made, stage, fe] {
            if (fe == m_opened.inputs.fe) {
                adopt(made, stage);
                emit prepared();
            }
        };
        QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
    };
    Results results = run(inputs, scenario, Stage::Clusters, previous, nullptr, execution, nullptr, observer);
    decideOnWorker(inputs, scenario, results);
    return results;
}

void Computation::decideOnWorker(const Inputs& inputs, const Scenario& scenario, const Results& results) {
    const EffectScene scene{*inputs.fe,          *results.components,  *results.fragments,
                            *results.clustering, inputs.terrain.get(), scenario};
    auto decisions = std::make_shared<const EffectDecisions>(decideEffects(scene));
    QMetaObject::invokeMethod(
        this,
        [this, decisions, key = decisionKey(inputs, scenario), fe = inputs.fe] {
            if (fe == m_opened.inputs.fe) {
                m_decisions = decisions;
                m_decidedFor = key;
                emit decided();
            }
        },
        Qt::QueuedConnection);
}

void Computation::update(const Scenario& scenario) {
    if (m_opened.inputs.fe == nullptr) {
        return;
    }
    m_worker.start({Worker::Kind::Update,
                    [this, inputs = m_opened.inputs, scenario, previous = m_results](const Execution& execution) {
                        prepareOnWorker(inputs, scenario, previous, execution);
                    },
                    [this](const std::exception_ptr& thrown) {
                        m_runningStage.reset();
                        if (const auto failure = failureOf(thrown)) {
                            fail(*failure);
                        } else if (thrown == nullptr) {
                            m_failure.reset();
                        }
                        emit stateChanged();
                    }});
}

QString Computation::scratchPath() {
    if (m_scratch == nullptr) {
        m_scratch = std::make_unique<QTemporaryDir>(QDir::tempPath() + QStringLiteral("/rubble-XXXXXX"));
        if (!m_scratch->isValid()) {
            throw WorldError({"gui.scratch", "No folder for the run can be made in {0}", {QDir::tempPath().toStdString()}},
                             {"gui.scratch.remedy", "Make room there, or set TMPDIR to a folder with room and start again.", {}});
        }
        m_scratchLock = holdFile(m_scratch->filePath(scratchLock));
    }
    return m_scratch->filePath(QStringLiteral("run-%1.run.h5").arg(++m_runs));
}

void Computation::simulate(const Scenario& scenario, const QString& scenarioName, bool live) {
    if (m_opened.inputs.fe == nullptr || simulating()) {
        return;
    }
    auto record = std::make_shared<RunRecord>();
    try {
        const QString folder = m_runFolder ? m_runFolder() : QString();
        record->kept = !folder.isEmpty();
        record->path = record->kept ? newRunFile(folder) : scratchPath();
        record->lock = record->kept ? holdFile(record->path + QStringLiteral(".lock")) : nullptr;
    } catch (...) {
        fail(*failureOf(std::current_exception()));
        return;
    }
    record->live = live;
    record->scenarioName = scenarioName;
    record->scenario = scenario;
    if (live) {
        // Each frame of live mode simulates one frame time.
        record->scenario.simulation.frameRate = scenario.grid.fpsTarget;
    }
    m_pace = live ? std::make_shared<LivePace>(scenario.grid.fpsTarget) : nullptr;
    m_failure.reset();
    const io::RunOrigin origin = io::originOf(m_opened, record->scenario, scenarioName.toStdString());
    auto outcome = std::make_shared<std::shared_ptr<const SimulationResult>>();
    auto wall = std::make_shared<double>(0.0);
    m_worker.start({Worker::Kind::Simulate,
                    [this, record, inputs = m_opened.inputs, previous = m_results, origin, pace = m_pace, outcome,
                     wall](const Execution& execution) {
                        // Also of a run that is cancelled.
                        const WallClock clock(*wall);
                        *outcome = simulateOnWorker(record, inputs, previous, origin, pace, execution);
                    },
                    [this, record, outcome, wall](const std::exception_ptr& thrown) { ended(record, *outcome, *wall, thrown); }});
}

std::shared_ptr<const SimulationResult> Computation::simulateOnWorker(const std::shared_ptr<RunRecord>& record,
                                                                      const Inputs& inputs, const Results& previous,
                                                                      const io::RunOrigin& origin,
                                                                      const std::shared_ptr<LivePace>& pace,
                                                                      const Execution& execution) {
    const Results prepared = prepareOnWorker(inputs, record->scenario, previous, execution);
    QMetaObject::invokeMethod(this, [this] { m_runningStage = Stage::Simulation; }, Qt::QueuedConnection);
    const std::unique_ptr<TrajectorySink> file = io::createRun(record->path.toStdString(), origin);
    auto lastTold = std::chrono::steady_clock::time_point();
    WatchedSink::Listener listener;
    listener.begun = [&, keeping = m_keeping](const RunDescription&) {
        const std::shared_ptr<io::RunReader> reader = io::openRun(record->path.toStdString(), keeping.frameBytes());
        reader->setKept(record->kept);
        QMetaObject::invokeMethod(
            this, [this, record, reader, prepared] { began(record, reader, prepared); }, Qt::QueuedConnection);
    };
    listener.committed = [&](double time, bool liveFrame) {
        const auto now = std::chrono::steady_clock::now();
        if (liveFrame || (!record->live && now - lastTold >= std::chrono::milliseconds(1000 / growthsPerSecond))) {
            lastTold = now;
            QMetaObject::invokeMethod(this, [this, record, time] { committed(record, time); }, Qt::QueuedConnection);
        }
    };
    WatchedSink sink(*file, listener, pace, execution);
    return run(inputs, record->scenario, Stage::Simulation, prepared, &sink, execution).simulation;
}

void Computation::began(const std::shared_ptr<RunRecord>& record, const std::shared_ptr<io::RunReader>& reader,
                        const Results& from) {
    record->reader = reader;
    record->results = from;
    record->running = true;
    record->newest = from.fragments != nullptr && !from.fragments->list.empty() ? from.fragments->list.front().handOverTime : 0.0;
    const std::shared_ptr<RunRecord> older = std::exchange(m_run, record);
    emit runBegun();
    setAside(older, record);
    emit stateChanged();
}

void Computation::committed(const std::shared_ptr<RunRecord>& record, double time) {
    if (record == m_run && record->running) {
        record->newest = time;
        record->reader->refresh();
        record->soFar.breaches = record->reader->breaches();
        emit runGrew(time);
    }
}

void Computation::ended(const std::shared_ptr<RunRecord>& record, const std::shared_ptr<const SimulationResult>& outcome,
                        double wall, const std::exception_ptr& thrown) {
    m_runningStage.reset();
    record->running = false;
    record->outcome = outcome;
    record->wallSeconds = wall;
    // A file that could not be read may have taken the place of the one that was simulated.
    if (outcome != nullptr && m_opened.inputs.fe != nullptr) {
        record->results.simulation = outcome;
        record->results.keys[static_cast<std::size_t>(Stage::Simulation)] =
            stageKey(m_opened.inputs, record->scenario, Stage::Simulation);
    }
    if (record->reader != nullptr) {
        try {
            // Its writer has gone: from here on the file keeps its digest.
            record->reader->reopen();
            record->reader->refresh();
            record->soFar.breaches = record->reader->breaches();
            if (const std::size_t frames = record->reader->frameCount(); frames > 0) {
                record->newest = record->reader->frameTime(frames - 1);
            }
        } catch (...) {
            fail(*failureOf(std::current_exception()));
        }
    }
    record->lock.reset();
    if (outcome == nullptr && (record->reader == nullptr || record->reader->frameCount() == 0)) {
        QFile::remove(record->path);
    }
    if (const auto failure = failureOf(thrown)) {
        fail(*failure);
    }
    emit runEnded(outcome != nullptr);
    emit stateChanged();
}

Findings Computation::findings() const {
    Results results = m_results;
    results.simulation = m_run != nullptr ? m_run->outcome : nullptr;
    return io::allFindings(m_opened, results);
}

void Computation::acceptInputs(const std::vector<CaseInput>& inputs) {
    m_opened.theCase.inputs = inputs;
    emit prepared();
}

void Computation::write(std::function<void(const Execution&)> work, std::function<void(std::exception_ptr)> done) {
    m_worker.queue({Worker::Kind::Write, std::move(work), std::move(done)});
}

bool Computation::stale(Stage stage, const Scenario& scenario) const {
    const auto i = static_cast<std::size_t>(stage);
    return m_opened.inputs.fe != nullptr && m_results.keys[i] != Digest{} &&
           m_results.keys[i] != stageKey(m_opened.inputs, scenario, stage);
}

bool Computation::decisionsStale(const Scenario& scenario) const {
    return m_opened.inputs.fe != nullptr && m_decisions != nullptr && m_decidedFor != decisionKey(m_opened.inputs, scenario);
}

void Computation::acknowledge(const QString& name, const QString& note) {
    if (m_run == nullptr || m_run->running || m_run->outcome == nullptr) {
        return;
    }
    auto made = std::make_shared<std::optional<Acknowledgement>>();
    write(
        [record = m_run, name = name.toStdString(), note = note.toStdString(), made](const Execution&) {
            const std::string path = record->path.toStdString();
            io::acknowledge(path, {name, {}, note, {}});
            const std::vector<Acknowledgement> all = io::acknowledgements(path);
            const Acknowledgement* found = acknowledgementOf(*record->outcome, all);
            *made = found != nullptr ? std::optional(*found) : std::nullopt;
        },
        [this, record = m_run, made](const std::exception_ptr& thrown) {
            record->acknowledged = *made;
            const auto failure = failureOf(thrown);
            emit acknowledged(failure ? failure->inOneLine() : QString());
            emit stateChanged();
        });
}

bool Computation::importStale(const Scenario& scenario) const {
    return m_opened.inputs.fe != nullptr && !(scenario.import == m_import);
}

bool Computation::runStale(const Scenario& scenario) const {
    if (m_run == nullptr || m_opened.inputs.fe == nullptr) {
        return false;
    }
    Scenario now = scenario;
    if (m_run->live) {
        now.simulation.frameRate = m_run->scenario.simulation.frameRate;
    }
    return stageKey(m_opened.inputs, now, Stage::Simulation) != stageKey(m_opened.inputs, m_run->scenario, Stage::Simulation);
}

void Computation::judgeRun(const Scenario& scenario) const {
    if (m_run != nullptr && m_run->reader != nullptr) {
        m_run->reader->setOutgrown(!m_run->running && runStale(scenario));
    }
}

widgets::StageState Computation::state(Stage stage, const Scenario& scenario) const {
    using widgets::StageState;
    if (stage == Stage::Import && m_opener.busy()) {
        return StageState::Running;
    }
    if (m_runningStage == stage && m_worker.busy()) {
        return StageState::Running;
    }
    if (stage == Stage::Simulation) {
        if (m_run == nullptr) {
            return StageState::NotYet;
        }
        if (m_run->running) {
            return StageState::Running;
        }
        // A cancelled run shows what it has, but is not the result of the scenario.
        return m_run->outcome == nullptr || runStale(scenario) ? StageState::Stale : StageState::UpToDate;
    }
    if (stage == Stage::Import) {
        return m_opened.inputs.fe == nullptr ? StageState::NotYet
               : importStale(scenario)       ? StageState::Stale
                                             : StageState::UpToDate;
    }
    const bool made = m_results.keys[static_cast<std::size_t>(stage)] != Digest{};
    return !made ? StageState::NotYet : stale(stage, scenario) ? StageState::Stale : StageState::UpToDate;
}

double Computation::fraction(Stage stage) const {
    return stage == Stage::Import ? m_openFraction : m_runningStage == stage ? m_fraction : 0.0;
}

}  // namespace rubble
