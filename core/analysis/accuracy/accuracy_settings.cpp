#include "core/analysis/accuracy/accuracy_settings.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

constexpr std::size_t settingsMax = 1000;

/// What describes the scene although the simulation reads it: a reference with another value is of another collapse.
constexpr std::array<std::string_view, 7> describesScene{"gravity",         "ground_height", "settle_time", "water_level",
                                                         "ground_material", "current_x",     "current_y"};

void checkVaried(std::string_view key) {
    if (key == "preset") {
        return;
    }
    const Parameter& row = *findParameter(key).first;
    const bool scene = std::find(describesScene.begin(), describesScene.end(), key) != describesScene.end();
    // What is born together is a matter of method, although fragments are made with it.
    if ((row.stage < Stage::Sizing && key != "birth_window") || scene) {
        throw UsageError({"accuracy.scene_parameter",
                          "{0} says what collapses, not how it is simulated: no reference holds for two values of it.",
                          {key}},
                         {"accuracy.scene_parameter.remedy",
                          "Set it for the whole sweep, and vary what costs time: the grid, birth_window, cluster_shape, pieces, "
                          "step_rate, substeps, iterations, solver, break_up_speed or an effect.",
                          {}});
    }
}

void setVaried(Scenario& scenario, const std::string& key, const std::string& value) {
    if (key == "multiple") {
        scenario.grid.length.reset();
        scenario.grid.width.reset();
        scenario.grid.height.reset();
        scenario.grid.oneBodyPerFragment = false;
    }
    setParameterText(scenario, key, value);
}

/// Each of the rows with each value of one more parameter.
std::vector<AccuracySetting> combined(const std::vector<AccuracySetting>& rows, const VariedParameter& parameter) {
    checkVaried(parameter.key);
    if (parameter.values.empty() || rows.size() * parameter.values.size() > settingsMax) {
        throw UsageError({"accuracy.settings",
                          "A sweep has 1 to {0} settings; {1} were asked for.",
                          {settingsMax, rows.size() * parameter.values.size()}},
                         {"accuracy.settings.remedy", "Give fewer values, or sweep the parameters one after the other.", {}});
    }
    std::vector<AccuracySetting> all;
    for (const AccuracySetting& row : rows) {
        for (const std::string& value : parameter.values) {
            AccuracySetting next = row;
            setVaried(next.scenario, parameter.key, value);
            next.name += (next.name.empty() ? "" : " ") + parameter.key + "=" + value;
            all.push_back(std::move(next));
        }
    }
    return all;
}

void checkDistinct(std::vector<std::string> names, std::string_view what) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) {
        throw UsageError({"accuracy.twice", "{0} {1} is given twice.", {what, *twice}},
                         {"accuracy.twice.remedy", "Give each once.", {}});
    }
}

}  // namespace

std::vector<std::string> usualMultiples() {
    return {"1", "1.5", "2", "2.5", "3", "4"};
}

std::vector<AccuracySetting> sweepSettings(const Scenario& scenario, std::span<const std::string> multiples,
                                           std::span<const VariedParameter> varied) {
    std::vector<VariedParameter> all;
    if (!multiples.empty()) {
        all.push_back({"multiple", {multiples.begin(), multiples.end()}});
    }
    all.insert(all.end(), varied.begin(), varied.end());
    std::vector<std::string> keys;
    std::vector<AccuracySetting> settings{{"", scenario}};
    for (const VariedParameter& parameter : all) {
        keys.push_back(parameter.key);
        checkDistinct(parameter.values, "The value");
        settings = combined(settings, parameter);
    }
    checkDistinct(keys, "The parameter");
    if (all.empty()) {
        settings.front().name = "as set";
    }
    settings.push_back({std::string(paperSetting), paperScenario(scenario)});
    return settings;
}

Scenario referenceScenario(const Scenario& scenario) {
    Scenario reference = scenario;
    applyPreset(reference, "reference");
    // Who moves loose structure is part of the scene: an error of clusters says nothing of it.
    reference.effects.loose = scenario.effects.loose;
    // The grid is not read with a body per fragment: whatever is set there, the reference is the same one.
    const GridSettings defaults;
    reference.grid.multiple = defaults.multiple;
    reference.grid.length = defaults.length;
    reference.grid.width = defaults.width;
    reference.grid.height = defaults.height;
    reference.grid.fpsTarget = defaults.fpsTarget;
    reference.grid.bodiesMax = defaults.bodiesMax;
    reference.grid.awakeTime = defaults.awakeTime;
    return reference;
}

Scenario paperScenario(const Scenario& scenario) {
    Scenario paper = scenario;
    applyPreset(paper, "paper");
    paper.grid.oneBodyPerFragment = false;
    return paper;
}

}  // namespace rubble
