#include "app/python/arrays.h"

#include <string_view>

#include "core/base/error.h"

namespace rubble::python {

namespace {

std::string_view wordsOf(Values values) {
    switch (values) {
        case Values::Reals:
            return "real numbers (float64 or float32)";
        case Values::Integers:
            return "whole numbers (an integer dtype)";
        case Values::Booleans:
            return "truth values (bool)";
    }
    return "";
}

std::string shapeText(const std::vector<py::ssize_t>& shape) {
    std::string text;
    for (const py::ssize_t length : shape) {
        text += (text.empty() ? "" : ", ") + (length < 0 ? std::string("any") : std::to_string(length));
    }
    return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

bool fits(const py::array& array, Values values) {
    const char kind = array.dtype().kind();
    switch (values) {
        case Values::Reals:
            // Integers are refused: positions in whole numbers are a unit or an index gone astray.
            return kind == 'f' && array.itemsize() <= 8;
        case Values::Integers:
            return kind == 'i' || (kind == 'u' && array.itemsize() < 8);
        case Values::Booleans:
            return kind == 'b';
    }
    return false;
}

}  // namespace

template <class T>
py::array_t<T> takeArray(const py::object& argument, const std::string& name, Values values,
                         const std::vector<py::ssize_t>& shape) {
    const py::array array = py::array::ensure(argument);
    if (!array) {
        PyErr_Clear();
        throw UsageError(
            {"python.array",
             "{0} is no array: it is of the type {1}.",
             {name, std::string(py::str(py::type::handle_of(argument).attr("__name__")))}},
            {"python.array.remedy", "Give a NumPy array of {0} of the shape {1}.", {wordsOf(values), shapeText(shape)}});
    }
    if (!fits(array, values)) {
        throw UsageError({"python.dtype", "{0} has the dtype {1}.", {name, std::string(py::str(array.dtype()))}},
                         {"python.dtype.remedy", "It holds {0}; convert it with {1}.astype().", {wordsOf(values), name}});
    }
    bool same = array.ndim() == static_cast<py::ssize_t>(shape.size());
    std::vector<py::ssize_t> found(array.shape(), array.shape() + array.ndim());
    for (std::size_t d = 0; same && d < shape.size(); ++d) {
        same = shape[d] < 0 || shape[d] == found[d];
    }
    if (!same) {
        throw UsageError({"python.shape", "{0} has the shape {1}.", {name, shapeText(found)}},
                         {"python.shape.remedy", "It must have the shape {0}.", {shapeText(shape)}});
    }
    return py::array_t < T, py::array::c_style | py::array::forcecast > ::ensure(array);
}

template py::array_t<double> takeArray(const py::object&, const std::string&, Values, const std::vector<py::ssize_t>&);
template py::array_t<std::int64_t> takeArray(const py::object&, const std::string&, Values, const std::vector<py::ssize_t>&);
template py::array_t<bool> takeArray(const py::object&, const std::string&, Values, const std::vector<py::ssize_t>&);

}  // namespace rubble::python
