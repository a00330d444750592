#include "core/validation/drop_series.h"

#include "core/scenario/parameters.h"

namespace rubble {

SiteSurface surfaceOf(const DropSeries& series) {
    const EffectSettings& effects = series.scenario.effects;
    const bool terrain = series.terrain && effects.of(EffectKind::Terrain) != EffectSwitch::Off;
    return {effects.of(EffectKind::Ground) != EffectSwitch::Off, series.scenario.simulation.groundHeight,
            terrain ? series.terrain : nullptr};
}

DropRepeat dropOnce(const DropSeries& series, std::int64_t repeat, const Execution& execution) {
    DropRepeat made;
    made.bodies = series.bodies;
    if (series.turned) {
        turnAtRandom(made.bodies, series.seed, repeat);
    }
    if (series.lifted) {
        made.lifted = liftOut(made.bodies, surfaceOf(series));
    }
    Scenario scenario = series.scenario;
    made.drawn = drawnValues({series.varied, series.repeats, series.seed}, repeat);
    for (const auto& [key, value] : made.drawn) {
        setParameterText(scenario, key, value);
    }
    if (series.apart) {
        scenario.effects.of(EffectKind::FragmentContact) = EffectSwitch::Off;
    }
    const auto fe = std::make_shared<const FeResult>(contentsOf(made.bodies, series.until));
    made.result = drop({fe, series.frame, series.terrain}, scenario, series.watch, nullptr, execution);
    return made;
}

}  // namespace rubble
