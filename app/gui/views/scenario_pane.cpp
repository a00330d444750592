#include "app/gui/views/scenario_pane.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "app/gui/session/session.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/island_display.h"
#include "widgets/views/scenario_bar.h"

namespace rubble {

namespace {

render::SceneData sceneOf(const RunRecord& record, const Inputs& inputs, const IslandDisplay& islands) {
    render::SceneData scene;
    scene.fe = inputs.fe;
    scene.components = record.results.components;
    scene.fragments = record.results.fragments;
    scene.clustering = record.results.clustering;
    scene.trajectory = record.reader;
    scene.loose = islands.looseOf(record.scenario);
    scene.setSurroundings(record.scenario, inputs.terrain, record.outcome.get());
    return scene;
}

}  // namespace

ScenarioPane::ScenarioPane(Session& session, ViewArea& area, const IslandDisplay& islands, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_area(area),
      m_islands(islands),
      m_kept(session.part<Kept>()) {
    connect(&m_computation, &Computation::otherRunsChanged, this, &ScenarioPane::refresh);
    connect(&islands, &IslandDisplay::changed, this, [this] { refresh({}); });
    connect(&area.scenarioBar(), &widgets::ScenarioBar::scenarioChosen, this, &ScenarioPane::choose);
    connect(&area.scenarioBar(), &widgets::ScenarioBar::openRequested, this, &ScenarioPane::openKept);
    refresh({});
}

void ScenarioPane::setShown(bool shown) {
    m_area.scenarioBar().setVisible(shown);
}

void ScenarioPane::choose(const QString& scenario) {
    m_kept.chosen = scenario;
    refresh({});
}

void ScenarioPane::refresh(const QString& newest) {
    if (!newest.isEmpty()) {
        m_kept.chosen = newest;
    }
    QStringList names;
    const RunRecord* chosen = nullptr;
    for (const auto& run : m_computation.otherRuns()) {
        names << run->scenarioName;
        if (run->scenarioName == m_kept.chosen) {
            chosen = run.get();
        }
    }
    m_area.scenarioBar().setScenarios(names, chosen != nullptr ? m_kept.chosen : QString());
    m_area.views().setOther(chosen != nullptr ? sceneOf(*chosen, m_computation.inputs(), m_islands) : render::SceneData(),
                            chosen != nullptr ? m_kept.chosen.toStdString() : std::string());
}

void ScenarioPane::openKept() {
    const QString path = QFileDialog::getOpenFileName(&m_area, tr("Open a kept run"), QFileInfo(m_document.base()).absolutePath(),
                                                      tr("Runs (*.run.h5);;All files (*)"));
    if (!path.isEmpty()) {
        m_computation.openOther(path);
    }
}

}  // namespace rubble
