#pragma once

#include <cmath>

#include "core/clusters/sizing.h"
#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// The collision shape of a cluster of so many fragments: bodies of a table keep their own, else it is as the scenario says.
inline ClusterShape shapeOfCluster(const FeResult& fe, const Scenario& scenario, std::size_t fragments) {
    return fe.contents().looseBodies && fragments > 1 ? ClusterShape::Hull : shapeOfClusters(scenario);
}

/// m: bricks of bodies and pieces are joined up to this length even where they leave gaps. Debris is as coarse as the Basic Grid,
/// so a mesh far finer than it gives no more boxes than one that suits it. 0 where every fragment is its own body, or nothing was
/// sized.
inline double finestBrick(const Sizing* sizing) {
    constexpr double shareOfCell = 0.4;
    if (!sizing) {
        return 0.0;
    }
    double cell = 1.0;
    for (const AxisSizing& axis : sizing->axis) {
        cell *= axis.size;
    }
    return shareOfCell * std::cbrt(cell);
}

}  // namespace rubble
