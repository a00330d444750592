#include "core/scenario/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/nearest_names.h"

namespace rubble {

namespace {

std::string nearestKeys(std::string_view key) {
    std::vector<std::string> keys;
    for (const Parameter& row : parameterTable()) {
        keys.emplace_back(row.key);
    }
    return quotedList(nearestNames(key, keys, 3));
}

[[noreturn]] void refuse(const Parameter& row, std::string_view key, std::string_view value) {
    Message remedy{"parameter.text", "Give a text.", {}};
    switch (row.kind) {
        case ParameterKind::Switch:
            remedy = {"parameter.switch", "Give true or false.", {}};
            break;
        case ParameterKind::Integer:
            remedy = {"parameter.integer",
                      "Give a whole number from {0} to {1}.",
                      {static_cast<std::int64_t>(row.low), static_cast<std::int64_t>(row.high)}};
            break;
        case ParameterKind::Number:
            remedy = {"parameter.number", "Give a number from {0} to {1}.", {Argument(row.low), Argument(row.high, row.unit)}};
            break;
        case ParameterKind::Choice: {
            std::string all;
            for (const std::string_view choice : row.choices) {
                all += (all.empty() ? "" : ", ") + std::string(choice);
            }
            remedy = {"parameter.choice", "Choose one of {0}.", {all}};
            break;
        }
        case ParameterKind::Text:
            break;
    }
    if (row.automatic) {
        remedy.id += "_or_auto";
        remedy.pattern.insert(remedy.pattern.size() - 1, ", or auto");
    }
    throw UsageError({"parameter.refused", "{0} cannot be \"{1}\".", {key, value}}, remedy);
}

/// The number of a text such as "0.25 m"; other texts as they are. Throws UsageError for another unit than the parameter's.
std::string_view withoutUnit(const Parameter& row, std::string_view key, std::string_view text) {
    const bool number = row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
    const std::size_t blank = text.find(' ');
    const std::size_t start = text.find_first_not_of(' ', blank);
    if (!number || blank == std::string_view::npos || blank == 0 || start == std::string_view::npos) {
        return text;
    }
    const std::string_view unit = text.substr(start);
    if (unit != row.unit) {
        throw UsageError({"parameter.unit",
                          "{0} = {1}: the unit of {0} is {2}, not {3}.",
                          {key, text, row.unit.empty() ? std::string_view("none") : row.unit, unit}},
                         {"parameter.unit.remedy", "Convert the value and give the number alone.", {}});
    }
    return text.substr(0, blank);
}

std::optional<bool> switchNamed(std::string_view text) {
    if (text == "true" || text == "on" || text == "yes" || text == "1") {
        return true;
    }
    if (text == "false" || text == "off" || text == "no" || text == "0") {
        return false;
    }
    return std::nullopt;
}

bool hasChoice(const Parameter& row, std::string_view name) {
    return std::find(row.choices.begin(), row.choices.end(), name) != row.choices.end();
}

bool inRange(const Parameter& row, const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
        return row.automatic;
    }
    switch (row.kind) {
        case ParameterKind::Switch:
            return std::holds_alternative<bool>(value);
        case ParameterKind::Integer: {
            const auto* number = std::get_if<std::int64_t>(&value);
            return number && static_cast<double>(*number) >= row.low && static_cast<double>(*number) <= row.high;
        }
        case ParameterKind::Number: {
            const auto* number = std::get_if<double>(&value);
            return number && std::isfinite(*number) && *number >= row.low && *number <= row.high;
        }
        case ParameterKind::Choice: {
            const auto* name = std::get_if<std::string>(&value);
            return name && hasChoice(row, *name);
        }
        case ParameterKind::Text:
            return std::holds_alternative<std::string>(value);
    }
    return false;
}

template <class T>
std::optional<T> wholeNumber(std::string_view text) {
    T number{};
    const char* last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, number);
    return result.ec == std::errc() && result.ptr == last ? std::optional<T>(number) : std::nullopt;
}

std::optional<ParameterValue> parse(const Parameter& row, std::string_view text) {
    if (row.automatic && text == "auto") {
        return ParameterValue{};
    }
    switch (row.kind) {
        case ParameterKind::Switch:
            if (const auto flag = switchNamed(text)) {
                return *flag;
            }
            return std::nullopt;
        case ParameterKind::Integer:
            if (const auto number = wholeNumber<std::int64_t>(text)) {
                return *number;
            }
            return std::nullopt;
        case ParameterKind::Number:
            if (const auto number = wholeNumber<double>(text)) {
                return *number;
            }
            return std::nullopt;
        case ParameterKind::Choice:
            if (const auto flag = switchNamed(text); flag && hasChoice(row, "on") && hasChoice(row, "off")) {
                return std::string(*flag ? "on" : "off");
            }
            return std::string(text);
        case ParameterKind::Text:
            return std::string(text);
    }
    return std::nullopt;
}

