#include "app/gui/ensemble_display.h"

#include <QFileDialog>
#include <QFileInfo>

#include "app/gui/accuracy_work.h"
#include "app/gui/cluster_ensemble.h"
#include "app/gui/computation.h"
#include "app/gui/document.h"
#include "app/gui/map_export.h"
#include "core/evidence/probability_map.h"
#include "core/evidence/study_tables.h"
#include "core/scenario/parameters.h"
#include "io/case_file.h"
#include "io/files.h"
#include "widgets/ensemble_page.h"
#include "widgets/ensemble_panel.h"
#include "widgets/place_choice.h"

namespace rubble {

EnsembleDisplay::EnsembleDisplay(Document& document, Computation& computation, StudyWork& work, widgets::EnsemblePanel& panel,
                                 widgets::EnsemblePage& page, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_computation(computation),
      m_work(work),
      m_panel(panel),
      m_page(page),
      m_cluster(AccuracyWork::folder().toStdString()) {
    connect(&m_work, &StudyWork::ensembleGrew, this, &EnsembleDisplay::take);
    connect(&m_work, &StudyWork::ended, this, &EnsembleDisplay::ended);
    connect(&m_work, &StudyWork::progressed, this, [this](const QString& what, double fraction, double left) {
        if (m_work.simulating()) {
            m_panel.setProgress(what, fraction, left);
        }
    });
    connect(&m_cluster, &ClusterWork::progressed, &m_panel, &widgets::EnsemblePanel::setProgress);
    connect(&m_cluster, &ClusterWork::begun, this, [this] {
        m_startedKey = m_key = keyNow();
        m_panel.place().setOnCluster(true);
        showPanel();
    });
    connect(&m_cluster, &ClusterWork::ended, this, &EnsembleDisplay::ended);
    connect(&m_cluster, &ClusterWork::reached, &m_panel.place(), &widgets::PlaceChoice::setReached);
    connect(&m_panel.place(), &widgets::PlaceChoice::shown, &m_cluster, &ClusterWork::probe);
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
        if (fe != m_fe) {
            // Members of another result say nothing here.
            m_fe = fe;
            m_made = {};
            m_map = nullptr;
            m_panel.setError({});
            if (m_work.simulating()) {
                m_work.forget();
            }
            m_cluster.forget();
            if (fe != nullptr) {
                m_cluster.resume(onCluster(false));
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
    m_panel.setError({});
    m_made = {};
    m_map = nullptr;
    m_startedKey = m_key = keyNow();
    m_panel.setProgress(tr("Preparing"), 0.0, std::numeric_limits<double>::quiet_NaN());
    if (here) {
        m_work.simulate(openCase(), order());
    } else {
        m_cluster.start(onCluster(true));
    }
    refresh();
}

ClusterWork::Study EnsembleDisplay::onCluster(bool submits) {
    const auto take = [this, generation = ++m_generation](const MadeEnsemble& made) {
        QMetaObject::invokeMethod(
            this,
            [this, generation, made] {
                if (generation == m_generation) {
                    this->take(made);
                }
            },
            Qt::QueuedConnection);
    };
    return clusterStudy({openCase(), order(), jobCaseOf(m_document), m_panel.place().sbatchOptions(), submits, take});
}

void EnsembleDisplay::cancel() {
    if (!m_cluster.running()) {
        m_work.cancel();
    } else if (mayCancelJob(&m_panel)) {
        m_cluster.cancelJob();
    }
}

void EnsembleDisplay::take(const MadeEnsemble& made) {
    m_made = made;
    m_key = m_startedKey;
    m_map =
        made.report->done().empty() ? nullptr : std::make_shared<const DebrisMap>(probabilityMap(*made.report, usualThresholds));
    showPage();
    showGround();
}

void EnsembleDisplay::ended(const Failure* failure) {
    if (m_startedKey == Digest()) {
        return;
    }
    m_startedKey = {};
    if (failure != nullptr) {
        m_panel.setError(failure->what, failure->remedy);
    } else if (m_made.report != nullptr) {
        emit told(m_made.report->complete ? tr("Ensemble simulated")
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

bool EnsembleDisplay::stale() const {
    return m_made.report != nullptr && !(m_key == keyNow());
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
    if (m_made.report != nullptr) {
        content.findings = m_made.report->findings;
    }
    m_panel.setContent(content);
}

void EnsembleDisplay::showPage() {
    widgets::EnsemblePage::Content content;
    content.report = m_made.report;
    content.map = m_map;
    if (m_map != nullptr) {
        content.place = pictureStyle(io::ensembleOrigin(*m_made.report, *m_map, m_made.frame, m_made.site, m_made.inputs));
    }
    content.stale = stale();
    content.running = running();
    m_page.setContent(content);
}

void EnsembleDisplay::showGround() {
    const bool shown = m_page.onGround() && m_map != nullptr && m_map->has(m_page.layer());
    if (!shown && m_ground == nullptr) {
        return;
    }
    m_ground = shown ? std::make_shared<const Orthophoto>(figures::groundPicture(*m_map, m_page.layer())) : nullptr;
    emit groundChanged();
}

void EnsembleDisplay::saveMap() {
    const QString path =
        QFileDialog::getSaveFileName(m_page.window(), tr("Map of the ensemble"),
                                     QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/probability.tif"),
                                     tr("GeoTIFF (*.tif);;Tables (*.csv);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveMapTo(path);
    }
}

void EnsembleDisplay::saveMapTo(const QString& path) {
    if (m_map == nullptr) {
        return;
    }
    const io::MapOrigin origin = io::ensembleOrigin(*m_made.report, *m_map, m_made.frame, m_made.site, m_made.inputs);
    m_computation.write([path, origin, map = m_map, layer = m_page.layer()](
                            const Execution& execution) { writeMapFile(path, *map, layer, origin, execution); },
                        [this, path](const std::exception_ptr& thrown) {
                            if (const auto failure = failureOf(thrown)) {
                                emit failed(failure->what, failure->remedy);
                            } else if (thrown == nullptr) {
                                emit told(tr("Saved %1").arg(QFileInfo(path).fileName()));
                            }
                        });
}

void EnsembleDisplay::saveTable() {
    const QString path = QFileDialog::getSaveFileName(m_page.window(), tr("Members of the ensemble"),
                                                      QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/members.csv"),
                                                      tr("Tables (*.csv)"));
    if (!path.isEmpty()) {
        saveTableTo(path);
    }
}

void EnsembleDisplay::saveTableTo(const QString& path) {
    if (m_made.report == nullptr) {
        return;
    }
    try {
        io::writeAtomically(path.toStdString(), [&](std::ostream& out) { writeMembersCsv(*m_made.report, out); });
        emit told(tr("Saved %1").arg(QFileInfo(path).fileName()));
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        emit failed(failure->what, failure->remedy);
    }
}

}  // namespace rubble
