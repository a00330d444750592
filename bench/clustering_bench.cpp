#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <random>
#include <vector>

#include "core/clusters/clustering.h"
#include "core/clusters/fragment_order.h"
#include "core/clusters/grid_outline.h"
#include "core/clusters/grid_sizer.h"
#include "core/clusters/partition.h"
#include "core/clusters/sizing.h"
#include "tests/core/clusters/matrix_oracle.h"
#include "tests/samples/arches.h"

namespace rubble {
namespace {

/// The intervals of one birth along one axis.
struct AxisOfBirth {
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> centre;
    std::vector<std::int64_t> id;
    double size = 0.0;
};

/// All births of the stone arch along all axes, at a multiple of the mean distances.
std::vector<AxisOfBirth> stoneArchAxes(double multiple) {
    const arches::Arch& arch = arches::stoneArch();
    const std::vector<Vec3> centres = orderingCentres(arch.fragments);
    GridSettings settings;
    settings.multiple = multiple;
    const Sizing sizing = sizeBasicGrid(arch.fragments, arch.mesh(), arch.components, settings, Execution());
    std::map<std::pair<std::uint32_t, int>, AxisOfBirth> axes;
    for (std::size_t f = 0; f < arch.fragments.size(); ++f) {
        const Fragment& fragment = arch.fragments.list[f];
        for (int axis = 0; axis < 3; ++axis) {
            AxisOfBirth& set = axes[{fragment.handOverState, axis}];
            set.low.push_back(fragment.bounds.min()[axis]);
            set.high.push_back(fragment.bounds.max()[axis]);
            set.centre.push_back(centres[f][axis]);
            set.id.push_back(arch.mesh().elementIds[at(fragment.element)]);
            set.size = sizing.axis[static_cast<std::size_t>(axis)].size;
        }
    }
    std::vector<AxisOfBirth> list;
    for (auto& [key, set] : axes) {
        list.push_back(std::move(set));
    }
    return list;
}

double seconds(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Every birth along every axis, sorting included: ours and the matrix in the same run. Time is ours; the counters tell the rest.
void groupingAgainstTheMatrix(benchmark::State& state) {
    const std::vector<AxisOfBirth> axes = stoneArchAxes(static_cast<double>(state.range(0)) / 10.0);
    double ours = 0.0;
    double matrix = 0.0;
    for (auto _ : state) {
        const double fast = seconds([&] {
            for (const AxisOfBirth& set : axes) {
                benchmark::DoNotOptimize(groupAlongAxis(set.low, set.high, set.centre, set.id, set.size));
            }
        });
        matrix += seconds([&] {
            for (const AxisOfBirth& set : axes) {
                benchmark::DoNotOptimize(matrixGroups(set.low, set.high, set.centre, set.id, set.size));
            }
        });
        state.SetIterationTime(fast);
        ours += fast;
    }
    state.counters["matrix_ms"] = 1e3 * matrix / static_cast<double>(state.iterations());
    state.counters["ratio"] = matrix / ours;
}
BENCHMARK(groupingAgainstTheMatrix)
    ->Name("stone arch, groups along axes (10 x multiple)")
    ->Arg(15)
    ->Arg(20)
    ->Arg(30)
    ->Arg(55)
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

/// Blocks of unequal size, five to a metre, at a grid of 2 m: how the time grows with their number. `wide` percent of them are
/// wider than the grid, which asks for counts in two dimensions.
void growingSets(benchmark::State& state, unsigned wide) {
    std::mt19937 random(1);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    AxisOfBirth set;
    for (std::int64_t i = 0; i < state.range(0); ++i) {
        const double low = 0.2 * unit() * static_cast<double>(state.range(0));
        const double width = random() % 100 < wide ? 2.0 + 3.0 * unit() : 0.5 + unit();
        set.low.push_back(low);
        set.high.push_back(low + width);
        set.centre.push_back(low + 0.5 * width);
        set.id.push_back(i);
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(groupAlongAxis(set.low, set.high, set.centre, set.id, 2.0));
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK_CAPTURE(growingSets, none, 0u)
    ->Name("groups of n blocks")
    ->RangeMultiplier(8)
    ->Range(1 << 10, 1 << 19)
    ->Complexity(benchmark::oNLogN)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(growingSets, half, 50u)
    ->Name("groups of n blocks, half of them wider than the grid")
    ->RangeMultiplier(8)
    ->Range(1 << 10, 1 << 19)
    ->Complexity(benchmark::oNLogN)
    ->Unit(benchmark::kMillisecond);

/// Everything from fragments to clusters at one grid, all birth times.
void makingClusters(benchmark::State& state) {
    const arches::Arch& arch = arches::stoneArch();
    GridSettings settings;
    settings.multiple = static_cast<double>(state.range(0)) / 10.0;
    const BasicGrid grid = sizeBasicGrid(arch.fragments, arch.mesh(), arch.components, settings, Execution()).grid;
    std::size_t clusters = 0;
    for (auto _ : state) {
        clusters = makeClusters(arch.fragments, arch.mesh(), grid, settings, Execution()).list.size();
    }
    state.counters["clusters"] = static_cast<double>(clusters);
}
BENCHMARK(makingClusters)->Name("stone arch, clusters (10 x multiple)")->Arg(20)->Arg(55)->Unit(benchmark::kMillisecond);

/// The count at another grid, as the panel asks for while a slider moves.
void countingAgain(benchmark::State& state) {
    const arches::Arch& arch = arches::stoneArch();
    Partitioner partitioner(arch.fragments, arch.mesh());
    double multiple = 2.0;
    for (auto _ : state) {
        multiple = multiple < 5.0 ? multiple + 0.05 : 2.0;
        benchmark::DoNotOptimize(partitioner.at({1.08 * multiple, 0.74 * multiple, 1.1 * multiple}, {}, Execution()).clusters());
    }
}
BENCHMARK(countingAgain)->Name("stone arch, count at another grid")->Unit(benchmark::kMillisecond);

/// All that the Basic Grid panel waits for at one place of its slider: bounds, count, findings, and the lines of the drawn grid.
void sizingAtTheSlider(benchmark::State& state) {
    const arches::Arch& arch = arches::mergedStoneArch();
    GridSizer sizer(arch.fragments, arch.mesh(), arch.components);
    GridSettings settings;
    settings.multiple = 2.0;
    double worst = 0.0;
    for (auto _ : state) {
        settings.multiple = *settings.multiple < 8.0 ? *settings.multiple + 0.05 : 0.5;
        worst = std::max(worst, seconds([&] {
                             const BasicGrid grid = sizer.size(settings, Execution()).grid;
                             benchmark::DoNotOptimize(gridOutline(arch.fragments, {grid.l, grid.w, grid.h}));
                         }));
    }
    state.counters["fragments"] = static_cast<double>(arch.fragments.size());
    state.counters["worst_ms"] = 1e3 * worst;
}
BENCHMARK(sizingAtTheSlider)->Name("stone arch, slider of the grid panel")->Unit(benchmark::kMillisecond);

void searching(benchmark::State& state, const arches::Arch& (*arch)()) {
    const arches::Arch& a = arch();
    std::size_t clusters = 0;
    for (auto _ : state) {
        clusters = sizeBasicGrid(a.fragments, a.mesh(), a.components, {}, Execution()).clusters;
    }
    state.counters["clusters"] = static_cast<double>(clusters);
}
BENCHMARK_CAPTURE(searching, stoneArch, &arches::stoneArch)->Name("stone arch, search for the grid")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(searching, mergedStoneArch, &arches::mergedStoneArch)
    ->Name("stone arch with strips merged, search for the grid")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(searching, rcArch, &arches::rcArch)->Name("RC arch, search for the grid")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
