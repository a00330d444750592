#include <pybind11/pybind11.h>

#include "app/python/bindings.h"
#include "app/python/errors.h"
#include "core/base/build.h"

namespace rubble::python {

namespace {

void fill(pybind11::module_& module) {
    module.doc() = "Rubble: where the deactivated elements of a collapse go. Lengths in m, masses in kg, times in s, z up.";
    module.attr("__version__") = versionText();
    module.attr("build") = buildText();
    addErrors(module);
    addFe(module);
    addResults(module);
    addCollapse(module);
    addRun(module);
    addDrop(module);
}

}  // namespace

}  // namespace rubble::python

PYBIND11_MODULE(_rubble, module) {
    rubble::python::fill(module);
}
