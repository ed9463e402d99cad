#pragma once

#include "core/base/progress.h"

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace espalier::python {

namespace py = pybind11;

/// Runs `work` on a thread of its own while this one waits without the lock of the interpreter:
/// other threads of Python go on, Ctrl+C stops the work, and `report`, unless it is None, is called
/// with the fraction done and the stage, on this thread.
///
/// @param threads  for the loops of the work; 0: all there are
/// @throws whatever `work`, `report` or a handler of signals throws; then the work has stopped
void runJob(const py::object& report, int threads,
            const std::function<void(const Progress&)>& work);

/// The same of work that has a result.
template <class Work> auto resultOf(const py::object& report, int threads, const Work& work) {
  std::optional<std::invoke_result_t<Work, const Progress&>> result;
  runJob(report, threads, [&](const Progress& progress) { result = work(progress); });
  return *std::move(result);
}

} // namespace espalier::python
