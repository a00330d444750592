#include "core/analysis/accuracy/machine_speed.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <vector>

#include "core/analysis/accuracy/calibration.h"
#include "core/base/elapsed.h"
#include "core/pipeline/pipeline.h"

namespace rubble {

namespace {

constexpr std::int64_t probeBodies = 343;
constexpr double probeSettles = 2.0;  // s
// Collapses of the samples lie within these of what the pile says: shapes, heaps and water cost more, what rests early less.
constexpr double atLeast = 1.0 / 3.0;
constexpr double atMost = 3.0;
constexpr double besideStructure = 2.5;  // of a step in which loose structure moves, over one of fragments alone

}  // namespace

MachineSpeed measureMachineSpeed(const Execution& execution) {
    auto [inputs, scenario] = pileScene(PileKind::Typical, probeBodies);
    scenario.simulation.settleTime = probeSettles;
    const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, execution);
    MemoryTrajectory trajectory;
    const auto start = std::chrono::steady_clock::now();
    const SimulationResult result = simulate(describeRun(inputs, scenario, results), trajectory, execution);
    const double wall = secondsSince(start);
    RunTimeLeft::Course course;
    course.first = result.firstTime;
    course.end = result.endTime;
    for (const Cluster& cluster : results.clustering->list) {
        course.births.push_back(cluster.handOverTime);
    }
    const double span = std::max(result.endTime - result.firstTime, 1e-9);
    return {wall / RunTimeLeft(std::move(course)).work(), static_cast<double>(result.steps) / span, result.substeps};
}

MachineSpeed machineSpeed(const Execution& execution) {
    static std::mutex access;
    static std::map<int, MachineSpeed> measured;
    {
        const std::lock_guard lock(access);
        if (const auto found = measured.find(execution.threads()); found != measured.end()) {
            return found->second;
        }
    }
    const MachineSpeed speed = measureMachineSpeed(execution);
    const std::lock_guard lock(access);
    return measured.emplace(execution.threads(), speed).first->second;
}

Prediction crudeWallSeconds(const FragmentSet& fragments, std::int64_t bodies, double feEnd, const Scenario& scenario,
                            const MachineSpeed& speed, bool structure) {
    Prediction prediction;
    if (fragments.list.empty() || bodies <= 0) {
        prediction.reason = {"prediction.no_fragments", "there are no fragments", {}};
        return prediction;
    }
    std::vector<double> births;
    for (const Fragment& fragment : fragments.list) {
        births.push_back(fragment.handOverTime);
    }
    std::sort(births.begin(), births.end());
    RunTimeLeft::Course course;
    course.first = births.front();
    course.end = feEnd + scenario.simulation.settleTime;
    // Bodies are taken to be born as their fragments are.
    for (std::int64_t i = 0; i < bodies; ++i) {
        course.births.push_back(births[static_cast<std::size_t>(i) * births.size() / static_cast<std::size_t>(bodies)]);
    }
    double steps = scenario.simulation.stepRate ? *scenario.simulation.stepRate / speed.stepRate : 1.0;
    if (scenario.simulation.solver == SolverKind::SoftStep) {
        steps *= static_cast<double>(substepsOf(scenario)) / speed.substeps;
    }
    if (structure) {
        steps *= besideStructure;
    }
    prediction.known = true;
    prediction.fromSpeed = true;
    prediction.value = RunTimeLeft(std::move(course)).work() * speed.secondsPerWork * std::max(0.25, steps);
    prediction.low = prediction.value * atLeast;
    prediction.high = prediction.value * atMost;
    return prediction;
}

}  // namespace rubble
