#pragma once

#include <memory>

#include "core/pipeline/pipeline.h"
#include "widgets/render/basics/scene_data.h"

namespace rubble::render {

/// A run as a scene.
struct RunOfScene {
    const Scenario* scenario = nullptr;  ///< that it was made with
    std::shared_ptr<const TrajectoryReader> trajectory;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Clustering> clustering;
    const SimulationResult* outcome = nullptr;  ///< null: it is not complete
};

/// A run on what it was made from, with its components by its own settings, without orthophoto and surroundings.
SceneData sceneOf(const Inputs& inputs, const RunOfScene& run);

}  // namespace rubble::render
