#pragma once

#include <memory>

#include "core/clusters/clustering.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"

namespace rubble::render {

/// What a scene shows. Parts may be missing and arrive later: the FE result alone shows the FE pane (and the active structure in
/// the fragments pane); fragments without a trajectory stand at their birth place; a growing trajectory is followed.
struct SceneData {
    std::shared_ptr<const FeResult> fe;
    std::shared_ptr<const Components> components;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const Clustering> clustering;
    std::shared_ptr<const TrajectoryReader> trajectory;
    double groundHeight = 0.0;  ///< m

    friend bool operator==(const SceneData&, const SceneData&) = default;
};

}  // namespace rubble::render
