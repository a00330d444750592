// An interpreter with Rubble's module built in: rubble_python_host SCRIPT [ARGUMENTS].

#include <pybind11/embed.h>

#include <cstdio>

#include "tests/support/places.h"

extern "C" PyObject* PyInit__rubble();

namespace py = pybind11;

int main(int argc, char** argv) {
    if (argc < 2 || PyImport_AppendInittab("_rubble", &PyInit__rubble) != 0) {
        std::fprintf(stderr, "usage: rubble_python_host SCRIPT [ARGUMENTS]\n");
        return 2;
    }
    const py::scoped_interpreter interpreter(true, argc - 1, argv + 1, false);
    try {
        py::module_ sys = py::module_::import("sys");
        sys.attr("path").attr("insert")(0, rubble::sourcePath("app/python"));
        sys.attr("dont_write_bytecode") = true;
        sys.attr("modules")["rubble._rubble"] = py::module_::import("_rubble");
        py::module_::import("runpy").attr("run_path")(argv[1], py::none(), "__main__");
    } catch (py::error_already_set& raised) {
        if (raised.matches(PyExc_SystemExit)) {
            const py::object code = raised.value().attr("code");
            return code.is_none()                    ? 0
                   : py::isinstance<py::bool_>(code) ? (code.cast<bool>() ? 1 : 0)
                   : py::isinstance<py::int_>(code)  ? code.cast<int>()
                                                     : 1;
        }
        std::fprintf(stderr, "%s\n", raised.what());
        return 1;
    }
    return 0;
}
