#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "core/base/build.h"
#include "core/base/elapsed.h"
#include "core/clusters/body_clusters.h"
#include "core/fe/loose_bodies.h"
#include "core/pipeline/stage_reports.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

/// One run of the pipeline: makes each part or takes it over, and keeps the account of keys and times.
class PipelineRun {
public:
    PipelineRun(const Inputs& inputs, const Scenario& scenario, const Results& previous, const Execution& execution,
                const StageObserver& observer)
        : m_inputs(inputs), m_scenario(scenario), m_previous(previous), m_execution(execution), m_observer(observer) {}

    template <class Part, class Make>
    void stage(Stage stage, std::shared_ptr<const Part> Results::* part, Make make) {
        m_execution.check();
        if (m_observer.begins) {
            m_observer.begins(stage);
        }
        const std::size_t i = static_cast<std::size_t>(stage);
        results.keys[i] = stageKey(m_inputs, m_scenario, stage);
        if (m_previous.*part && m_previous.keys[i] == results.keys[i]) {
            results.*part = m_previous.*part;
            results.wallSeconds[i] = m_previous.wallSeconds[i];
        } else {
            const auto start = std::chrono::steady_clock::now();
            results.*part = std::make_shared<const Part>(make());
            results.wallSeconds[i] = secondsSince(start);
        }
        if (m_observer.made) {
            m_observer.made(stage, results);
        }
    }

    Results results;

private:
    const Inputs& m_inputs;
    const Scenario& m_scenario;
    const Results& m_previous;
    const Execution& m_execution;
    const StageObserver& m_observer;
};

}  // namespace

bool Results::has(Stage stage) const {
    switch (stage) {
        case Stage::Import:
            return keys[0] != Digest{};
        case Stage::Components:
            return components != nullptr;
        case Stage::Fragments:
            return fragments != nullptr;
        case Stage::Sizing:
            return sizing != nullptr;
        case Stage::Clusters:
            return clustering != nullptr;
        case Stage::Simulation:
            return simulation != nullptr;
    }
    return false;
}

Findings stageFindings(const Results& results) {
    Findings all;
    const auto append = [&all](const auto& part) {
        if (part) {
            all.append(part->findings);
        }
    };
    append(results.components);
    append(results.fragments);
    append(results.sizing);
    append(results.clustering);
    append(results.simulation);
    return all;
}

Digest stageKey(const Inputs& inputs, const Scenario& scenario, Stage stage) {
    assert(inputs.fe);
    Hasher hasher;
    hasher.text(buildText()).digest(inputs.fe->contents().fingerprint);
    for (int i = 0; i <= static_cast<int>(stage); ++i) {
        hasher.digest(scenarioSlice(scenario, static_cast<Stage>(i)));
    }
    if (stage >= Stage::Simulation && inputs.terrain) {
        hasher.text("terrain").digest(inputs.terrain->digest());
    }
    return hasher.finish();
}

RunDescription describeRun(const Inputs& inputs, const Scenario& scenario, const Results& results) {
    assert(results.has(Stage::Clusters));
    RunDescription description;
    description.fe = inputs.fe;
    description.terrain = inputs.terrain;
    description.scenario = scenario;
    description.components = results.components;
    description.fragments = results.fragments;
    description.sizing = results.sizing;
    description.clustering = results.clustering;
    description.fingerprint = stageKey(inputs, scenario, Stage::Simulation);
    return description;
}

Results run(const Inputs& inputs, const Scenario& scenario, Stage last, const Results& previous, TrajectorySink* sink,
            const Execution& execution, CheckpointStore* checkpoints) {
    return run(inputs, scenario, last, previous, sink, execution, checkpoints, StageObserver());
}

Results run(const Inputs& inputs, const Scenario& scenario, Stage last, const Results& previous, TrajectorySink* sink,
            const Execution& execution, CheckpointStore* checkpoints, const StageObserver& observer) {
    assert(inputs.fe);
    assert(sink || last < Stage::Simulation);
    const FeResult& fe = *inputs.fe;
    PipelineRun pipeline(inputs, scenario, previous, execution, observer);
    Results& results = pipeline.results;
    results.keys[0] = stageKey(inputs, scenario, Stage::Import);
    results.wallSeconds[0] = previous.wallSeconds[0];

    if (last >= Stage::Components) {
        pipeline.stage(Stage::Components, &Results::components,
                       [&] { return groupComponents(fe.mesh(), scenario.regrouping, scenario.components, scenario.assumptions); });
    }
    if (last >= Stage::Fragments) {
        pipeline.stage(Stage::Fragments, &Results::fragments,
                       [&] { return makeFragments(fe, *results.components, scenario.fragments, execution); });
    }
    if (last >= Stage::Sizing) {
        pipeline.stage(Stage::Sizing, &Results::sizing, [&] {
            Sizing sizing = sizeBasicGrid(*results.fragments, fe.mesh(), *results.components, scenario.grid, execution);
            if (const std::vector<std::uint32_t> bodies = bodiesOfTable(fe); !bodies.empty()) {
                // No grid divides the bodies of a table.
                sizing.clusters = makeBodyClusters(*results.fragments, bodies).list.size();
                sizing.awake = std::min(sizing.awake, sizing.clusters);
            }
            return sizing;
        });
    }
    if (last >= Stage::Clusters) {
        pipeline.stage(Stage::Clusters, &Results::clustering, [&] {
            const std::vector<std::uint32_t> bodies = bodiesOfTable(fe);
            return bodies.empty() ? makeClusters(*results.fragments, fe.mesh(), results.sizing->grid, scenario.grid, execution)
                                  : makeBodyClusters(*results.fragments, bodies);
        });
    }
    if (last >= Stage::Simulation) {
        pipeline.stage(Stage::Simulation, &Results::simulation,
                       [&] { return simulate(describeRun(inputs, scenario, results), *sink, execution, checkpoints); });
    }
    return std::move(pipeline.results);
}

}  // namespace rubble
