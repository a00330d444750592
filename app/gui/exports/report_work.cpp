#include "app/gui/exports/report_work.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QUrl>

#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/scene_display.h"
#include "core/base/error.h"
#include "core/selftest/report_checks.h"
#include "io/base/machine.h"
#include "io/exports/provenance.h"
#include "io/exports/report_facts.h"
#include "io/site/site_place.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/figures/report/report_pictures.h"

namespace rubble {

namespace {

/// Everything that the worker needs, as it was when it was asked for.
struct Order {
    io::ReportRequest request;
    std::vector<io::ShownFile> around;
    Case theCase;
    widgets::ReportWishes wishes;
    render::SceneData scene;
    std::string folder;
};

std::string studyFolder() {
    try {
        return io::cacheFolder();
    } catch (const WorldError&) {
        return {};
    }
}

void addSelfTest(ReportFacts& facts, const QString& scope, const Execution& execution) {
    if (scope == QLatin1String("none")) {
        return;
    }
    execution.report({"report.testing", "Testing this machine", {}}, 0.5);
    facts.selfTest = selftest::reportChecks(selftest::runSuite(selftest::reportCases(scope.toStdString()), {}, execution));
    execution.check();
    facts.selfTestScope = scope.toStdString();
}

void makeReport(Order& order, const Execution& execution) {
    order.request.theCase = &order.theCase;
    ReportFacts facts = io::reportFacts(order.request, execution);
    addSelfTest(facts, order.wishes.selfTest, execution);
    const io::RunReader& run = *order.request.run;
    figures::MapPictureStyle map;
    map.place = io::SitePlace(run.origin().frame, run.origin().site).transform();
    map.system = run.origin().frame.crs;
    figures::ReportPictures pictures = figures::drawReportPictures(order.scene, facts, map, execution);
    pictures.say = [](const Message& message) { return widgets::worded(message); };
    const io::ExportRecord record{
        "report",    {{"Debris at the end", facts.result->endTime, std::nullopt, "simulated"}}, {}, {}, order.request.casePath,
        order.around};
    figures::writeReport(order.folder, facts, pictures, io::exportProvenance(record, run.origin(), &run), execution);
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
    connect(&panel, &widgets::ReportPanel::cancelRequested, this, [this] { m_computation.cancel(); });
    connect(&panel, &widgets::ReportPanel::openRequested, this,
            [](const QString& folder) { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    connect(&actions[ActionId::WriteReport], &QAction::triggered, this, [this] {
        m_deck.choose(PanelDeck::Report);
        write();
    });
    connect(&m_kept, &ReportKept::changed, this, &ReportWork::showOutcome);
    showOutcome();
}

ReportWork::~ReportWork() {
    m_kept.wishes = m_deck.report().wishes();
}

void ReportWork::showOutcome() {
    m_deck.report().setError(m_kept.failure ? m_kept.failure->what() : QString(),
                             m_kept.failure ? m_kept.failure->remedy() : QString());
    if (!m_kept.written.isEmpty()) {
        m_deck.report().setWritten(m_kept.written);
    }
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
    const RunRecord* record = m_computation.currentRun();
    const bool timed = record != nullptr && !record->running && !record->live && record->wallSeconds > 0.0;
    m_deck.report().setRunSeconds(timed ? std::optional(record->wallSeconds) : std::nullopt);
    m_deck.rail().setState(PanelDeck::Report, m_kept.writing ? widgets::StageState::Running : widgets::StageState::NotYet, 0);
}

void ReportWork::write() {
    if (!whyNot().isEmpty() || m_kept.writing) {
        return;
    }
    const QString folder =
        QFileDialog::getExistingDirectory(&m_window, tr("Folder for the report"), QFileInfo(m_document.base()).absolutePath());
    if (!folder.isEmpty()) {
        writeTo(folder);
    }
}

void ReportWork::writeTo(const QString& folder) {
    if (!whyNot().isEmpty() || m_kept.writing) {
        return;
    }
    auto order = std::make_shared<Order>();
    const RunRecord* record = m_computation.currentRun();
    order->theCase = m_document.theCase();
    order->wishes = m_deck.report().wishes();
    order->scene = m_scene.data();
    order->folder = folder.toStdString();
    io::ReportRequest& request = order->request;
    request.run = record->reader;
    request.inputs = m_computation.inputs();
    request.fePath = request.inputs.fe->contents().path;
    request.terrainPath = m_computation.terrain().path;
    request.siteFindings = io::openingFindings(m_computation.content());
    request.casePath = m_document.path().toStdString();
    request.basePath = m_document.base().toStdString();
    request.question = order->wishes.question.toStdString();
    request.author = order->wishes.author.toStdString();
    request.repeats = order->wishes.repeats;
    request.studyFolder = studyFolder();
    order->around = io::shownFiles(m_computation.terrain());
    m_kept.writing = true;
    refresh();
    m_computation.write([order](const Execution& execution) { makeReport(*order, execution); },
                        [session = &m_session, kept = &m_kept, folder](const std::exception_ptr& thrown) {
                            kept->writing = false;
                            kept->failure = failureOf(thrown);
                            if (thrown == nullptr) {
                                kept->written = folder;
                                session->tell(tr("Report written to %1").arg(folder));
                            } else if (!kept->failure) {
                                session->tell(tr("The report was cancelled"));
                            }
                            emit kept->changed();
                        });
}

}  // namespace rubble
