#pragma once

#include "core/fe/fe_result.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// The collision shape of a cluster of so many fragments: bodies of a table keep their own, else it is as the scenario says.
inline ClusterShape shapeOfCluster(const FeResult& fe, const Scenario& scenario, std::size_t fragments) {
    return fe.contents().looseBodies && fragments > 1 ? ClusterShape::Hull : shapeOfClusters(scenario);
}

}  // namespace rubble
