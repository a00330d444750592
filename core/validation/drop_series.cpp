#include "core/validation/drop_series.h"

#include <chrono>

#include "core/analysis/accuracy/world_pool.h"
#include "core/base/elapsed.h"
#include "core/scenario/parameters.h"
#include "core/simulation/effects/terrain.h"

namespace rubble {

namespace {

SiteSurface surfaceOf(const std::shared_ptr<const TerrainGrid>& given, const Scenario& scenario) {
    const EffectSettings& effects = scenario.effects;
    const bool terrain = given && effects.of(EffectKind::Terrain) != EffectSwitch::Off;
    return {effects.of(EffectKind::Ground) != EffectSwitch::Off, scenario.simulation.groundHeight,
            terrain ? roughTerrain(given, effects) : nullptr};
}

}  // namespace

SiteSurface surfaceOf(const DropSeries& series) {
    return surfaceOf(series.terrain, series.scenario);
}

DropRepeat dropOnce(const DropSeries& series, std::int64_t repeat, const Execution& execution) {
    const auto begun = std::chrono::steady_clock::now();
    DropRepeat made;
    made.bodies = series.bodies;
    Scenario scenario = series.scenario;
    made.drawn = drawnValues({series.varied, series.repeats, series.seed}, repeat);
    for (const auto& [key, value] : made.drawn) {
        setParameterText(scenario, key, value);
    }
    // Nobody measured where the obstacles are.
    scenario.effects.roughnessSeed += repeat;
    if (series.turned) {
        turnAtRandom(made.bodies, series.seed, repeat);
    }
    if (series.lifted) {
        made.lifted = liftOut(made.bodies, surfaceOf(series.terrain, scenario));
    }
    if (series.apart) {
        scenario.effects.of(EffectKind::FragmentContact) = EffectSwitch::Off;
    }
    const auto fe = std::make_shared<const FeResult>(contentsOf(made.bodies, series.until));
    made.result = drop({fe, series.frame, series.terrain}, scenario, series.watch, nullptr, execution);
    made.seconds = secondsSince(begun);
    return made;
}

std::vector<DropRepeat> dropAll(const DropSeries& series, const Execution& execution) {
    std::vector<DropRepeat> repeats(static_cast<std::size_t>(series.repeats));
    runInParallel(repeats.size(), {}, {"drop.repeats", "letting {0} bodies go, {1} times", {series.bodies.size(), series.repeats}},
                  execution,
                  [&](std::size_t r, const Execution& own) { repeats[r] = dropOnce(series, static_cast<std::int64_t>(r), own); });
    return repeats;
}

}  // namespace rubble
