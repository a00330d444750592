#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "bench/no_sink.h"
#include "core/analysis/debris/debris.h"
#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/simulation/run/collapse_run.h"
#include "core/validation/box_overlap.h"
#include "tests/samples/arches.h"

namespace rubble {
namespace {

/// The stone arch of the sample case, clustered, or every fragment its own body.
RunDescription clusteredArch(PieceKind pieces, bool reference = false) {
    const arches::Arch& arch = arches::mergedStoneArch();
    RunDescription description;
    description.fe = arch.fe;
    description.scenario.simulation.pieces = pieces;
    description.scenario.simulation.settleTime = 0.0;
    description.scenario.grid.oneBodyPerFragment = reference;
    description.components = std::make_shared<Components>(arch.components);
    description.fragments = std::make_shared<FragmentSet>(arch.fragments);
    const GridSettings& grid = description.scenario.grid;
    const Execution execution;
    description.sizing = std::make_shared<Sizing>(sizeBasicGrid(arch.fragments, arch.mesh(), arch.components, grid, execution));
    description.clustering =
        std::make_shared<Clustering>(makeClusters(arch.fragments, arch.mesh(), description.sizing->grid, grid, execution));
    return description;
}

void count(benchmark::State& state, const SimulationResult& result) {
    state.counters["bodies"] = static_cast<double>(result.bodiesPeak);
    state.counters["ms/step"] = result.stepTimes.meanMs;
    state.counters["p95 ms"] = result.stepTimes.p95Ms;
    state.counters["worst ms"] = result.stepTimes.worstMs;
    state.counters["in time"] = result.stepTimes.shareInTime;
    state.counters["real time"] = result.stepTimes.realTimeFactor;
}

/// Plain Bullet defaults on the same bodies: 60 steps a second, its islands and sleeping, no rest offsets, no freeze, no limits.
SimulationResult plainRun(RunDescription description, TrajectorySink& sink, const Execution& execution) {
    description.scenario.simulation.stepRate = 60.0;
    return simulateIn(makePlainBulletWorld, description, sink, execution);
}

void countPlain(benchmark::State& state, const SimulationResult& plain, const SimulationResult& ours) {
    state.counters["plain ms/step"] = plain.stepTimes.meanMs;
    state.counters["plain over ours"] = ours.stepTimes.realTimeFactor / plain.stepTimes.realTimeFactor;
}

/// The whole collapse, ours and then plain Bullet's, with the ratio of their times from the first to the last birth. `pieces` as in
/// PieceKind.
void clusteredCollapse(benchmark::State& state, PieceKind pieces) {
    const RunDescription description = clusteredArch(pieces);
    NoSink sink;
    const Execution execution;
    for (auto _ : state) {
        const SimulationResult ours = simulate(description, sink, execution);
        const SimulationResult plain = plainRun(description, sink, execution);
        count(state, ours);
        countPlain(state, plain, ours);
    }
}

/// Wall time of some work, s.
template <typename Work>
double secondsOf(Work work) {
    const auto from = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

/// The pile at the end of a run, by a measure of our own on the fragments' boxes: no engine is the judge of itself.
void countPile(benchmark::State& state, const std::string& whose, const DebrisRecorder& recorder) {
    double mass = 0.0, moment = 0.0;
    std::vector<OrientedBox> boxes;
    for (const DebrisFragment& fragment : recorder.debris(DebrisInstant::AtRest).fragments) {
        if (fragment.present) {
            mass += fragment.mass;
            moment += fragment.mass * fragment.centre.z();
            boxes.push_back(fragment.box);
        }
    }
    const OverlapMeasure overlap = measureOverlap(boxes);
    state.counters[whose + " mean height m"] = moment / mass;
    state.counters[whose + " overlap p99 m"] = overlap.p99;
    state.counters[whose + " overlap deepest m"] = overlap.deepest;
    state.counters[whose + " beyond 5 %"] = static_cast<double>(overlap.beyondFive);
}

/// Every fragment its own body: the time of a step, and of the run to 2 s after the FE end, when most has landed, and the pile
/// there, ours and plain Bullet's.
void referenceCollapse(benchmark::State& state, PieceKind pieces) {
    RunDescription description = clusteredArch(pieces, true);
    description.scenario.simulation.settleTime = 2.0;
    // Boxes of fragments, by which the pile is judged, are then what the engine has, and not bricks of their volume.
    description.scenario.effects.loose = LooseStructurePolicy::Fe;
    const Execution execution;
    for (auto _ : state) {
        DebrisRecorder pile, plainPile;
        SimulationResult ours, plain;
        const double oursSeconds = secondsOf([&] { ours = simulate(description, pile, execution); });
        const double plainSeconds = secondsOf([&] { plain = plainRun(description, plainPile, execution); });
        count(state, ours);
        countPlain(state, plain, ours);
        state.counters["run s"] = oursSeconds;
        state.counters["plain run s"] = plainSeconds;
        state.counters["plain run over ours"] = plainSeconds / oursSeconds;
        countPile(state, "ours", pile);
        countPile(state, "plain", plainPile);
    }
}
BENCHMARK_CAPTURE(referenceCollapse, none, PieceKind::None)
    ->Name("stone arch, reference without pieces")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

BENCHMARK_CAPTURE(clusteredCollapse, grid, PieceKind::GridBoxes)
    ->Name("stone arch, clustered collapse with pieces")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(clusteredCollapse, none, PieceKind::None)
    ->Name("stone arch, clustered collapse without pieces")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace rubble
