#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "core/fe/fe_result.h"

namespace rubble::python {

/// What rubble.from_arrays() takes, as Python gives it.
struct ArrayInput {
    pybind11::object times;
    pybind11::object positions;
    pybind11::object elements;
    pybind11::object active;
    pybind11::object velocities;  ///< or None
    pybind11::object density;     ///< a number, an array or None
    pybind11::object parts;       ///< or None
    pybind11::object partNames;   ///< or None
    std::string units;            ///< of unitSystems()
};

/// An FE result of solids in memory, copied from arrays. Throws UsageError naming the argument.
std::shared_ptr<const FeResult> resultOfArrays(const ArrayInput& input);

}  // namespace rubble::python
