#include <pybind11/stl.h>

#include "app/python/array_result.h"
#include "app/python/bindings.h"
#include "app/python/collapse.h"
#include "app/python/recorded_run.h"
#include "app/python/watched.h"
#include "core/base/error.h"
#include "core/fe/audit.h"
#include "core/scenario/parameters.h"

namespace rubble::python {

namespace {

using Collapses = std::shared_ptr<Collapse>;

/// A value of Python as text that the parameter table reads. Arrays and the like are refused by name.
std::string settingText(const std::string& key, const py::handle& value) {
    if (value.is_none()) {
        return "auto";
    }
    if (PyBool_Check(value.ptr()) != 0) {
        return value.cast<bool>() ? "true" : "false";
    }
    if (PyLong_Check(value.ptr()) != 0 || PyFloat_Check(value.ptr()) != 0) {
        return py::repr(value);
    }
    if (PyUnicode_Check(value.ptr()) != 0) {
        return value.cast<std::string>();
    }
    throw UsageError({"python.setting",
                      "{0} was given a value of the type {1}.",
                      {key, std::string(py::str(py::type::handle_of(value).attr("__name__")))}},
                     {"python.setting.remedy", "Give a number, a text, True, False, or None for automatic.", {}});
}

py::object valueOf(const ParameterValue& value) {
    return std::visit(
        [](const auto& held) -> py::object {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
                return py::none();
            } else {
                return py::cast(held);
            }
        },
        value);
}

py::dict inspect(Collapse& collapse, py::object progress) {
    const Audit audit = watched(std::move(progress), [&](const Execution& execution) {
        const Results& results = collapse.upTo(Stage::Components, execution);
        return auditDeaths(*collapse.inputs().fe, *results.components, execution);
    });
    py::list components;
    for (const ComponentAudit& one : audit.components) {
        py::dict row;
        row["name"] = one.name;
        row["kind"] = one.kind;
        row["elements"] = one.elements;
        row["dead"] = one.dead;
        row["density"] = one.density;
        row["mass"] = one.mass;
        row["dead_mass"] = one.deadMass;
        components.append(row);
    }
    py::dict anomalies;
    for (const Anomaly& anomaly : audit.anomalies) {
        anomalies[py::str(anomaly.kind)] = anomaly.count;
    }
    py::dict all;
    all["components"] = components;
    all["dead"] = audit.deadTotal;
    all["dead_per_state"] = audit.deadPerState;
    all["mass"] = audit.mass;
    all["dead_mass"] = audit.deadMass;
    all["anomalies"] = anomalies;
    return all;
}

/// The part of a stage as Python holds it; it stays as it is when settings change later.
template <class Part>
std::shared_ptr<Part> part(Collapse& collapse, Stage stage, std::shared_ptr<const Part> Results::* member, py::object progress) {
    return watched(std::move(progress), [&](const Execution& execution) {
        return std::const_pointer_cast<Part>(collapse.upTo(stage, execution).*member);
    });
}

std::shared_ptr<RecordedRun> record(Collapse& collapse, const std::string& path, py::object progress) {
    WatchedWork(std::move(progress)).run([&](const Execution& execution) { collapse.record(path, execution); });
    return std::make_shared<RecordedRun>(io::openRun(path), collapse.inputs());
}

py::list parameters() {
    py::list rows;
    const Scenario defaults;
    for (const Parameter& parameter : parameterTable()) {
        py::dict row;
        row["key"] = std::string(parameter.key);
        row["unit"] = std::string(parameter.unit);
        row["low"] = parameter.low;
        row["high"] = parameter.high;
        row["choices"] = std::vector<std::string>(parameter.choices.begin(), parameter.choices.end());
        row["default"] = parameter.keyed() ? py::object(py::none()) : valueOf(parameter.get(defaults, ""));
        row["help"] = std::string(parameter.help);
        rows.append(row);
    }
    return rows;
}

Collapses open(const std::string& path, const std::optional<std::string>& scenario, const py::dict& settings,
               const std::optional<std::string>& terrain, py::object progress) {
    io::CaseRequest request;
    request.path = path;
    request.scenario = scenario;
    request.settings = settingsOf(settings);
    request.terrain = terrain;
    return watched(std::move(progress),
                   [&](const Execution& execution) { return std::make_shared<Collapse>(io::openCase(request, execution)); });
}

Collapses fromArrays(py::object times, py::object positions, py::object elements, py::object active, py::object velocities,
                     py::object density, py::object parts, py::object partNames, const std::string& units) {
    const auto fe = resultOfArrays({std::move(times), std::move(positions), std::move(elements), std::move(active),
                                    std::move(velocities), std::move(density), std::move(parts), std::move(partNames), units});
    return std::make_shared<Collapse>(fe);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> settingsOf(const py::dict& settings) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const auto& [key, value] : settings) {
        const std::string name = py::str(key);
        texts.emplace_back(name, settingText(name, value));
    }
    return texts;
}

