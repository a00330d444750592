#include <pybind11/stl.h>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "core/base/error.h"
#include "core/fe/fe_result.h"

namespace rubble::python {

namespace {

using Result = std::shared_ptr<FeResult>;
using State = std::shared_ptr<FeState>;

py::array vectorsOf(const std::shared_ptr<const void>& owner, const std::vector<Vec3>& vectors) {
    static const double none = 0.0;
    return arrayOver<double>(owner, vectors.empty() ? &none : vectors.front().data(),
                             {static_cast<py::ssize_t>(vectors.size()), 3});
}

template <class T>
py::array numbersOf(const std::shared_ptr<const void>& owner, const std::vector<T>& values) {
    static const T none{};
    return arrayOver<T>(owner, values.empty() ? &none : values.data(), {static_cast<py::ssize_t>(values.size())});
}

void checkState(const FeResult& fe, std::size_t k) {
    if (k >= fe.stateCount()) {
        throw UsageError({"python.state", "There is no state {0}: the result has {1}, counted from 0.", {k, fe.stateCount()}},
                         {"python.state.remedy", "Choose one below that.", {}});
    }
}

}  // namespace

void addFe(py::module_& module) {
    py::class_<FeState, State>(module, "FeState", "Nodal fields at one state; the arrays are views that keep it in memory.")
        .def_readonly("time", &FeState::time, "s, on the file's clock")
        .def_property_readonly(
            "positions", [](const State& state) { return vectorsOf(state, state->positions); },
            "m, initial + displacement [nodes, 3]")
        .def_property_readonly(
            "velocities", [](const State& state) { return vectorsOf(state, state->velocities); },
            "m/s [nodes, 3]; [0, 3] where the file has none");

    py::class_<FeResult, Result>(module, "FeResult",
                                 "A finished FE result: mesh, times and activity in memory, states read when asked for.")
        .def_property_readonly(
            "path", [](const FeResult& fe) { return fe.contents().path; }, "File as opened; of a series the first")
        .def_property_readonly(
            "format", [](const FeResult& fe) { return fe.contents().format; }, "Name of the file format")
        .def_property_readonly(
            "sha256", [](const FeResult& fe) { return fe.contents().sha256; }, "SHA-256 of the file, hex")
        .def_property_readonly(
            "times", [](const Result& fe) { return numbersOf(fe, fe->times()); }, "s, of the states [states]")
        .def_property_readonly(
            "nodes", [](const Result& fe) { return vectorsOf(fe, fe->mesh().nodes); }, "m, initial places [nodes, 3]")
        .def_property_readonly(
            "node_ids", [](const Result& fe) { return numbersOf(fe, fe->mesh().nodeIds); }, "User's node numbers [nodes]")
        .def_property_readonly(
            "element_ids", [](const Result& fe) { return numbersOf(fe, fe->mesh().elementIds); },
            "User's element numbers [elements]")
        .def_property_readonly(
            "corners", [](const Result& fe) { return numbersOf(fe, fe->mesh().corners); },
            "Node indices of the corners of all elements, one element after the other")
        .def_property_readonly(
            "offsets", [](const Result& fe) { return numbersOf(fe, fe->mesh().offsets); },
            "First corner of each element in corners [elements + 1]")
        .def_property_readonly(
            "part", [](const Result& fe) { return numbersOf(fe, fe->mesh().part); }, "Index into parts of each element [elements]")
        .def_property_readonly(
            "density", [](const Result& fe) { return numbersOf(fe, fe->mesh().density); },
            "kg/m3, NaN where the file does not say [elements]")
        .def_property_readonly(
            "parts",
            [](const FeResult& fe) {
                std::vector<std::string> names;
                for (const Part& part : fe.mesh().parts) {
                    names.push_back(part.name);
                }
                return names;
            },
            "Names of the parts")
        .def(
            "active",
            [](const FeResult& fe, std::size_t state) {
                checkState(fe, state);
                py::array_t<bool> active(static_cast<py::ssize_t>(fe.mesh().elementCount()));
                for (std::size_t e = 0; e < fe.mesh().elementCount(); ++e) {
                    active.mutable_data()[e] = fe.activity().active(state, idAt<ElementIndex>(e));
                }
                return active;
            },
            py::arg("state"), "Whether each element is active at a state, counted from 0 [elements]; a copy")
        .def(
            "state",
            [](const Result& fe, std::size_t state) {
                checkState(*fe, state);
                const py::gil_scoped_release released;
                return std::const_pointer_cast<FeState>(fe->state(state));
            },
            py::arg("state"), "Nodal fields at a state, counted from 0; read from the file unless in memory")
        .def("__len__", &FeResult::stateCount)
        .def("__repr__", [](const FeResult& fe) {
            return "<rubble.FeResult " + fe.contents().path + ": " + std::to_string(fe.mesh().elementCount()) + " elements, " +
                   std::to_string(fe.stateCount()) + " states>";
        });
}

}  // namespace rubble::python
