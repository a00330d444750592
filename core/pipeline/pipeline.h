#pragma once

#include <array>
#include <memory>

#include "core/base/execution.h"
#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fe/frame.h"
#include "core/fe/terrain_grid.h"
#include "core/fragments/fragment_set.h"
#include "core/scenario/scenario.h"
#include "core/scenario/stage.h"
#include "core/simulation/run/simulation.h"

namespace rubble {

/// What the pipeline works on.
struct Inputs {
    std::shared_ptr<const FeResult> fe;
    Frame frame;
    std::shared_ptr<const TerrainGrid> terrain = nullptr;  ///< in the local frame; null: none
};

/// Results by stage; parts are shared and immutable. A part is there if its stage has run, and its key says from what it was made.
struct Results {
    std::array<Digest, stageCount> keys{};
    std::array<double, stageCount> wallSeconds{};  ///< of the run that made the part
    std::shared_ptr<const Components> components;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Sizing> sizing;
    std::shared_ptr<const Clustering> clustering;
    std::shared_ptr<const SimulationResult> simulation;

    bool has(Stage stage) const;
};

/// Key of a stage: hash of stage version, build, input content and the scenario slices of this and all earlier stages. The terrain
/// counts from the simulation on: no earlier stage reads it.
Digest stageKey(const Inputs& inputs, const Scenario& scenario, Stage stage);

/// What a simulation of these results would run: parts up to the clusters must be there. For studies that simulate variations.
RunDescription describeRun(const Inputs& inputs, const Scenario& scenario, const Results& results);

/// Runs the pipeline up to a stage. A part of `previous` is reused when its key is unchanged; a reused simulation writes nothing to
/// the sink. Pure: the same arguments give the same results.
/// @param sink  takes the trajectory; may be null when last is before Simulation
/// @param checkpoints  of the simulation; null: none are kept
Results run(const Inputs& inputs, const Scenario& scenario, Stage last, const Results& previous, TrajectorySink* sink,
            const Execution& execution, CheckpointStore* checkpoints = nullptr);

}  // namespace rubble
