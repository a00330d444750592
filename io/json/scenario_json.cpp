#include "io/json/scenario_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "core/base/error.h"
#include "core/scenario/parameters.h"

namespace rubble::io {

using nlohmann::json;

namespace {

json valueJson(const ParameterValue& value) {
    return std::visit(
        [](const auto& v) -> json {
            if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::monostate>) {
                return nullptr;
            } else {
                return v;
            }
        },
        value);
}

ParameterValue valueFromJson(const JsonCursor& cursor, ParameterKind kind) {
    if (cursor.value().is_null()) {
        return {};
    }
    switch (kind) {
        case ParameterKind::Switch:
            return cursor.flag();
        case ParameterKind::Integer:
            return cursor.integer();
        case ParameterKind::Number:
            return cursor.number();
        case ParameterKind::Choice:
        case ParameterKind::Text:
            break;
    }
    return cursor.text();
}

// Writes a value only if it can be read back: the table's own ranges refuse it here rather than on opening.
void writeSetting(json& settings, const std::string& key, const ParameterValue& value) {
    Scenario probe;
    setParameter(probe, key, value);
    settings[key] = valueJson(value);
}

json settingsJson(const Scenario& scenario) {
    static const Scenario defaults;
    json settings = json::object();
    for (const Parameter& row : parameterTable()) {
        for (const std::string& subject : row.subjectsIn(scenario)) {
            const ParameterValue value = row.get(scenario, subject);
            if (value != row.get(defaults, subject)) {
                writeSetting(settings, row.keyFor(subject), value);
            }
        }
    }
    return settings;
}

void readSettings(Scenario& scenario, const JsonCursor& settings) {
    for (const auto& [key, cursor] : settings.members()) {
        try {
            setParameter(scenario, key, valueFromJson(cursor, findParameter(key).first->kind));
        } catch (const UsageError& error) {
            cursor.refuse(englishText(error.message()), englishText(error.remedy()));
        }
    }
}

json finiteVector(const Vec3& v) {
    if (!v.allFinite()) {
        throw UsageError(Message{"io.case.not_finite", "A regrouping step holds a number that is not finite", {}},
                         Message{"io.case.not_finite.remedy", "Correct the box or plane of the step.", {}});
    }
    return jsonVector(v);
}

struct StepWriter {
    json operator()(const SplitByConnectivity& step) const {
        return {{"step", "split_by_connectivity"}, {"component", step.component}};
    }
    json operator()(const SplitByBox& step) const {
        return {{"step", "split_by_box"},
                {"component", step.component},
                {"low", finiteVector(step.low)},
                {"high", finiteVector(step.high)},
                {"new_name", step.newName}};
    }
    json operator()(const SplitByPlane& step) const {
        return {{"step", "split_by_plane"},
                {"component", step.component},
                {"point", finiteVector(step.point)},
                {"normal", finiteVector(step.normal)},
                {"new_name", step.newName}};
    }
    json operator()(const MergeComponents& step) const {
        return {{"step", "merge"}, {"components", step.components}, {"new_name", step.newName}};
    }
    json operator()(const RenameComponent& step) const {
        return {{"step", "rename"}, {"component", step.component}, {"new_name", step.newName}};
    }
};

Vec3 finiteVector(const JsonCursor& cursor) {
    const Vec3 v = cursor.vector();
    if (!v.allFinite()) {
        cursor.fail("three finite numbers");
    }
    return v;
}

RegroupStep stepFromJson(const JsonCursor& object) {
    const std::string name = object["step"].text();
    if (name == "split_by_connectivity") {
        object.allowOnly({"step", "component"});
        return SplitByConnectivity{object["component"].text()};
    }
    if (name == "split_by_box") {
        object.allowOnly({"step", "component", "low", "high", "new_name"});
        return SplitByBox{object["component"].text(), finiteVector(object["low"]), finiteVector(object["high"]),
                          object["new_name"].text()};
    }
    if (name == "split_by_plane") {
        object.allowOnly({"step", "component", "point", "normal", "new_name"});
        return SplitByPlane{object["component"].text(), finiteVector(object["point"]), finiteVector(object["normal"]),
                            object["new_name"].text()};
    }
    if (name == "merge") {
        object.allowOnly({"step", "components", "new_name"});
        MergeComponents step;
        for (const JsonCursor& component : object["components"].elements()) {
            step.components.push_back(component.text());
        }
        step.newName = object["new_name"].text();
        return step;
    }
    if (name == "rename") {
        object.allowOnly({"step", "component", "new_name"});
        return RenameComponent{object["component"].text(), object["new_name"].text()};
    }
    object["step"].fail("split_by_connectivity, split_by_box, split_by_plane, merge or rename");
}

}  // namespace

json scenarioJson(const Scenario& scenario) {
    json steps = json::array();
    for (const RegroupStep& step : scenario.regrouping) {
        steps.push_back(std::visit(StepWriter{}, step));
    }
    return {{"settings", settingsJson(scenario)}, {"regrouping", steps}};
}

Scenario scenarioFromJson(const JsonCursor& object) {
    Scenario scenario;
    readSettings(scenario, object["settings"]);
    for (const JsonCursor& step : object["regrouping"].elements()) {
        scenario.regrouping.push_back(stepFromJson(step));
    }
    return scenario;
}

json frameJson(const Frame& frame) {
    return {{"origin", {frame.origin.x(), frame.origin.y(), frame.origin.z()}},
            {"metres_per_unit", frame.metresPerUnit},
            {"up_axis", frame.upAxis},
            {"crs", frame.crs}};
}

Frame frameFromJson(const JsonCursor& object) {
    object.allowOnly({"origin", "metres_per_unit", "up_axis", "crs"});
    Frame frame;
    const JsonCursor origin = object["origin"];
    const std::vector<JsonCursor> parts = origin.elements();
    if (parts.size() != 3) {
        origin.fail("a list of three whole numbers");
    }
    for (int i = 0; i < 3; ++i) {
        frame.origin[i] = parts[static_cast<std::size_t>(i)].integer();
    }
    frame.metresPerUnit = object["metres_per_unit"].number();
    if (!(frame.metresPerUnit > 0.0)) {
        object["metres_per_unit"].fail("a number above zero");
    }
    frame.upAxis = object["up_axis"].text();
    frame.crs = object["crs"].text();
    return frame;
}

}  // namespace rubble::io
