#include "core/analysis/accuracy/repeat_floor.h"

#include <limits>

#include "core/analysis/accuracy/world_pool.h"

namespace rubble {

RepeatFloor floorOf(const StudyWorld& run, std::span<const std::optional<StudyWorld>> repeats, std::int64_t seed) {
    RepeatFloor floor;
    floor.trajectoryHash = run.trajectoryHash;
    floor.breaches = run.breaches;
    floor.figures = run.field.figures;
    floor.largest = compareDebris(run.field, run.field);
    for (std::size_t a = 0; a < repeats.size(); ++a) {
        if (!repeats[a]) {
            continue;
        }
        RepeatRow row;
        row.seed = seed + static_cast<std::int64_t>(a) + 1;
        row.trajectoryHash = repeats[a]->trajectoryHash;
        row.breaches = repeats[a]->breaches;
        row.figures = repeats[a]->field.figures;
        row.difference = compareDebris(run.field, repeats[a]->field);
        floor.largest = largerOf(floor.largest, row.difference);
        for (std::size_t b = 0; b < a; ++b) {
            if (repeats[b]) {
                floor.largest = largerOf(floor.largest, compareDebris(repeats[b]->field, repeats[a]->field));
            }
        }
        floor.repeats.push_back(std::move(row));
    }
    if (floor.repeats.empty()) {
        floor.largest.values.fill(std::numeric_limits<double>::quiet_NaN());
    }
    return floor;
}

RepeatFloor repeatFloor(const Inputs& inputs, const Scenario& scenario, const StudySettings& settings, const Execution& execution) {
    const StudyBase base = beginStudy(inputs, scenario, settings, execution);
    const std::size_t worlds = 1 + static_cast<std::size_t>(settings.repeats);
    std::vector<std::optional<StudyWorld>> done(worlds);
    runInParallel(worlds, {settings.threads}, {"analysis.floor", "simulating {0} worlds for the repeat floor", {worlds}}, execution,
                  [&](std::size_t i, const Execution& own) {
                      const RunDescription description = i == 0 ? describeBase(base)
                                                                : describeRepeat({base.inputs, base.scenario, base.results},
                                                                                 settings.birthShift, static_cast<int>(i), own);
                      done[i] = simulateWorld(description, base, settings, own);
                  });
    return floorOf(*done[0], std::span(done).subspan(1), scenario.fragments.seed);
}

}  // namespace rubble
