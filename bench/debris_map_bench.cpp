#include <benchmark/benchmark.h>

#include "core/evidence/maps/debris_map.h"
#include "tests/samples/arches.h"

namespace rubble {
namespace {

/// Every fragment of the stone arch where it was handed over: the bridge in the air, layer over layer, which is more to lay on a
/// grid than the pile that becomes of it.
std::vector<MapPiece> archPieces() {
    std::vector<MapPiece> pieces;
    for (const Fragment& fragment : arches::stoneArch().fragments.list) {
        MapPiece& piece = pieces.emplace_back();
        piece.box = fragment.box;
        piece.centre = fragment.centre;
        piece.mass = fragment.mass;
        piece.volume = fragment.box.volume();
        piece.component = static_cast<std::uint32_t>(at(fragment.component));
        piece.arrival = fragment.birthTime;
        piece.impactEnergy = fragment.mass;
    }
    return pieces;
}

/// @param state  range 0: side of the cells, mm
void mapOfTheStoneArch(benchmark::State& state) {
    static const std::vector<MapPiece> pieces = archPieces();
    MapSettings settings;
    settings.cell = static_cast<double>(state.range(0)) * 1e-3;
    std::size_t cells = 0;
    for (auto _ : state) {
        const DebrisMap map = makeDebrisMap(0.0, pieces, true, nullptr, {}, SiteSurface{}, settings, Execution());
        cells = map.cells.size();
        benchmark::DoNotOptimize(map.cells.data());
    }
    state.counters["fragments"] = static_cast<double>(pieces.size());
    state.counters["cells"] = static_cast<double>(cells);
}

BENCHMARK(mapOfTheStoneArch)
    ->Name("debris map of the stone arch")
    ->Arg(1000)
    ->Arg(250)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace rubble