void hashRegrouping(Hasher& hasher, const std::vector<RegroupStep>& steps) {
    hasher.value(static_cast<std::uint64_t>(steps.size()));
    for (const RegroupStep& step : steps) {
        hasher.value(static_cast<std::uint64_t>(step.index()));
        if (const auto* connectivity = std::get_if<SplitByConnectivity>(&step)) {
            hasher.text(connectivity->component);
        } else if (const auto* box = std::get_if<SplitByBox>(&step)) {
            hasher.text(box->component).text(box->newName).bytes(box->low.data(), 24).bytes(box->high.data(), 24);
        } else if (const auto* plane = std::get_if<SplitByPlane>(&step)) {
            hasher.text(plane->component).text(plane->newName).bytes(plane->point.data(), 24).bytes(plane->normal.data(), 24);
        } else if (const auto* merge = std::get_if<MergeComponents>(&step)) {
            hasher.value(static_cast<std::uint64_t>(merge->components.size()));
            for (const std::string& component : merge->components) {
                hasher.text(component);
            }
            hasher.text(merge->newName);
        } else if (const auto* rename = std::get_if<RenameComponent>(&step)) {
            hasher.text(rename->component).text(rename->newName);
        }
    }
}

/// Upper end of box_bulking: every box keeps its full size.
constexpr double neverDrawnIn = 1000.0;
/// Upper end of awake_time [s]: every body counts as awake for good.
constexpr double alwaysAwake = 1e6;

/// Effects that the published method does not have.
constexpr std::array addedByUs{EffectKind::Terrain, EffectKind::Water, EffectKind::AirDrag, EffectKind::Ties, EffectKind::BreakUp};

}  // namespace

std::string Parameter::keyFor(const std::string& name) const {
    std::string full(key);
    return keyed() ? full.replace(full.find("[*]"), 3, "[" + name + "]") : full;
}

std::vector<std::string> Parameter::subjectsIn(const Scenario& scenario) const {
    std::vector<std::string> names;
    switch (subject()) {
        case ParameterSubject::None:
            return {std::string()};
        case ParameterSubject::Component:
            for (const auto& [name, settings] : scenario.components) {
                names.push_back(name);
            }
            break;
        case ParameterSubject::Pair:
            for (const MaterialPair& pair : materialPairs()) {
                names.push_back(pairName(pair));
            }
            break;
    }
    static const Scenario defaults;
    std::erase_if(names, [&](const std::string& name) { return get(scenario, name) == get(defaults, name); });
    return names;
}

std::pair<const Parameter*, std::string> findParameter(std::string_view key) {
    const std::size_t open = key.find('[');
    const std::size_t close = key.rfind(']');
    const bool bracketed = open != std::string_view::npos && close != std::string_view::npos && close > open + 1;
    const std::string pattern =
        bracketed ? std::string(key.substr(0, open)) + "[*]" + std::string(key.substr(close + 1)) : std::string(key);
    for (const Parameter& row : parameterTable()) {
        if (row.key == pattern && row.keyed() == bracketed) {
            const std::string_view name = bracketed ? key.substr(open + 1, close - open - 1) : std::string_view();
            return {&row, row.subject() == ParameterSubject::Pair ? pairName(pairFrom(name)) : std::string(name)};
        }
    }
    throw UsageError({"parameter.unknown", "There is no parameter \"{0}\".", {key}},
                     {"parameter.near", "Did you mean one of {0}? `rubble-cli parameters` lists all.", {nearestKeys(key)}});
}

ParameterValue parameterValue(const Scenario& scenario, std::string_view key) {
    const auto [row, subject] = findParameter(key);
    return row->get(scenario, subject);
}

void setParameter(Scenario& scenario, std::string_view key, const ParameterValue& value) {
    const auto [row, subject] = findParameter(key);
    if (!inRange(*row, value)) {
        refuse(*row, key, valueText(value));
    }
    row->set(scenario, subject, value);
}

