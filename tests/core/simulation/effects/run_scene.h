#pragma once

#include <memory>

#include "core/pipeline/pipeline.h"
#include "core/trajectory/trajectory.h"

namespace rubble::test {

/// Everything before the simulation of a scene.
inline RunDescription describe(std::shared_ptr<const FeResult> fe, const Scenario& scenario) {
    const Results results = run({fe, {}}, scenario, Stage::Clusters, {}, nullptr, Execution());
    RunDescription description;
    description.fe = std::move(fe);
    description.scenario = scenario;
    description.components = results.components;
    description.fragments = results.fragments;
    description.sizing = results.sizing;
    description.clustering = results.clustering;
    return description;
}

}  // namespace rubble::test
