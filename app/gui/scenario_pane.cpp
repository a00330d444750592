#include "app/gui/scenario_pane.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "app/gui/computation.h"
#include "app/gui/document.h"
#include "app/gui/view_area.h"
#include "widgets/scenario_bar.h"

namespace rubble {

namespace {

render::SceneData sceneOf(const RunRecord& record, const Inputs& inputs) {
    render::SceneData scene;
    scene.fe = inputs.fe;
    scene.components = record.results.components;
    scene.fragments = record.results.fragments;
    scene.clustering = record.results.clustering;
    scene.trajectory = record.reader;
    scene.setSurroundings(record.scenario, inputs.terrain, record.outcome.get());
    return scene;
}

}  // namespace

ScenarioPane::ScenarioPane(Document& document, Computation& computation, ViewArea& area, QObject* parent)
    : QObject(parent), m_document(document), m_computation(computation), m_area(area) {
    connect(&computation, &Computation::otherRunsChanged, this, &ScenarioPane::refresh);
    connect(&area.scenarioBar(), &widgets::ScenarioBar::scenarioChosen, this, &ScenarioPane::choose);
    connect(&area.scenarioBar(), &widgets::ScenarioBar::openRequested, this, &ScenarioPane::openKept);
}

void ScenarioPane::setShown(bool shown) {
    m_area.scenarioBar().setVisible(shown);
}

void ScenarioPane::choose(const QString& scenario) {
    m_chosen = scenario;
    refresh({});
}

void ScenarioPane::refresh(const QString& newest) {
    m_chosen = newest.isEmpty() ? m_chosen : newest;
    QStringList names;
    const RunRecord* chosen = nullptr;
    for (const auto& run : m_computation.otherRuns()) {
        names << run->scenarioName;
        chosen = run->scenarioName == m_chosen ? run.get() : chosen;
    }
    m_area.scenarioBar().setScenarios(names, chosen != nullptr ? m_chosen : QString());
    m_area.views().setOther(chosen != nullptr ? sceneOf(*chosen, m_computation.inputs()) : render::SceneData(),
                            chosen != nullptr ? m_chosen.toStdString() : std::string());
}

void ScenarioPane::openKept() {
    const QString path = QFileDialog::getOpenFileName(&m_area, tr("Open a kept run"), QFileInfo(m_document.base()).absolutePath(),
                                                      tr("Runs (*.run.h5);;All files (*)"));
    if (!path.isEmpty()) {
        m_computation.openOther(path);
    }
}

}  // namespace rubble
