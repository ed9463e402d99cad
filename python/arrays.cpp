#include "python/arrays.h"

#include "core/base/error.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace espalier::python {
namespace {

std::string textOf(const py::array& array) {
  return py::str(array.attr("shape"));
}

} // namespace

py::array viewOf(const py::dtype& type, std::vector<py::ssize_t> shape, const void* data,
                 std::shared_ptr<const void> owner) {
  auto kept = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
  const py::capsule base(kept.get(), [](void* pointer) {
    const std::unique_ptr<std::shared_ptr<const void>> last(
        static_cast<std::shared_ptr<const void>*>(pointer));
  });
  (void)kept.release(); // the capsule has it
  py::array array(type, std::move(shape), data, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

void requireShape(const py::array& array, const char* name, py::ssize_t rows, py::ssize_t columns) {
  const bool isList = columns == 1;
  const bool fits = array.ndim() == (isList ? 1 : 2) && (rows < 0 || array.shape(0) == rows) &&
                    (isList || array.shape(1) == columns);
  if (fits) return;
  const std::string first = rows < 0 ? "n" : std::to_string(rows);
  throw Error(std::string(name) + " have the shape " + textOf(array) +
              ": give an array of shape (" + first +
              (isList ? ",)" : ", " + std::to_string(columns) + ")"));
}

void requireUnmasked(const py::object& object, const char* name) {
  if (!py::hasattr(object, "mask")) return;
  if (py::module_::import("numpy").attr("ma").attr("is_masked")(object).cast<bool>())
    throw Error(std::string(name) +
                " are masked in part: give those that count, as array.data[rows]");
}

template <class T> py::array_t<T> numbersIn(const py::object& object, const char* name) {
  requireUnmasked(object, name);
  const py::array given = py::array::ensure(object);
  if (given && given.dtype().kind() == 'c')
    throw Error(std::string(name) + " are complex numbers: give real ones");
  py::array_t<T> array;
  if (given) array = py::array_t<T, py::array::forcecast>::ensure(given);
  if (!given || !array) {
    PyErr_Clear();
    throw Error(std::string(name) + " are no numbers: give an array of them");
  }
  return array;
}

template py::array_t<double> numbersIn(const py::object&, const char*);
template py::array_t<float> numbersIn(const py::object&, const char*);

template <class T>
py::array_t<T> wholeNumbersIn(const py::object& object, const char* name, T least, T most) {
  using Limits = std::numeric_limits<T>;
  const bool allFit = least == Limits::min() && most == Limits::max();
  if (allFit && py::isinstance<py::array_t<T>>(object))
    return py::reinterpret_borrow<py::array_t<T>>(object);
  const py::array_t<double> given = numbersIn<double>(object, name);
  const py::array_t<double> flat = py::array(given).reshape({py::ssize_t{-1}});
  const auto values = flat.unchecked<1>();
  for (py::ssize_t i = 0; i < values.size(); ++i) {
    const double value = values(i);
    const bool isInside = value >= static_cast<double>(least) && value <= static_cast<double>(most);
    if (isInside && value == std::floor(value)) continue;
    const py::ssize_t columns = given.ndim() > 1 ? given.size() / given.shape(0) : 1;
    throw Error(std::string(name) + ", row " + std::to_string(i / columns) +
                ": write a whole number from " + std::to_string(least) + " to " +
                std::to_string(most) + ", not " + std::string(py::str("{:.15g}").format(value)));
  }
  return py::array_t<T, py::array::forcecast>::ensure(given);
}

template py::array_t<std::int64_t> wholeNumbersIn(const py::object&, const char*, std::int64_t,
                                                  std::int64_t);
template py::array_t<std::uint8_t> wholeNumbersIn(const py::object&, const char*, std::uint8_t,
                                                  std::uint8_t);

} // namespace espalier::python
