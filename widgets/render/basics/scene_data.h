#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/clusters/clustering.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fe/loose_structure.h"
#include "core/fe/orthophoto.h"
#include "core/fe/site_mesh.h"
#include "core/fe/terrain_grid.h"
#include "core/fragments/fragment_set.h"
#include "core/scenario/scenario.h"
#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"
#include "widgets/render/basics/site_points.h"

namespace rubble::render {

/// What a scene shows. Parts may be missing and arrive later: the FE result alone shows the FE pane (and the active structure in
/// the fragments pane); fragments without a trajectory stand at their birth place; a growing trajectory is followed.
struct SceneData {
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<const Components> components;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Clustering> clustering;
    std::shared_ptr<const TrajectoryReader> trajectory;
    std::shared_ptr<const TrajectoryReader> reference;          ///< of the same fragments, each its own body: errors are against it
    std::shared_ptr<const LooseStructure> loose;                ///< of the FE result, for colours; null: not known
    double groundHeight = 0.0;                                  ///< m
    std::shared_ptr<const TerrainGrid> terrain;                 ///< drawn instead of the level ground; null: none
    std::optional<double> waterLevel;                           ///< m, drawn in the fragments pane; unset: no water
    std::shared_ptr<const Orthophoto> orthophoto;               ///< draped over the ground; null: none
    std::shared_ptr<const std::vector<SiteMesh>> surroundings;  ///< null: none
    std::shared_ptr<const SitePoints> points;                   ///< of a cloud, as the view needs them; null: none
    std::set<std::string> givenMaterials;  ///< components whose material somebody named; of others it is guessed

    /// Ground, terrain, water and named materials as a run has them: what was off in it is not shown. Before a run's outcome is
    /// known everything is shown that is not switched off.
    void setSurroundings(const Scenario& scenario, std::shared_ptr<const TerrainGrid> terrain, const SimulationResult* outcome);

    /// The material of a component is but a guess from its density.
    bool materialAssumed(const std::string& component) const { return !givenMaterials.contains(component); }

    friend bool operator==(const SceneData&, const SceneData&) = default;
};

}  // namespace rubble::render
