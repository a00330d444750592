#include "app/python/errors.h"

#include <exception>
#include <string>

#include "core/base/error.h"

namespace rubble::python {

namespace py = pybind11;

namespace {

// Types of the module; they live as long as the interpreter.
PyObject* errorType = nullptr;
PyObject* worldErrorType = nullptr;
PyObject* parseErrorType = nullptr;
PyObject* usageErrorType = nullptr;
PyObject* cancelledType = nullptr;

PyObject* makeType(py::module_& module, const char* name, const char* docstring, PyObject* bases) {
    const std::string full = std::string("rubble.") + name;
    PyObject* type = PyErr_NewExceptionWithDoc(full.c_str(), docstring, bases, nullptr);
    if (type == nullptr) {
        throw py::error_already_set();
    }
    module.attr(name) = py::reinterpret_borrow<py::object>(type);
    return type;
}

void raise(PyObject* type, const Error& error) {
    const py::object raised = py::reinterpret_borrow<py::object>(type)(error.what());
    raised.attr("id") = error.message().id;
    raised.attr("what") = englishText(error.message());
    raised.attr("remedy") = englishText(error.remedy());
    PyErr_SetObject(type, raised.ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) {
            std::rethrow_exception(thrown);
        }
    } catch (const Cancelled& cancelled) {
        PyErr_SetString(cancelledType, cancelled.what());
    } catch (const WorldError& error) {
        raise(worldErrorType, error);
    } catch (const ParseError& error) {
        raise(parseErrorType, error);
    } catch (const UsageError& error) {
        raise(usageErrorType, error);
    } catch (const Error& error) {
        raise(errorType, error);
    }
}

}  // namespace

void addErrors(py::module_& module) {
    errorType =
        makeType(module, "Error",
                 "Root of what Rubble raises on purpose. id is stable, what says what went wrong with the file and the place, "
                 "remedy what to do about it.",
                 nullptr);
    worldErrorType =
        makeType(module, "WorldError", "The world outside failed: a file that cannot be read, a full disk.", errorType);
    parseErrorType = makeType(module, "ParseError", "A file was read but its content is not what it should be.", errorType);
    const py::tuple bases =
        py::make_tuple(py::reinterpret_borrow<py::object>(errorType), py::reinterpret_borrow<py::object>(PyExc_ValueError));
    usageErrorType =
        makeType(module, "UsageError", "A request that cannot be met as put: an unknown parameter, a wrong shape, dtype or unit.",
                 bases.ptr());
    cancelledType =
        makeType(module, "Cancelled", "The progress callback returned False; what was simulated so far is kept.", nullptr);
    for (const char* name : {"id", "what", "remedy"}) {
        py::reinterpret_borrow<py::object>(errorType).attr(name) = "";
    }
    py::register_exception_translator(&translate);
}

}  // namespace rubble::python
