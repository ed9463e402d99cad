#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

namespace espalier::python {

namespace py = pybind11;

/// An array that can only be read, of memory that `owner` keeps: nothing is copied.
[[nodiscard]] py::array viewOf(const py::dtype& type, std::vector<py::ssize_t> shape,
                               const void* data, std::shared_ptr<const void> owner);

template <class T>
[[nodiscard]] py::array viewOf(std::vector<py::ssize_t> shape, const T* data,
                               std::shared_ptr<const void> owner) {
  return viewOf(py::dtype::of<T>(), std::move(shape), data, std::move(owner));
}

/// An array that can only be read, which takes the values.
template <class T>
[[nodiscard]] py::array arrayOf(std::vector<T> values, std::vector<py::ssize_t> shape) {
  const auto kept = std::make_shared<const std::vector<T>>(std::move(values));
  return viewOf(std::move(shape), kept->data(), kept);
}

/// Checks that what was given for `name` has a row of so many columns for each of `rows`, or is a
/// list of so many if `columns` is 1; -1: any number of rows.
/// @throws Error that names the shape to give
void requireShape(const py::array& array, const char* name, py::ssize_t rows, py::ssize_t columns);

/// @throws Error if some of an array are masked: what they hold counts for nothing
void requireUnmasked(const py::object& object, const char* name);

/// `object` as an array of float or double, which is itself if it is one.
/// @throws Error if it holds what are no real numbers
template <class T>
[[nodiscard]] py::array_t<T> numbersIn(const py::object& object, const char* name);

/// `object` as an array of whole numbers, which may be given as doubles, as numpy.loadtxt() reads
/// them. It is itself if it is one, and no number of this type is out of bounds.
/// @throws Error naming the row of what is no whole number from `least` to `most`
template <class T>
[[nodiscard]] py::array_t<T> wholeNumbersIn(const py::object& object, const char* name, T least,
                                            T most);

} // namespace espalier::python
