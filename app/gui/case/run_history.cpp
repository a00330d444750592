#include "app/gui/case/run_history.h"

#include <QCryptographicHash>
#include <algorithm>

#include "app/gui/case/autosave.h"
#include "app/gui/session/session.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/run/run_history.h"

namespace rubble {

namespace {

/// Runs that are known already gain at most the file where they were kept.
void addNew(std::vector<RunEntry>& to, const std::vector<RunEntry>& from) {
    for (const RunEntry& run : from) {
        const auto known = std::find_if(to.begin(), to.end(), [&run](const RunEntry& each) { return sameRun(each, run); });
        if (known == to.end()) {
            to.push_back(run);
        } else if (known->file.empty()) {
            known->file = run.file;
        }
    }
    std::stable_sort(to.begin(), to.end(), [](const RunEntry& a, const RunEntry& b) { return a.when < b.when; });
}

}  // namespace

RunHistory::RunHistory(Session& session, const QString& folder, QObject* parent)
    : QObject(parent), m_session(session), m_document(session.document()), m_computation(session.computation()), m_folder(folder) {
    connect(&m_document, &Document::replaced, this, &RunHistory::load);
    connect(&m_document, &Document::titleChanged, this, [this] {
        // Saved elsewhere: what is known goes along, to what that place knows already.
        if (!m_document.empty() && m_document.path() != m_loadedFor) {
            m_loadedFor = m_document.path();
            addNew(m_runs, read(sidecar()));
            m_shown.reset();
            if (!m_runs.empty()) {
                store();
            }
            emit changed();
        }
    });
    connect(&m_computation, &Computation::runBegun, this, [this] {
        m_began = true;
        m_shown.reset();
        emit changed();
    });
    connect(&m_computation, &Computation::runEnded, this, &RunHistory::ended);
    connect(&m_computation, &Computation::runReopened, this, [this] {
        m_shown = m_asked;
        m_asked.reset();
        emit changed();
    });
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
    return m_folder + u'/' + QString::fromLatin1(key) + QStringLiteral(".runs.json");
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
    m_shown.reset();
    m_loadedFor = m_document.path();
    if (!m_document.empty()) {
        addNew(m_runs, read(sidecar()));
        addNew(m_runs, read(stateFile()));
    }
    emit changed();
}

void RunHistory::begins() {
    m_began = false;
    m_starting = m_document.active() != nullptr ? std::optional(*m_document.active()) : std::nullopt;
}

void RunHistory::ended() {
    const RunRecord* record = m_computation.currentRun();
    if (!std::exchange(m_began, false) || record == nullptr || !m_starting || m_computation.inputs().fe == nullptr) {
        return;
    }
    RunEntry run;
    run.when = utcNow();
    run.scenarioId = m_starting->id;
    run.scenarioName = m_starting->name;
    run.fingerprint = stageKey(m_computation.inputs(), record->scenario, Stage::Simulation);
    run.feSha256 = m_computation.inputs().fe->contents().sha256;
    run.build = std::string(buildText());
    run.live = record->live;
    run.wallSeconds = record->wallSeconds;
    run.fragments = record->results.fragments != nullptr ? static_cast<std::int64_t>(record->results.fragments->size()) : 0;
    run.bodies = record->results.clustering != nullptr ? static_cast<std::int64_t>(record->results.clustering->list.size()) : 0;
    run.endTime = record->newest;
    run.breaches = static_cast<std::int64_t>(record->health().breaches.size());
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
    m_runs.push_back(std::move(run));
    m_shown = m_runs.size() - 1;
    store();
    emit changed();
}

void RunHistory::store() {
    const auto write = [this](const QString& file) -> std::optional<Failure> {
        try {
            io::writeRunHistory(file.toStdString(), m_runs);
            return std::nullopt;
        } catch (...) {
            return failureOf(std::current_exception());
        }
    };
    if (!sidecar().isEmpty() && !write(sidecar())) {
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

void RunHistory::show(std::size_t place) {
    if (place < m_runs.size() && !m_runs[place].file.empty()) {
        m_asked = place;
        m_computation.showRun(QString::fromStdString(m_runs[place].file), m_runs[place].wallSeconds);
    }
}

}  // namespace rubble