py::list findingsOf(const Findings& findings) {
    py::list list;
    for (const Finding& finding : findings.list()) {
        py::dict row;
        row["id"] = finding.what.id;
        row["count"] = finding.count;
        row["what"] = englishText(finding.what);
        row["example"] = finding.example;
        row["remedy"] = englishText(finding.remedy);
        list.append(row);
    }
    return list;
}

void addCollapse(py::module_& module) {
    py::class_<Collapse, Collapses>(module, "Collapse", "One scenario of a case, or an FE result by itself, ready to be run.")
        .def_property_readonly("path", &Collapse::path, "Case or FE result as opened, absolute")
        .def_property_readonly("scenario", &Collapse::scenarioName, "Name of the scenario")
        .def_property_readonly("scenarios", &Collapse::scenarios, "Names of all scenarios of the case")
        .def_property_readonly(
            "fe", [](const Collapse& collapse) { return std::const_pointer_cast<FeResult>(collapse.inputs().fe); }, "The FE result")
        .def_property_readonly(
            "findings", [](const Collapse& collapse) { return findingsOf(collapse.findings()); },
            "What was met on the way, each counted, with an example and a remedy")
        .def(
            "get",
            [](const Collapse& collapse, const std::string& key) { return valueOf(parameterValue(collapse.scenario(), key)); },
            py::arg("key"), "Value of a parameter; None means automatic")
        .def(
            "set",
            [](Collapse& collapse, const std::string& key, const py::object& value) { collapse.set(key, settingText(key, value)); },
            py::arg("key"), py::arg("value"),
            "Sets a parameter. A text may end in the unit of the parameter ('0.25 m'); another unit is refused")
        .def("inspect", &inspect, py::arg("progress") = py::none(), "Audits every death in the FE result")
        .def(
            "fragments",
            [](Collapse& collapse, py::object progress) {
                return part(collapse, Stage::Fragments, &Results::fragments, std::move(progress));
            },
            py::arg("progress") = py::none(), "Turns every deactivated element into a rigid fragment")
        .def(
            "components",
            [](Collapse& collapse, py::object progress) {
                const auto components = part(collapse, Stage::Components, &Results::components, std::move(progress));
                std::vector<std::string> names;
                for (const Component& component : components->list) {
                    names.push_back(component.name);
                }
                return names;
            },
            py::arg("progress") = py::none(), "Names of the components")
        .def(
            "size",
            [](Collapse& collapse, py::object progress) {
                return watched(std::move(progress), [&](const Execution& execution) {
                    const auto sizing = std::const_pointer_cast<Sizing>(collapse.upTo(Stage::Sizing, execution).sizing);
                    collapse.lookBeside(execution);
                    return sizing;
                });
            },
            py::arg("progress") = py::none(),
            "Searches the Basic Grid. The bodies that a frame rate allows are fragments alone: findings say what moves beside them")
        .def(
            "cluster",
            [](Collapse& collapse, py::object progress) {
                return part(collapse, Stage::Clusters, &Results::clustering, std::move(progress));
            },
            py::arg("progress") = py::none(), "Decides which fragments one rigid body carries")
        .def("run", &record, py::arg("out"), py::arg("progress") = py::none(),
             "Simulates the collapse and records it in a run file, which it then opens. After Ctrl-C the file holds what was "
             "simulated")
        .def("__repr__", [](const Collapse& collapse) {
            return "<rubble.Collapse " + collapse.path() + ", scenario '" + collapse.scenarioName() + "'>";
        });
    module.def("open", &open, py::arg("path"), py::kw_only(), py::arg("scenario") = py::none(), py::arg("settings") = py::dict(),
               py::arg("terrain") = py::none(), py::arg("progress") = py::none(),
               "Opens a case or an FE result of any format that Rubble reads");
    module.def("from_arrays", &fromArrays, py::arg("times"), py::arg("positions"), py::arg("elements"), py::arg("active"),
               py::kw_only(), py::arg("velocities") = py::none(), py::arg("density") = py::none(), py::arg("parts") = py::none(),
               py::arg("part_names") = py::none(), py::arg("units") = "kg-m-s",
               "An FE result of solids from arrays: times [states], positions [states, nodes, 3], elements [elements, 8, 6, 5 or "
               "4] of node "
               "indices, active [states, elements]. The arrays are copied");
    module.def("parameters", &parameters, "Every parameter: key, unit, range, choices, default and help");
}

}  // namespace rubble::python
