#include "python/arrays.h"

#include "core/base/error.h"

#include <cstdint>
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

template <class T> py::array_t<T> numbersIn(const py::object& object, const char* name) {
  py::array_t<T> array = py::array_t<T, py::array::forcecast>::ensure(object);
  if (!array) {
    PyErr_Clear();
    throw Error(std::string(name) + " are no numbers: give an array of them");
  }
  return array;
}

template py::array_t<double> numbersIn(const py::object&, const char*);
template py::array_t<float> numbersIn(const py::object&, const char*);
template py::array_t<std::int64_t> numbersIn(const py::object&, const char*);
template py::array_t<std::uint8_t> numbersIn(const py::object&, const char*);

} // namespace espalier::python
