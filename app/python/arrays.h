#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace rubble::python {

namespace py = pybind11;

/// An array over memory that Rubble owns: nothing is copied, the array is read-only and keeps the owner alive.
/// @param strides  bytes; empty: rows lie one after the other
template <class T>
py::array_t<T> arrayOver(std::shared_ptr<const void> owner, const T* data, std::vector<py::ssize_t> shape,
                         std::vector<py::ssize_t> strides = {}) {
    py::capsule base(new std::shared_ptr<const void>(std::move(owner)),
                     [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
    py::array_t<T> array(std::move(shape), std::move(strides), data, base);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// A member of every row of a list, without a copy. @param first  the member in the first row
template <class T, class Row>
py::array_t<T> columnOver(std::shared_ptr<const void> owner, const std::vector<Row>& rows, const T* first,
                          std::vector<py::ssize_t> shape = {}) {
    std::vector<py::ssize_t> whole{static_cast<py::ssize_t>(rows.size())};
    std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(sizeof(Row))};
    for (std::size_t d = 0; d < shape.size(); ++d) {
        py::ssize_t step = static_cast<py::ssize_t>(sizeof(T));
        for (std::size_t inner = d + 1; inner < shape.size(); ++inner) {
            step *= shape[inner];
        }
        whole.push_back(shape[d]);
        strides.push_back(step);
    }
    static const T none{};
    return arrayOver<T>(std::move(owner), rows.empty() ? &none : first, std::move(whole), std::move(strides));
}

/// An array of its own with these values.
template <class T>
py::array_t<T> arrayOf(const std::vector<T>& values) {
    return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// What an argument may be.
enum class Values { Reals, Integers, Booleans };

/// Checks an argument that is to be an array and returns it as a contiguous one of T; nothing is rounded or guessed. A length of -1
/// in the shape is free. Throws UsageError that names the argument, what it is and what it should be.
template <class T>
py::array_t<T> takeArray(const py::object& argument, const std::string& name, Values values, const std::vector<py::ssize_t>& shape);

extern template py::array_t<double> takeArray(const py::object&, const std::string&, Values, const std::vector<py::ssize_t>&);
extern template py::array_t<std::int64_t> takeArray(const py::object&, const std::string&, Values, const std::vector<py::ssize_t>&);
extern template py::array_t<bool> takeArray(const py::object&, const std::string&, Values, const std::vector<py::ssize_t>&);

}  // namespace rubble::python
