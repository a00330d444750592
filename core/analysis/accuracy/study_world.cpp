#include "core/analysis/accuracy/study_world.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/analysis/accuracy/settled_world.h"
#include "core/base/error.h"
#include "core/clusters/rejoin.h"

namespace rubble {

namespace {

void checkSettings(const StudySettings& settings) {
    if (settings.repeats < 1 || !(settings.birthShift > 0.0) || !std::isfinite(settings.birthShift) || settings.threads < 0) {
        throw UsageError({"analysis.study", "A repeat floor takes at least 1 repeat and a birth shift above zero.", {}},
                         {"analysis.study.remedy", "2 repeats and 1e-6 m are usual.", {}});
    }
}

}  // namespace

StudyBase beginStudy(const Inputs& inputs, const Scenario& scenario, const StudySettings& settings, const Execution& execution) {
    checkSettings(settings);
    StudyBase base;
    base.inputs = inputs;
    base.scenario = scenario;
    base.results = run(inputs, scenario, Stage::Clusters, {}, nullptr, execution);
    base.plan = CollapsePlan(*base.results.fragments, inputs.fe->mesh());
    base.decisions = decideUnder(base, scenario);
    const bool onTerrain = base.decisions[static_cast<std::size_t>(EffectKind::Terrain)].on;
    base.ground = {true, scenario.simulation.groundHeight, onTerrain ? inputs.terrain : nullptr};
    return base;
}

EffectDecisions decideUnder(const StudyBase& base, const Scenario& scenario) {
    return decideEffects({*base.inputs.fe, *base.results.components, *base.results.fragments, *base.results.clustering,
                          base.inputs.terrain.get(), scenario});
}

RunDescription describeBase(const StudyBase& base) {
    return describeRun(base.inputs, base.scenario, base.results);
}

RunDescription describeRepeat(const RepeatedRun& run, double birthShift, int repeat, const Execution& execution) {
    assert(repeat > 0);
    Scenario shifted = run.scenario;
    shifted.fragments.birthShift = std::max(shifted.fragments.birthShift, birthShift);
    shifted.fragments.seed += repeat;
    Results results = run.results;
    results.fragments =
        std::make_shared<const FragmentSet>(makeFragments(*run.inputs.fe, *run.results.components, shifted.fragments, execution));
    results.clustering = std::make_shared<const Clustering>(rejoinClusters(*run.results.clustering, *results.fragments));
    return describeRun(run.inputs, shifted, results);
}

SimulatedWorld simulateDebris(const RunDescription& description, const Execution& execution, CheckpointStore* checkpoints) {
    return simulateSettled(description, execution, checkpoints).world;
}

StudyWorld measureWorld(const SimulatedWorld& world, const StudyBase& base, const StudySettings& settings) {
    StudyWorld measured;
    measured.trajectoryHash = world.trajectoryHash;
    measured.endTime = world.endTime;
    measured.wallSeconds = world.wallSeconds;
    measured.breaches = world.breaches;
    measured.field = measureDebris(world.debris(settings.instant), base.plan, base.ground, settings.measures);
    return measured;
}

StudyWorld simulateWorld(const RunDescription& description, const StudyBase& base, const StudySettings& settings,
                         const Execution& execution) {
    return measureWorld(simulateDebris(description, execution), base, settings);
}

}  // namespace rubble