void setParameterText(Scenario& scenario, std::string_view key, std::string_view value) {
    if (key == "preset") {
        applyPreset(scenario, value);
        return;
    }
    const auto [row, subject] = findParameter(key);
    const std::optional<ParameterValue> parsed = parse(*row, withoutUnit(*row, key, value));
    if (!parsed || !inRange(*row, *parsed)) {
        refuse(*row, key, value);
    }
    row->set(scenario, subject, *parsed);
}

std::string valueText(const ParameterValue& value) {
    struct Visitor {
        std::string operator()(std::monostate) const { return "auto"; }
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(std::int64_t number) const { return std::to_string(number); }
        std::string operator()(double number) const {
            std::array<char, 40> buffer{};
            const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
            return {buffer.data(), result.ptr};
        }
        std::string operator()(const std::string& text) const { return text; }
    };
    return std::visit(Visitor{}, value);
}

std::span<const std::string_view> presetNames() {
    static constexpr std::array<std::string_view, 3> names{"default", "paper", "reference"};
    return names;
}

void applyPreset(Scenario& scenario, std::string_view name) {
    // A preset settles the method; what describes the scene (file, components, materials, ground) stays.
    const Scenario defaults;
    const auto method = [&scenario, &defaults] {
        scenario.fragments.birthVelocity = defaults.fragments.birthVelocity;
        scenario.fragments.birthWindow = defaults.fragments.birthWindow;
        scenario.grid.grouping = defaults.grid.grouping;
        scenario.grid.acrossComponents = defaults.grid.acrossComponents;
        scenario.grid.oneBodyPerFragment = defaults.grid.oneBodyPerFragment;
        scenario.grid.velocityTolerance = defaults.grid.velocityTolerance;
        scenario.grid.awakeTime = defaults.grid.awakeTime;
        scenario.simulation.solver = defaults.simulation.solver;
        scenario.simulation.shape = defaults.simulation.shape;
        scenario.simulation.boxBulking = defaults.simulation.boxBulking;
        scenario.simulation.pieces = defaults.simulation.pieces;
        scenario.simulation.freeze = defaults.simulation.freeze;
        for (const EffectKind kind : addedByUs) {
            scenario.effects.of(kind) = defaults.effects.of(kind);
        }
        scenario.effects.islands = defaults.effects.islands;
        scenario.effects.loose = defaults.effects.loose;
    };
    if (name == "default") {
        method();
    } else if (name == "reference") {
        method();
        scenario.fragments.birthWindow = 0.0;
        scenario.grid.oneBodyPerFragment = true;
    } else if (name == "paper") {
        method();
        scenario.fragments.birthVelocity = BirthVelocity::Rest;
        scenario.fragments.birthWindow = 0.0;
        scenario.grid.grouping = Grouping::Axes;
        scenario.grid.velocityTolerance = 0.0;
        scenario.grid.awakeTime = alwaysAwake;
        scenario.simulation.solver = SolverKind::Bullet;
        scenario.simulation.shape = ClusterShape::AxisBox;
        scenario.simulation.boxBulking = neverDrawnIn;
        scenario.simulation.pieces = PieceKind::ComponentBox;
        scenario.simulation.freeze = false;
        for (const EffectKind kind : addedByUs) {
            scenario.effects.of(kind) = EffectSwitch::Off;
        }
        scenario.effects.islands = LiveIslandPolicy::Held;
        scenario.effects.loose = LooseStructurePolicy::Fe;
    } else {
        throw UsageError({"preset.unknown", "There is no preset \"{0}\".", {name}},
                         {"preset.names", "Choose one of default, paper, reference.", {}});
    }
}

Digest scenarioSlice(const Scenario& scenario, Stage stage) {
    Hasher hasher;
    hasher.text(stageName(stage));
    for (const Parameter& row : parameterTable()) {
        if (row.stage != stage) {
            continue;
        }
        for (const std::string& name : row.subjectsIn(scenario)) {
            hasher.text(row.key).text(name).text(valueText(row.get(scenario, name)));
        }
    }
    if (stage == Stage::Components) {
        hashRegrouping(hasher, scenario.regrouping);
    }
    return hasher.finish();
}

std::optional<Stage> firstStale(const Scenario& before, const Scenario& after) {
    for (int i = 0; i < stageCount; ++i) {
        const Stage stage = static_cast<Stage>(i);
        if (scenarioSlice(before, stage) != scenarioSlice(after, stage)) {
            return stage;
        }
    }
    return std::nullopt;
}

}  // namespace rubble
