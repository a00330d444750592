#include "core/analysis/accuracy/study_store.h"

#include <cmath>

#include "core/analysis/accuracy/machine_load.h"
#include "core/base/build.h"
#include "core/base/unknown.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

Digest scenarioDigest(const Scenario& scenario) {
    Hasher hasher;
    for (int stage = 0; stage < stageCount; ++stage) {
        hasher.digest(scenarioSlice(scenario, static_cast<Stage>(stage)));
    }
    return hasher.finish();
}

}  // namespace

SettingCost::SettingCost()
    : wallSeconds(unknown), stepMeanMs(unknown), stepWorstMs(unknown), fps(unknown), fpsWorst(unknown), othersShare(unknown) {}

bool SettingCost::timed() const {
    return std::isfinite(wallSeconds);
}

bool SettingCost::disturbed() const {
    return othersShare > MachineLoad::quietBelow;
}

WorldOrigin originOf(const Inputs& inputs, const Scenario& scenario, std::int64_t repeat, double birthShift,
                     const std::string& machine) {
    WorldOrigin origin;
    origin.build = std::string(buildText());
    origin.feSha256 = inputs.fe->contents().sha256;
    origin.scenario = scenarioDigest(scenario);
    origin.repeat = repeat;
    origin.birthShift = repeat > 0 ? birthShift : 0.0;
    origin.machine = machine;
    // A repeat keeps the clusters of its base: it is not the run that a shifted scenario would make.
    Hasher hasher;
    hasher.text("study world").digest(stageKey(inputs, scenario, Stage::Simulation)).value(repeat).value(origin.birthShift);
    origin.key = hasher.finish();
    return origin;
}

std::string foreignPart(const WorldOrigin& expected, const WorldOrigin& found) {
    if (found.build != expected.build) {
        return "build";
    }
    if (found.feSha256 != expected.feSha256) {
        return "FE result";
    }
    if (found.scenario != expected.scenario) {
        return "scenario";
    }
    if (found.repeat != expected.repeat || found.birthShift != expected.birthShift) {
        return "repeat";
    }
    return found.key == expected.key ? "" : "terrain or stage of the program";
}

}  // namespace rubble
