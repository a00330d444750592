#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "core/base/finding.h"

namespace rubble::python {

// Each adds the classes of one subject to the module.
void addFe(pybind11::module_& module);
void addResults(pybind11::module_& module);
void addCollapse(pybind11::module_& module);
void addRun(pybind11::module_& module);
void addDrop(pybind11::module_& module);

/// Settings as Python gives them, as text that the parameter table reads. Throws UsageError.
std::vector<std::pair<std::string, std::string>> settingsOf(const pybind11::dict& settings);
/// [{id, count, what, example, remedy}]
pybind11::list findingsOf(const Findings& findings);

}  // namespace rubble::python
