#include "app/gui/evidence/ensemble_display.h"

#include <QFileInfo>

#include "app/gui/accuracy/accuracy_work.h"
#include "app/gui/evidence/cluster_ensemble.h"
#include "app/gui/evidence/map_export.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "core/evidence/ensembles/probability_map.h"
#include "core/evidence/ensembles/study_tables.h"
#include "core/scenario/parameters.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/ensemble_origin.h"
#include "widgets/basics/place_choice.h"
#include "widgets/evidence/ensemble_page.h"
#include "widgets/evidence/ensemble_panel.h"

namespace rubble {

EnsembleKept::EnsembleKept() : cluster(AccuracyWork::folder().toStdString()) {}

EnsembleDisplay::EnsembleDisplay(Session& session, widgets::EnsemblePanel& panel, widgets::EnsemblePage& page, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_work(session.part<StudyWork>()),
      m_panel(panel),
      m_page(page),
      m_kept(session.part<EnsembleKept>()) {
    m_panel.setSurface(m_kept.surface, m_kept.instant);
    m_panel.place().setOnCluster(m_kept.onCluster);
    connect(&m_work, &StudyWork::ensembleGrew, this, &EnsembleDisplay::take);
    connect(&m_kept, &EnsembleKept::grew, this, &EnsembleDisplay::take);
    connect(&m_work, &StudyWork::ended, this, &EnsembleDisplay::ended);
    connect(&m_work, &StudyWork::progressed, this, [this](const QString& what, double fraction, double left) {
        if (m_work.simulating()) {
            m_panel.setProgress(what, fraction, left);
        }
    });
    connect(&m_kept.cluster, &ClusterWork::progressed, &m_panel, &widgets::EnsemblePanel::setProgress);
    connect(&m_kept.cluster, &ClusterWork::begun, this, [this] {
        m_kept.answer.ask(keyNow());
        m_panel.place().setOnCluster(true);
        showPanel();
    });
    connect(&m_kept.cluster, &ClusterWork::ended, this, &EnsembleDisplay::ended);
    connect(&m_kept.cluster, &ClusterWork::reached, &m_panel.place(), &widgets::PlaceChoice::setReached);
    connect(&m_panel.place(), &widgets::PlaceChoice::shown, &m_kept.cluster, &ClusterWork::probe);
    connect(&m_panel.place(), &widgets::PlaceChoice::chosen, this, &EnsembleDisplay::showPanel);
    connect(&m_panel, &widgets::EnsemblePanel::settingsEdited, &m_document, &Document::setEnsemble);
    connect(&m_panel, &widgets::EnsemblePanel::surfaceChanged, this, &EnsembleDisplay::refresh);
    connect(&m_panel, &widgets::EnsemblePanel::simulateRequested, this, &EnsembleDisplay::simulate);
    connect(&m_panel, &widgets::EnsemblePanel::cancelRequested, this, &EnsembleDisplay::cancel);
    connect(&m_page, &widgets::EnsemblePage::layerChanged, this, &EnsembleDisplay::showGround);
    connect(&m_page, &widgets::EnsemblePage::onGroundChanged, this, &EnsembleDisplay::showGround);
    connect(&m_page, &widgets::EnsemblePage::saveMapRequested, this, &EnsembleDisplay::saveMap);
    connect(&m_page, &widgets::EnsemblePage::saveTableRequested, this, &EnsembleDisplay::saveTable);
    connect(&m_document, &Document::ensembleChanged, this, &EnsembleDisplay::refresh);
    connect(&m_document, &Document::scenarioChanged, this, &EnsembleDisplay::refresh);
    connect(&m_document, &Document::scenariosChanged, this, &EnsembleDisplay::refresh);
    connect(&m_document, &Document::replaced, this, &EnsembleDisplay::refresh);
    connect(&m_computation, &Computation::prepared, this, [this] {
        const void* fe = m_computation.inputs().fe.get();
        if (fe != m_kept.fe) {
            // Members of another result say nothing here.
            m_kept.fe = fe;
            m_kept.answer.drop();
            m_kept.answer.end();
            m_kept.map = nullptr;
            showFailure();
            if (m_work.simulating()) {
                m_work.forget();
            }
            m_kept.cluster.forget();
            if (fe != nullptr) {
                m_kept.cluster.resume(onCluster(false));
            }
            showGround();
        }
        refresh();
    });
    connect(&m_computation, &Computation::stateChanged, this, [this] {
        // Progress comes many times a second.
        if (const bool simulating = m_computation.busy(Stage::Simulation); simulating != m_simulating) {
            m_simulating = simulating;
            showPanel();
        }
    });
    m_panel.setFolder(AccuracyWork::folder());
    refresh();
    showFailure();
    if (m_kept.layer && m_kept.map != nullptr) {
        m_page.setLayer(*m_kept.layer);
    }
    m_page.setOnGround(m_kept.onGround);
    showGround();
    m_kept.cluster.tellProgress();
}

EnsembleDisplay::~EnsembleDisplay() {
    m_kept.surface = m_panel.surface();
    m_kept.instant = m_panel.instant();
    m_kept.onCluster = m_panel.place().onCluster();
    m_kept.layer = m_page.layer();
    m_kept.onGround = m_page.onGround();
}

void EnsembleDisplay::showFailure() {
    const std::optional<Failure>& failure = m_kept.answer.failure();
    m_panel.setError(failure ? failure->what() : QString(), failure ? failure->remedy() : QString());
}

StudyCase EnsembleDisplay::openCase() const {
    return {{}, m_document.theCase(), m_document.base().toStdString(), std::nullopt};
}

StudyOrder EnsembleDisplay::order() const {
    StudyOrder order;
    order.settings = m_document.theCase().ensemble;
    order.surface = m_panel.surface();
    order.instant = m_panel.instant();
    order.open = m_computation.openResult();
    return order;
}

Digest EnsembleDisplay::keyNow() const {
    Hasher hasher;
    const Case& theCase = m_document.theCase();
    const bool several = !io::variedScenarios(theCase.ensemble).empty();
    for (const CaseScenario& each : theCase.scenarios) {
        if (several || &each == m_document.active()) {
            hasher.text(each.id).text(each.feInput);
            for (const Stage stage :
                 {Stage::Import, Stage::Components, Stage::Fragments, Stage::Sizing, Stage::Clusters, Stage::Simulation}) {
                hasher.digest(scenarioSlice(each.scenario, stage));
            }
        }
    }
    for (const VariedSetting& varied : theCase.ensemble.varied) {
        hasher.text(varied.key).text(variationText(varied));
    }
    const SurfaceSettings surface = m_panel.surface();
    hasher.value(theCase.ensemble.seed).value(surface.cell).value(surface.withFallen).value(m_panel.instant());
    return hasher.finish();
}

void EnsembleDisplay::simulate() {
    const bool here = !m_panel.place().onCluster();
    if (m_computation.inputs().fe == nullptr || running() ||
        (here && (m_work.running() || m_computation.busy(Stage::Simulation) || !m_busy.isEmpty()))) {
        return;
    }
    m_kept.answer.drop();
    m_kept.map = nullptr;
    m_kept.answer.ask(keyNow());
    showFailure();
    m_panel.setProgress(tr("Preparing"), 0.0, std::numeric_limits<double>::quiet_NaN());
    if (here) {
        m_work.simulate(openCase(), order());
    } else {
        m_kept.cluster.start(onCluster(true));
    }
    refresh();
}

ClusterWork::Study EnsembleDisplay::onCluster(bool submits) {
    // Windows come and go meanwhile.
    const auto take = [kept = &m_kept, generation = ++m_kept.generation](const MadeEnsemble& made) {
        QMetaObject::invokeMethod(
            kept,
            [kept, generation, made] {
                if (generation == kept->generation) {
                    emit kept->grew(made);
                }
            },
            Qt::QueuedConnection);
    };
    return clusterStudy({openCase(), order(), jobCaseOf(m_document), m_panel.place().sbatchOptions(), submits, take});
}

void EnsembleDisplay::cancel() {
    if (!m_kept.cluster.running()) {
        m_work.cancel();
    } else if (mayCancelJob(&m_panel)) {
        m_kept.cluster.cancelJob();
    }
}

void EnsembleDisplay::take(const MadeEnsemble& made) {
    m_kept.answer.take(std::make_shared<const MadeEnsemble>(made));
    m_kept.map =
        made.report->done().empty() ? nullptr : std::make_shared<const DebrisMap>(probabilityMap(*made.report, usualThresholds));
    showPage();
    showGround();
}

void EnsembleDisplay::ended(const Failure* failure) {
    if (!m_kept.answer.running()) {
        return;
    }
    m_kept.answer.end(failure);
    showFailure();
    if (failure == nullptr && made().report != nullptr) {
        m_session.tell(made().report->complete
                           ? tr("Ensemble simulated")
                           : tr("The ensemble is not complete; what is done is kept, and simulating again goes on"));
    }
    refresh();
}

void EnsembleDisplay::setBusy(const QString& why) {
    if (why != m_busy) {
        m_busy = why;
        showPanel();
    }
}

const MadeEnsemble& EnsembleDisplay::made() const {
    static const MadeEnsemble none;
    return m_kept.answer.result() != nullptr ? *m_kept.answer.result() : none;
}

bool EnsembleDisplay::stale() const {
    return m_kept.answer.stale(keyNow());
}

void EnsembleDisplay::refresh() {
    showPanel();
    showPage();
}

void EnsembleDisplay::showPanel() {
    const Results& results = m_computation.results();
    const bool open = m_computation.inputs().fe != nullptr;
    const bool none = results.fragments != nullptr && results.fragments->list.empty();
    const bool simulating = m_computation.busy(Stage::Simulation);
    widgets::EnsemblePanel::Content content;
    content.settings = m_document.theCase().ensemble;
    for (const CaseScenario& each : m_document.theCase().scenarios) {
        content.scenarios.push_back({QString::fromStdString(each.id), QString::fromStdString(each.name)});
    }
    content.available = !m_document.empty();
    const bool here = !m_panel.place().onCluster();
    content.running = running();
    content.ready = open && !none && !running() && (!here || (!simulating && m_busy.isEmpty() && !m_work.running()));
    content.why = !open                        ? tr("Open a result first.")
                  : none                       ? tr("No element dies in this result, so there is nothing to simulate.")
                  : here && simulating         ? tr("A run is being simulated: wait for it or cancel it.")
                  : here && m_work.comparing() ? tr("Causes are being compared: wait for that or cancel it.")
                  : content.running || !here || m_busy.isEmpty() ? QString()
                                                                 : m_busy;
    const RunRecord* record = m_computation.currentRun();
    if (record != nullptr && record->outcome != nullptr && !record->live && record->wallSeconds > 0.0) {
        content.runSeconds = record->wallSeconds;
    }
    if (made().report != nullptr) {
        content.findings = made().report->findings;
    }
    m_panel.setContent(content);
}

void EnsembleDisplay::showPage() {
    widgets::EnsemblePage::Content content;
    content.report = made().report;
    content.map = m_kept.map;
    if (m_kept.map != nullptr) {
        content.place = pictureStyle(io::ensembleOrigin(*made().report, *m_kept.map, made().basis),
                                     io::ensembleCautions(*made().report, *m_kept.map, made().basis));
    }
    content.stale = stale();
    content.running = running();
    m_page.setContent(content);
}

void EnsembleDisplay::showGround() {
    const bool shown = m_page.onGround() && m_kept.map != nullptr && m_kept.map->has(m_page.layer());
    if (!shown && m_ground == nullptr) {
        return;
    }
    m_ground = shown ? std::make_shared<const Orthophoto>(figures::groundPicture(*m_kept.map, m_page.layer())) : nullptr;
    emit groundChanged();
}

void EnsembleDisplay::saveMap() {
    const QString path = askSavePath(m_page.window(), tr("Map of the ensemble"),
                                     QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/probability.tif"),
                                     tr("GeoTIFF (*.tif);;Tables (*.csv);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveMapTo(path);
    }
}

void EnsembleDisplay::saveMapTo(const QString& path) {
    if (m_kept.map == nullptr) {
        return;
    }
    if (stale()) {
        m_session.tell(tr("The members are of another case or other settings.") + u' ' + tr("Simulate them again, then save."));
        return;
    }
    const io::MapOrigin origin = io::ensembleOrigin(*made().report, *m_kept.map, made().basis);
    const std::vector<Caution> cautions = io::ensembleCautions(*made().report, *m_kept.map, made().basis);
    m_computation.write([path, origin, cautions, map = m_kept.map, layer = m_page.layer()](
                            const Execution& execution) { writeMapFile(path, *map, layer, origin, cautions, execution); },
                        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

void EnsembleDisplay::saveTable() {
    const QString path =
        askSavePath(m_page.window(), tr("Members of the ensemble"),
                    QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/members.csv"), tr("Tables (*.csv)"));
    if (!path.isEmpty()) {
        saveTableTo(path);
    }
}

void EnsembleDisplay::saveTableTo(const QString& path) {
    if (made().report == nullptr) {
        return;
    }
    m_session.writeNow(
        path, [&] { io::writeAtomically(path.toStdString(), [&](std::ostream& out) { writeMembersCsv(*made().report, out); }); });
}

}  // namespace rubble
