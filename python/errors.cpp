#include "core/base/error.h"
#include "python/bindings.h"

namespace espalier::python {

void bindErrors(py::module_& module) {
  const auto error = py::register_exception<Error>(module, "Error");
  error.attr("__doc__") =
      "What you can act on: which file or option, what is wrong, what to try, in one line.";
  const py::object bases = py::make_tuple(error, py::handle(PyExc_AttributeError));
  module.attr("UnknownName") = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
      "espalier.UnknownName", "An Error about a step or option that does not exist.", bases.ptr(),
      nullptr));
}

void throwUnknownName(const std::string& message) {
  const py::object type = py::module_::import("espalier").attr("UnknownName");
  PyErr_SetString(type.ptr(), message.c_str());
  throw py::error_already_set();
}

} // namespace espalier::python
