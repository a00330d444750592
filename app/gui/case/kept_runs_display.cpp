#include "app/gui/case/kept_runs_display.h"

#include <QDir>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/case/project_files.h"
#include "app/gui/session/session.h"
#include "widgets/case/run_verdict.h"
#include "widgets/run/kept_runs_dialog.h"

namespace rubble {

KeptRunsDisplay::KeptRunsDisplay(Session& session, QWidget& window, QObject* parent)
    : QObject(parent), m_session(session), m_window(window) {
    connect(&session.part<ProjectFiles>().runs, &RunHistory::changed, this, &KeptRunsDisplay::refresh);
    connect(&session, &Session::preferencesChanged, this, &KeptRunsDisplay::refresh);
    connect(&session.computation(), &Computation::prepared, this, &KeptRunsDisplay::showAwaited);
    connect(&session.computation(), &Computation::failed, this, [this] { m_awaited.reset(); });
}

KeptRunsDisplay::~KeptRunsDisplay() {
    close();
}

std::vector<RunFolder> KeptRunsDisplay::folders() const {
    std::vector<RunFolder> found = notedRunFolders();
    const ProjectFiles& files = m_session.part<ProjectFiles>();
    // Of versions that noted none.
    for (const RecentCase& each : files.recent.list()) {
        found.push_back({each.path + QStringLiteral(".runs"), each.path});
    }
    for (const QString& place : {files.runs.stateFolder(), m_session.preferences().runsFolder}) {
        if (place.isEmpty()) {
            continue;
        }
        for (const QFileInfo& folder : QDir(place).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
            found.push_back({folder.absoluteFilePath(), {}});
        }
    }
    return found;
}

QStringList KeptRunsDisplay::inUse() const {
    QStringList paths;
    const auto add = [&](const RunRecord& run) { paths << QFileInfo(run.path).canonicalFilePath(); };
    if (const RunRecord* run = m_session.computation().currentRun()) {
        add(*run);
    }
    for (const auto& other : m_session.computation().otherRuns()) {
        add(*other);
    }
    return paths;
}

void KeptRunsDisplay::show() {
    if (m_dialog.isNull()) {
        m_dialog = new widgets::KeptRunsDialog(&m_window);
        m_dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(m_dialog, &widgets::KeptRunsDialog::openRequested, this, &KeptRunsDisplay::open);
        connect(m_dialog, &widgets::KeptRunsDialog::removeRequested, this, &KeptRunsDisplay::remove);
        connect(m_dialog, &widgets::KeptRunsDialog::undoRequested, this, &KeptRunsDisplay::undo);
        connect(m_dialog, &QDialog::finished, this, &KeptRunsDisplay::close);
        for (const RunFolder& folder : folders()) {
            bringStrayRunsBack(folder.path);
        }
    }
    refresh();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void KeptRunsDisplay::refresh() {
    if (m_dialog.isNull()) {
        return;
    }
    m_runs = keptRunsIn(folders());
    const QStringList used = inUse();
    std::vector<widgets::KeptRunLine> lines;
    for (const KeptRunFile& run : m_runs) {
        const QString state = run.busy ? tr("being written") : run.entry ? widgets::runVerdict(*run.entry) : tr("cannot be read");
        lines.push_back({run.path, run.casePath, run.entry ? QString::fromStdString(run.entry->scenarioName) : QString(), state,
                         run.when, run.bytes, used.contains(QFileInfo(run.path).canonicalFilePath()), run.busy});
    }
    m_dialog->setContent(std::move(lines), m_session.preferences().keepRunsGib);
    m_dialog->setUndo(static_cast<int>(m_aside.size()));
}

void KeptRunsDisplay::open(const QString& path) {
    const auto run = std::find_if(m_runs.begin(), m_runs.end(), [&](const KeptRunFile& each) { return each.path == path; });
    if (run != m_runs.end()) {
        await(*run);
    }
}

void KeptRunsDisplay::openFile(const QString& path) {
    try {
        await(runFileAt(path, m_session.document().openPath(), m_session.computation().inputs().fe.get()));
    } catch (...) {
        m_session.report(*failureOf(std::current_exception()));
    }
}

void KeptRunsDisplay::await(const KeptRunFile& run) {
    m_awaited = run;
    if (m_session.document().openPath() == run.casePath) {
        showAwaited();
    } else {
        emit openRequested(run.casePath);
    }
}

void KeptRunsDisplay::showAwaited() {
    const Computation& computation = m_session.computation();
    const bool there = m_awaited && m_session.document().openPath() == m_awaited->casePath && computation.inputs().fe != nullptr;
    if (!there || computation.busy()) {
        return;
    }
    const QString path = std::exchange(m_awaited, {})->path;
    RunHistory& history = m_session.part<ProjectFiles>().runs;
    for (std::size_t i = 0; i < history.runs().size(); ++i) {
        if (QFileInfo(QString::fromStdString(history.runs()[i].file)) == QFileInfo(path)) {
            history.show(i);
            return;
        }
    }
    m_session.computation().showRun(path, std::nan(""));
}

void KeptRunsDisplay::remove(const QStringList& paths) {
    const QStringList used = inUse();
    for (const QString& path : paths) {
        if (!used.contains(QFileInfo(path).canonicalFilePath()) && setRunAside(path)) {
            m_aside << path;
        } else {
            m_session.tell(tr("%1 cannot be removed: it is in use, or its folder cannot be changed").arg(path));
        }
    }
    m_session.part<ProjectFiles>().runs.filesChanged();
}

void KeptRunsDisplay::undo() {
    for (const QString& path : std::exchange(m_aside, {})) {
        bringRunBack(path);
    }
    m_session.part<ProjectFiles>().runs.filesChanged();
}

void KeptRunsDisplay::close() {
    for (const QString& path : std::exchange(m_aside, {})) {
        dropRunSetAside(path);
    }
}

}  // namespace rubble
