#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace espalier::python {

namespace py = pybind11;

// What the module has, each in a source of that name.
void bindErrors(py::module_& module);
void bindScan(py::module_& module);
void bindSkeleton(py::module_& module);
void bindOptions(py::module_& module);
void bindReconstruct(py::module_& module);
void bindDecisions(py::module_& module);
void bindEvaluate(py::module_& module);
void bindSimulate(py::module_& module);

/// That classes are of a type of Python itself, not of pybind11's: so type checkers know them.
[[nodiscard]] inline py::metaclass ofPlainType() {
  return py::metaclass(py::handle(reinterpret_cast<PyObject*>(&PyType_Type)));
}

/// Throws UnknownName of Python: an Error that is also an AttributeError, as hasattr() expects it.
[[noreturn]] void throwUnknownName(const std::string& message);

/// A docstring that begins with the signature, as Python reads it of functions in C.
[[nodiscard]] std::string documented(const std::string& signature, const std::string& text);

} // namespace espalier::python
