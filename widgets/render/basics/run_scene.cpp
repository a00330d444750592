#include "widgets/render/basics/run_scene.h"

namespace rubble::render {

SceneData sceneOf(const Inputs& inputs, const RunOfScene& run) {
    const Scenario& scenario = *run.scenario;
    SceneData data;
    data.fe = inputs.fe;
    data.components = std::make_shared<const Components>(
        groupComponents(inputs.fe->mesh(), scenario.regrouping, scenario.components, scenario.assumptions));
    data.fragments = run.fragments;
    data.clustering = run.clustering;
    data.trajectory = run.trajectory;
    data.setSurroundings(scenario, inputs.terrain, run.outcome);
    return data;
}

}  // namespace rubble::render
