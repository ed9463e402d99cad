#pragma once

#include "core/pipeline/pipeline_options.h"

#include <pybind11/pybind11.h>

#include <string>

namespace espalier::python {

/// What an Options of Python holds.
struct HeldOptions {
  PipelineOptions options;
  std::string unit;  // of the scan; empty: not known
  double meters = 0; // in that unit; 0: not known
};

/// The value of an option as Python has it: a word, True or False, or a number.
[[nodiscard]] pybind11::object valueOf(const Option& option, double value);

} // namespace espalier::python
