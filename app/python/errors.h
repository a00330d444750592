#pragma once

#include <pybind11/pybind11.h>

namespace rubble::python {

/// Adds Error (with id, what and remedy), WorldError, ParseError, UsageError and Cancelled to a module; what core and io throw is
/// raised as these.
void addErrors(pybind11::module_& module);

}  // namespace rubble::python
