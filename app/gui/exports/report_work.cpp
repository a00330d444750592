#include "app/gui/exports/report_work.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QUrl>

#include "app/gui/case/autosave.h"
#include "app/gui/case/project_files.h"
#include "app/gui/evidence/causes_display.h"
#include "app/gui/exports/folder_choice.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/scene_display.h"
#include "core/base/error.h"
#include "core/evidence/report_gaps.h"
#include "io/base/machine.h"
#include "io/exports/report_facts.h"
#include "io/exports/report_notes.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/report_panel.h"

namespace rubble {

namespace {

std::string studyFolder() {
    try {
        return io::cacheFolder();
    } catch (const WorldError&) {
        return {};
    }
}

}  // namespace

ReportWork::ReportWork(Session& session, PanelDeck& deck, SceneDisplay& scene, Actions& actions, QWidget& window)
    : m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_deck(deck),
      m_scene(scene),
      m_window(window),
      m_kept(session.part<ReportKept>()) {
    widgets::ReportPanel& panel = m_deck.report();
    if (m_kept.wishes) {
        panel.setWishes(*m_kept.wishes);
    }
    connect(&panel, &widgets::ReportPanel::writeRequested, this, &ReportWork::write);
    connect(&panel, &widgets::ReportPanel::checkRequested, this, &ReportWork::check);
    connect(&panel, &widgets::ReportPanel::wishesChanged, this, &ReportWork::showGaps);
    m_keeping.setSingleShot(true);
    m_keeping.setInterval(500);
    connect(&m_keeping, &QTimer::timeout, this, &ReportWork::keepNotes);
    connect(&panel, &widgets::ReportPanel::wishesChanged, this, [this] { m_keeping.start(); });
    connect(&panel, &widgets::ReportPanel::causesFileRequested, this, &ReportWork::chooseCauses);
    connect(&panel, &widgets::ReportPanel::cancelRequested, this, [this] { m_computation.cancel(); });
    connect(&panel, &widgets::ReportPanel::openRequested, this,
            [](const QString& folder) { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    connect(&actions[ActionId::WriteReport], &QAction::triggered, this, [this] {
        m_deck.choose(PanelDeck::Report);
        write();
    });
    connect(&m_kept, &ReportKept::changed, this, &ReportWork::showOutcome);
    connect(&m_document, &Document::replaced, this, &ReportWork::changeCase);
    connect(&m_document, &Document::titleChanged, this, [this] {
        m_kept.base = m_document.base();
        if (const QString file = notesFile(); file != m_kept.notes) {
            // Saved elsewhere: what was said goes along.
            m_kept.notes = file;
            keepNotes();
        }
    });
    for (const auto signal :
         {&Document::scenarioChanged, &Document::inputsChanged, &Document::inputsAccepted, &Document::photographsChanged,
          &Document::surveysChanged, &Document::ensembleChanged, &Document::evidenceChanged}) {
        connect(&m_document, signal, this, &ReportWork::dropCheck);
    }
    showOutcome();
}

ReportWork::~ReportWork() {
    if (m_keeping.isActive()) {
        keepNotes();
    }
    m_kept.wishes = m_deck.report().wishes();
}

void ReportWork::showOutcome() {
    m_deck.report().setError(m_kept.failure ? m_kept.failure->what() : QString(),
                             m_kept.failure ? m_kept.failure->remedy() : QString());
    m_deck.report().setWritten(m_kept.written);
    showGaps();
    refresh();
}

QString ReportWork::whyNot() const {
    const RunRecord* record = m_computation.currentRun();
    if (m_document.empty() || m_computation.inputs().fe == nullptr) {
        return tr("Open a result first.");
    }
    if (record == nullptr || record->outcome == nullptr || record->running) {
        return tr("Simulate first: a report is about a run that is complete.");
    }
    if (m_computation.runStale(m_document.scenario())) {
        return tr("Settings have changed since this run. Simulate again, or undo the changes: a stale run is not reported.");
    }
    return {};
}

void ReportWork::refresh() {
    const QString why = whyNot();
    m_deck.report().setReady(why, m_kept.writing);
    m_deck.report().setComparison(whyNoComparison());
    const RunRecord* record = m_computation.currentRun();
    if (m_kept.of != nullptr && (record == nullptr || record->reader != m_kept.of)) {
        dropCheck();
    }
    const bool timed = record != nullptr && !record->running && !record->live && record->wallSeconds > 0.0;
    m_deck.report().setRunSeconds(timed ? std::optional(record->wallSeconds) : std::nullopt);
    m_deck.rail().setState(PanelDeck::Report, m_kept.writing ? widgets::StageState::Running : widgets::StageState::NotYet, 0);
}

void ReportWork::write() {
    if (!whyNot().isEmpty() || m_kept.writing) {
        return;
    }
    const QString folder = chooseFolder(m_window, tr("Folder for the report"), QFileInfo(m_document.base()).absolutePath());
    if (!folder.isEmpty()) {
        writeTo(folder);
    }
}

void ReportWork::writeTo(const QString& folder) {
    if (!whyNot().isEmpty() || m_kept.writing) {
        return;
    }
    const auto order = std::make_shared<ReportOrder>(orderNow());
    order->scene = m_scene.data();
    order->folder = folder.toStdString();
    const auto lacks = std::make_shared<Findings>();
    start([order, lacks](const Execution& execution) { *lacks = order->write(execution); },
          [kept = &m_kept, lacks, folder] {
              kept->written = folder;
              if (!lacks->empty()) {
                  const Finding& lack = lacks->list().front();
                  kept->failure = Failure{[what = lack.what] { return widgets::worded(what); },
                                          [remedy = lack.remedy] { return widgets::worded(remedy); }, lack.what.id};
              }
              return tr("Report written to %1").arg(folder);
          });
}

void ReportWork::check() {
    if (!whyNot().isEmpty() || m_kept.writing) {
        return;
    }
    const auto order = std::make_shared<ReportOrder>(orderNow());
    order->request.repeats = 0;
    const auto facts = std::make_shared<ReportFacts>();
    start([order, facts](const Execution& execution) { *facts = order->facts(execution); },
          [kept = &m_kept, order, facts] {
              kept->facts = std::move(*facts);
              kept->of = order->request.run;
              return tr("The report was checked");
          });
}

ReportOrder ReportWork::wished() const {
    ReportOrder order;
    const widgets::ReportWishes wishes = m_deck.report().wishes();
    order.theCase = m_document.theCase();
    order.selfTest = wishes.selfTest;
    io::ReportRequest& request = order.request;
    request.casePath = m_document.path().toStdString();
    request.basePath = m_document.base().toStdString();
    request.question = wishes.question.toStdString();
    request.author = wishes.author.toStdString();
    request.words = wishes.words;
    request.repeats = wishes.repeats;
    request.studyFolder = studyFolder();
    if (wishes.causes == widgets::ReportedCauses::File) {
        request.causesPath = wishes.causesFile.toStdString();
    } else if (const MadeComparison* made = comparison(); made != nullptr && wishes.causes == widgets::ReportedCauses::Page) {
        request.causes = reportCauses(*made->comparison, made->findings, made->further.get());
        for (const io::EnsembleInput& input : made->basis.inputs) {
            request.causesFiles.push_back({"cause", input.path, input.sha256});
        }
    }
    return order;
}

ReportOrder ReportWork::orderNow() const {
    ReportOrder order = wished();
    io::ReportRequest& request = order.request;
    request.run = m_computation.currentRun()->reader;
    request.inputs = m_computation.inputs();
    request.fePath = request.inputs.fe->contents().path;
    request.terrainPath = m_computation.terrain().path;
    request.siteFindings = io::openingFindings(m_computation.content());
    order.around = io::shownFiles(m_computation.terrain());
    return order;
}

void ReportWork::start(std::function<void(const Execution&)> work, std::function<QString()> done) {
    m_kept.writing = true;
    refresh();
    m_computation.write(std::move(work),
                        [session = &m_session, kept = &m_kept, done = std::move(done)](const std::exception_ptr& thrown) {
                            kept->writing = false;
                            kept->failure = failureOf(thrown);
                            if (thrown == nullptr) {
                                session->tell(done());
                            } else if (!kept->failure) {
                                session->tell(tr("The report was cancelled"));
                            }
                            emit kept->changed();
                        });
}

QString ReportWork::notesFile() const {
    // Seals know it by the same ending.
    return m_session.part<ProjectFiles>().runs.fileBeside(QString::fromStdString(io::reportNotesPath({})));
}

void ReportWork::takeNotes() {
    m_kept.notes = notesFile();
    if (!m_kept.notes.isEmpty()) {
        try {
            const io::ReportNotes notes = io::readReportNotes(m_kept.notes.toStdString());
            if (!notes.empty()) {
                widgets::ReportPanel& panel = m_deck.report();
                widgets::ReportWishes wishes = panel.wishes();
                wishes.question = QString::fromStdString(notes.question);
                wishes.author = QString::fromStdString(notes.author);
                wishes.words = notes.words;
                wishes.causesFile = QString::fromStdString(notes.causes);
                wishes.causes = notes.causes.empty() ? wishes.causes : widgets::ReportedCauses::File;
                panel.setWishes(wishes);
            }
        } catch (...) {
            m_session.report(*failureOf(std::current_exception()));
            // What cannot be read is not written over.
            setFileAside(m_kept.notes);
        }
    }
    m_keeping.stop();
}

void ReportWork::keepNotes() {
    m_keeping.stop();
    if (m_kept.notes.isEmpty()) {
        return;
    }
    const widgets::ReportWishes wishes = m_deck.report().wishes();
    const bool file = wishes.causes == widgets::ReportedCauses::File;
    try {
        io::writeReportNotes(m_kept.notes.toStdString(), {wishes.question.toStdString(), wishes.author.toStdString(), wishes.words,
                                                          file ? wishes.causesFile.toStdString() : std::string()});
    } catch (...) {
        m_session.report(*failureOf(std::current_exception()));
    }
}

void ReportWork::changeCase() {
    if (m_keeping.isActive()) {
        keepNotes();
    }
    if (m_document.base() != m_kept.base && !m_kept.base.isEmpty()) {
        widgets::ReportPanel& panel = m_deck.report();
        widgets::ReportWishes wishes = panel.wishes();
        m_kept.others[m_kept.base] = wishes;
        wishes.question.clear();
        wishes.repeats = widgets::ReportWishes().repeats;
        wishes.words = {};
        wishes.causes = widgets::ReportedCauses::None;
        wishes.causesFile.clear();
        const auto known = m_kept.others.find(m_document.base());
        panel.setWishes(known != m_kept.others.end() ? known->second : wishes);
        m_kept.failure.reset();
        m_kept.written.clear();
        showOutcome();
    }
    takeNotes();
    dropCheck();
}

void ReportWork::dropCheck() {
    m_kept.facts.reset();
    m_kept.of.reset();
    showGaps();
}

void ReportWork::showGaps() {
    widgets::ReportPanel& panel = m_deck.report();
    const widgets::ReportWishes wishes = panel.wishes();
    ReportFacts unchecked;
    ReportFacts& facts = m_kept.facts ? *m_kept.facts : unchecked;
    facts.question = wishes.question.toStdString();
    facts.author = wishes.author.toStdString();
    facts.words = wishes.words;
    if (wishes.causes == widgets::ReportedCauses::None) {
        facts.causes.reset();
    } else if (!facts.causes) {
        facts.causes.emplace();
    }
    const ReportPlan plan{wishes.repeats, wishes.selfTest != QLatin1String("none")};
    panel.setGaps(m_kept.facts ? std::optional(reportGaps(facts, plan)) : std::nullopt, reportOwnWords(facts));
}

void ReportWork::chooseCauses() {
    m_deck.report().setCausesFile(QFileDialog::getOpenFileName(&m_window, tr("Comparison of causes"),
                                                               QFileInfo(m_document.base()).absolutePath(),
                                                               tr("Comparisons (*.json);;All files (*)")));
    m_keeping.start();
}

QString ReportWork::whyNoComparison() const {
    const auto& made = m_causes != nullptr ? m_causes->made() : nullptr;
    if (made == nullptr || (made->comparison == nullptr && made->blind.empty())) {
        return tr("The page Causes holds no comparison.");
    }
    if (made->comparison == nullptr) {
        return tr("The page Causes holds blind tests alone: no cause was held against evidence.");
    }
    return m_causes->stale() ? tr("The comparison of the page Causes is of other causes, evidence or settings: compare again.")
                             : QString();
}

const MadeComparison* ReportWork::comparison() const {
    const auto& made = m_causes != nullptr ? m_causes->made() : nullptr;
    return made != nullptr && made->comparison != nullptr && !m_causes->stale() ? made.get() : nullptr;
}

}  // namespace rubble
