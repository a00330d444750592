#include "app/gui/case/run_history.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

#include "app/gui/case/autosave.h"
#include "app/gui/session/kept_runs.h"
#include "app/gui/session/session.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/run/run_cautions.h"
#include "io/run/run_history.h"
#include "widgets/run/health_list.h"

namespace rubble {

namespace {

const QString stateEnding = QStringLiteral(".runs.json");

/// Also of one whose begin or end alone one of them knows: nothing else is written into the file of a run.
bool sameOrBegun(const RunEntry& a, const RunEntry& b) {
    return sameRun(a, b) || ((a.interrupted || b.interrupted) && !a.file.empty() && a.file == b.file);
}

/// Runs that are known already gain at most the file where they were kept, and their end.
void addNew(std::vector<RunEntry>& to, const std::vector<RunEntry>& from) {
    for (const RunEntry& run : from) {
        const auto known = std::find_if(to.begin(), to.end(), [&run](const RunEntry& each) { return sameOrBegun(each, run); });
        if (known == to.end()) {
            to.push_back(run);
            continue;
        }
        if (known->hasOnlyBegun() && !run.hasOnlyBegun()) {
            *known = run;
        }
        if (known->file.empty()) {
            known->file = run.file;
        }
        if (!known->grade) {
            known->grade = run.grade;
            known->acknowledged = run.acknowledged;
        }
    }
    std::stable_sort(to.begin(), to.end(), [](const RunEntry& a, const RunEntry& b) { return a.when < b.when; });
}

/// Bodies that there were when a run was stopped; 0 where its file cannot be read.
std::int64_t bodiesSoFar(const io::RunReader* run) {
    try {
        return run != nullptr ? io::standingOf(*run).bodies : 0;
    } catch (const std::exception&) {
        return 0;
    }
}

}  // namespace

RunHistory::RunHistory(Session& session, const QString& folder, QObject* parent)
    : QObject(parent), m_session(session), m_document(session.document()), m_computation(session.computation()), m_folder(folder) {
    m_computation.keepRunsIn([this] { return makeFolder(); });
    connect(&m_document, &Document::replaced, this, &RunHistory::load);
    connect(&m_document, &Document::titleChanged, this, [this] {
        // Saved elsewhere: what is known goes along, to what that place knows already.
        if (!m_document.empty() && m_document.path() != m_loadedFor) {
            m_loadedFor = m_document.path();
            addNew(m_runs, read(sidecar()));
            adoptBegun();
            m_shown.reset();
            if (!m_runs.empty() || !m_unlisted.empty()) {
                store();
            }
            emit changed();
        }
    });
    connect(&m_computation, &Computation::runBegun, this, &RunHistory::began);
    connect(&m_computation, &Computation::runEnded, this, &RunHistory::ended);
    connect(&m_computation, &Computation::runReopened, this, [this] {
        m_shown = m_asked;
        m_asked.reset();
        emit changed();
    });
    connect(&m_computation, &Computation::acknowledged, this, &RunHistory::noteAcknowledged);
    connect(&session, &Session::preferencesChanged, this, &RunHistory::takePreferences);
}

void RunHistory::takePreferences(const widgets::Preferences& before) {
    const int gib = m_session.preferences().keepRunsGib;
    if (gib == before.keepRunsGib || (gib > 0 && before.keepRunsGib > 0)) {
        return;
    }
    if (gib > 0) {
        m_session.tell(tr("Runs that begin from now on are kept, up to %1 GiB a case").arg(gib));
        return;
    }
    m_computation.keepNoMore();
    m_session.tell(
        m_computation.simulating()
            ? tr("No more runs are kept: the one that is simulated goes with the case as well. Those that were kept stay")
            : tr("No more runs are kept: new ones go with the case. Those that were kept stay"));
}

void RunHistory::noteAcknowledged() {
    const RunRecord* record = m_computation.currentRun();
    if (m_shown && record != nullptr) {
        m_runs[*m_shown].acknowledged = record->acknowledged.has_value();
        store();
        emit changed();
    }
}

QString RunHistory::sidecar() const {
    return m_document.path().isEmpty() ? QString() : QString::fromStdString(io::runHistoryPath(m_document.path().toStdString()));
}

QString RunHistory::stateFile() const {
    if (m_folder.isEmpty()) {
        return {};
    }
    const QString base = m_document.path().isEmpty() ? m_document.base() : m_document.path();
    const QByteArray key = QCryptographicHash::hash(base.toUtf8(), QCryptographicHash::Sha256).toHex().left(16);
    return m_folder + u'/' + QString::fromLatin1(key) + stateEnding;
}

// Rights alone do not say it: whoever may write everything still leaves samples and sealed cases as they are.
bool RunHistory::writesBeside() const {
    const QString path = m_document.path();
    return !path.isEmpty() && !m_document.readOnly() && QFileInfo(QFileInfo(path).absolutePath()).isWritable();
}

QString RunHistory::fileBeside(const QString& ending) const {
    if (writesBeside()) {
        return m_document.path() + ending;
    }
    const QString runs = m_document.empty() ? QString() : stateFile();
    return runs.isEmpty() ? QString() : runs.chopped(stateEnding.size()) + ending;
}

std::vector<RunEntry> RunHistory::read(const QString& file) {
    if (file.isEmpty()) {
        return {};
    }
    try {
        return io::readRunHistory(file.toStdString());
    } catch (const ParseError&) {
        const auto failure = failureOf(std::current_exception());
        const QString kept = setFileAside(file);
        const auto aside = [kept] { return tr("It was set aside as %1; a new history begins.").arg(kept); };
        m_session.report({failure->what, kept.isEmpty() ? failure->remedy : widgets::Wording(aside), failure->id});
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_session.report(*failure);
    }
    return {};
}

void RunHistory::load() {
    m_runs.clear();
    m_unlisted.clear();
    m_shown.reset();
    m_loadedFor = m_document.path();
    if (!m_document.empty()) {
        addNew(m_runs, read(sidecar()));
        addNew(m_runs, read(stateFile()));
        findFiles();
        adoptBegun();
        std::for_each(m_runs.begin(), m_runs.end(), io::takeVerdict);
    }
    emit changed();
}

QString RunHistory::runsFolder() const {
    const widgets::Preferences& preferences = m_session.preferences();
    if (preferences.keepRunsGib == 0 || m_document.empty()) {
        return {};
    }
    const QString key = QFileInfo(stateFile()).baseName();
    const QString base = m_document.path().isEmpty() ? m_document.base() : m_document.path();
    if (!preferences.runsFolder.isEmpty()) {
        return preferences.runsFolder + u'/' + QFileInfo(base).completeBaseName() + u'-' + key.left(8);
    }
    if (writesBeside()) {
        return base + QStringLiteral(".runs");
    }
    return m_folder.isEmpty() ? QString() : m_folder + u'/' + key;
}

QString RunHistory::makeFolder() {
    const QString folder = runsFolder();
    if (folder.isEmpty()) {
        return folder;
    }
    if (QDir().mkpath(folder) && QFileInfo(folder).isWritable()) {
        noteRunFolder({folder, m_document.openPath()});
        return folder;
    }
    m_session.tell(tr("Nothing can be written into %1: this run goes with the case unless it is saved").arg(folder));
    return {};
}

// Runs of a program that was killed are in no history, and those of a case that was moved lie beside it now.
void RunHistory::findFiles() {
    if (runsFolder().isEmpty()) {
        return;
    }
    const auto exists = [](const std::string& path) { return QFile::exists(QString::fromStdString(path)); };
    for (const QFileInfo& file : QDir(runsFolder()).entryInfoList({QStringLiteral("*.run.h5")}, QDir::Files, QDir::Name)) {
        const std::string path = file.absoluteFilePath().toStdString();
        const auto listed = std::find_if(m_runs.begin(), m_runs.end(), [&](const RunEntry& run) {
            return run.file == path || (!run.file.empty() && !exists(run.file) &&
                                        QFileInfo(QString::fromStdString(run.file)).fileName() == file.fileName());
        });
        if (listed != m_runs.end()) {
            listed->file = path;
            continue;
        }
        std::optional<RunEntry> found = entryOfRunFile(file.absoluteFilePath());
        const auto same = [&](const RunEntry& run) { return found->complete && run.trajectoryHash == found->trajectoryHash; };
        if (found && std::none_of(m_runs.begin(), m_runs.end(), same)) {
            for (const CaseScenario& scenario : m_document.theCase().scenarios) {
                found->scenarioId = scenario.name == found->scenarioName ? scenario.id : found->scenarioId;
            }
            addNew(m_runs, {*found});
        }
    }
}

// Of a run whose end nobody wrote down, its file tells what came of it. It may have ended well: the case was saved elsewhere then.
void RunHistory::adoptBegun() {
    std::vector<RunEntry> listed;
    for (RunEntry& run : m_runs) {
        if (!run.hasOnlyBegun()) {
            listed.push_back(std::move(run));
            continue;
        }
        const QString file = QString::fromStdString(run.file);
        if (!QFile::exists(file)) {
            continue;
        }
        if (holdFile(file + QStringLiteral(".lock")) == nullptr) {
            const auto same = [&run](const RunEntry& each) { return each.file == run.file; };
            if (std::none_of(m_unlisted.begin(), m_unlisted.end(), same)) {
                m_unlisted.push_back(std::move(run));
            }
        } else if (std::optional<RunEntry> found = entryOfRunFile(file)) {
            found->scenarioId = run.scenarioId;
            found->live = run.live;
            listed.push_back(std::move(*found));
        }
    }
    m_runs = std::move(listed);
}

void RunHistory::makeRoom() {
    const QString folder = runsFolder();
    if (folder.isEmpty()) {
        return;
    }
    QStringList inUse;
    if (const RunRecord* record = m_computation.currentRun()) {
        inUse << record->path;
    }
    for (const auto& other : m_computation.otherRuns()) {
        inUse << other->path;
    }
    const int gib = m_session.preferences().keepRunsGib;
    const DroppedRuns dropped = dropOldestRuns(folder, qint64{gib} << 30, inUse);
    if (dropped.count > 0) {
        m_session.tell(tr("Runs kept: the oldest made room, %1 of them with %2 GiB; Preferences allow %3 GiB")
                           .arg(dropped.count)
                           .arg(QLocale().toString(static_cast<double>(dropped.bytes) / (1 << 30), 'f', 2))
                           .arg(gib));
    }
}

void RunHistory::begins() {
    m_began = false;
    m_starting = m_document.active() != nullptr ? std::optional(*m_document.active()) : std::nullopt;
}

void RunHistory::began() {
    m_began = true;
    m_shown.reset();
    const RunRecord* record = m_computation.currentRun();
    if (record != nullptr && record->kept && m_starting && m_computation.inputs().fe != nullptr) {
        RunEntry run = entryOf(*record);
        run.interrupted = true;
        run.endTime = 0.0;
        run.file = QFileInfo(record->path).absoluteFilePath().toStdString();
        m_unlisted.push_back(std::move(run));
        store();
    }
    emit changed();
}

RunEntry RunHistory::entryOf(const RunRecord& record) const {
    RunEntry run;
    run.when = utcNow();
    run.scenarioId = m_starting->id;
    run.scenarioName = m_starting->name;
    run.fingerprint = stageKey(m_computation.inputs(), record.scenario, Stage::Simulation);
    run.feSha256 = m_computation.inputs().fe->contents().sha256;
    run.build = std::string(buildText());
    run.live = record.live;
    run.fragments = record.results.fragments != nullptr ? static_cast<std::int64_t>(record.results.fragments->size()) : 0;
    return run;
}

void RunHistory::ended() {
    const RunRecord* record = m_computation.currentRun();
    if (!std::exchange(m_began, false) || record == nullptr || !m_starting || m_computation.inputs().fe == nullptr) {
        return;
    }
    RunEntry run = entryOf(*record);
    run.wallSeconds = record->wallSeconds;
    run.bodies = record->outcome == nullptr ? bodiesSoFar(record->reader.get()) : 0;
    run.endTime = record->newest;
    run.breaches = widgets::limitsIn(record->health());
    run.grade = gravestGrade(record->health().breaches);
    if (const SimulationResult* result = record->outcome.get()) {
        run.complete = true;
        run.bodies = result->bodiesPeak;
        run.endTime = result->endTime;
        run.asleepAtEnd = result->asleepAtEnd;
        run.msPerStep = result->stepTimes.meanMs;
        run.maxSpeed = result->maxSpeed;
        run.bulkingFactor = result->bulkingFactor;
        run.energyDrift = result->energy.drift;
        run.trajectoryHash = result->trajectoryHash;
    }
    const QString file = QFileInfo(record->path).absoluteFilePath();
    run.file = record->kept && QFile::exists(file) ? file.toStdString() : std::string();
    std::erase_if(m_unlisted, [of = file.toStdString()](const RunEntry& each) { return each.file == of; });
    m_runs.push_back(std::move(run));
    makeRoom();
    m_shown = m_runs.size() - 1;
    store();
    emit changed();
}

void RunHistory::store() {
    std::vector<RunEntry> all = m_runs;
    all.insert(all.end(), m_unlisted.begin(), m_unlisted.end());
    const auto write = [&all](const QString& file) -> std::optional<Failure> {
        try {
            io::writeRunHistory(file.toStdString(), all);
            return std::nullopt;
        } catch (...) {
            return failureOf(std::current_exception());
        }
    };
    if (!sidecar().isEmpty() && !m_document.readOnly() && !write(sidecar())) {
        return;
    }
    if (stateFile().isEmpty()) {
        return;
    }
    if (const auto failure = write(stateFile())) {
        m_session.report({[what = failure->what] { return tr("The history of runs cannot be kept. %1").arg(what()); },
                          failure->remedy, "gui.run_history"});
    }
}

const RunEntry* RunHistory::newestOf(const std::string& scenarioId) const {
    const auto found = std::find_if(m_runs.rbegin(), m_runs.rend(),
                                    [&](const RunEntry& run) { return run.complete && run.scenarioId == scenarioId; });
    return found != m_runs.rend() ? &*found : nullptr;
}

void RunHistory::keptAt(const QString& path) {
    if (m_shown) {
        m_runs[*m_shown].file = path.toStdString();
        store();
        emit changed();
    }
}

std::optional<std::size_t> RunHistory::sameAsNow() const {
    if (m_computation.inputs().fe == nullptr) {
        return std::nullopt;
    }
    const Digest now = stageKey(m_computation.inputs(), m_document.scenario(), Stage::Simulation);
    for (std::size_t i = m_runs.size(); i-- > 0;) {
        const RunEntry& run = m_runs[i];
        if (run.complete && !run.live && run.fingerprint == now && run.build == buildText() && !run.file.empty() &&
            QFile::exists(QString::fromStdString(run.file))) {
            return i;
        }
    }
    return std::nullopt;
}

void RunHistory::show(std::size_t place) {
    if (place < m_runs.size() && !m_runs[place].file.empty()) {
        m_asked = place;
        m_computation.showRun(QString::fromStdString(m_runs[place].file), m_runs[place].wallSeconds);
    }
}

}  // namespace rubble
