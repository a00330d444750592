#pragma once

#include <pybind11/pybind11.h>

namespace rubble::python {

// Each adds the classes of one subject to the module.
void addFe(pybind11::module_& module);
void addResults(pybind11::module_& module);
void addCollapse(pybind11::module_& module);
void addRun(pybind11::module_& module);

}  // namespace rubble::python
