#include "core/base/error.h"
#include "core/evaluate/comparison_json.h"
#include "core/evaluate/comparison_options.h"
#include "core/evaluate/match/comparable.h"
#include "python/bindings.h"
#include "python/held.h"
#include "python/job.h"
#include "python/words.h"

#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>

namespace espalier::python {
namespace {

struct Evaluation {
  ScoreValues scores;
  std::vector<std::string> warnings;
  std::string numbers; // JSON
};

Evaluation evaluate(const HeldSkeleton& result, const HeldSkeleton& reference, bool registers,
                    bool rotates, const std::string& up, const std::optional<std::string>& unit,
                    double distance, const HeldScan* scan, int threads, const py::object& report) {
  if (unit) (void)metersIn(*unit);
  if (!(distance >= 0) || !std::isfinite(distance))
    throw Error("distance is " + std::string(py::str("{:.15g}").format(distance)) +
                ": give a number above 0, or 0 for one that follows from the reference");
  requireComparable(*result.skeleton, "the result");
  requireComparable(*reference.skeleton, "the reference");
  ComparisonOptions options;
  options.registers = registers;
  options.registration.turns = rotates;
  options.registration.up = upAxisIn(up);
  options.breastHeight = breastHeightIn(unit.value_or(""));
  if (scan != nullptr) options.scan.cloud = scan->cloud;
  options = withTolerance(options, *reference.skeleton, distance);
  return resultOf(report, threads, [&](const Progress& progress) {
    Comparison comparison = compare(*result.skeleton, *reference.skeleton, options, progress);
    std::string numbers = toJson(comparison).dump();
    return Evaluation{std::move(comparison.scores), eachInEnglish(comparison.warnings),
                      std::move(numbers)};
  });
}

const char* nameOf(ScoreUnit unit) {
  switch (unit) {
  case ScoreUnit::share:
    return "a share";
  case ScoreUnit::length:
    return "a length";
  case ScoreUnit::count:
    return "a number";
  case ScoreUnit::degrees:
    return "degrees";
  }
  return "";
}

const char* nameOf(Better better) {
  switch (better) {
  case Better::less:
    return ", less is better";
  case Better::more:
    return ", more is better";
  case Better::neither:
    return "";
  }
  return "";
}

std::string documentOfScores() {
  std::string text = "By key; None where one cannot be computed:\n";
  for (const Score& score : scores())
    text += "\n" + score.key + ": " + score.help + " (" + nameOf(score.unit) +
            nameOf(score.better) + ")";
  return text;
}

} // namespace

void bindEvaluate(py::module_& module) {
  py::class_<Evaluation> evaluation(module, "Evaluation", ofPlainType(),
                                    "How a skeleton agrees with its reference.");
  evaluation.def_readonly("scores", &Evaluation::scores, documentOfScores().c_str());
  evaluation.def_readonly("warnings", &Evaluation::warnings,
                          "What makes the numbers doubtful, a line each.");
  evaluation.def_property_readonly(
      "numbers",
      [](const Evaluation& self) {
        return py::module_::import("json").attr("loads")(self.numbers);
      },
      "All that was measured, with the keys of `espalier evaluate --json`: traits of both, the\n"
      "shift, agreement by distance, by order and by height. What that file says of the files,\n"
      "the curve, the errors and the intervals are not among it.");
  module.def(
      "evaluate", &evaluate, py::arg("result"), py::arg("reference"), py::kw_only(),
      py::arg("register") = true, py::arg("rotate") = true, py::arg("up") = "z",
      py::arg("unit") = py::none(), py::arg("distance") = 0.0, py::arg("scan") = py::none(),
      py::arg("threads") = 0, py::arg("progress") = py::none(),
      documented(
          "evaluate(result, reference, *, register=True, rotate=True, up='z', unit=None, "
          "distance=0.0, scan=None, threads=0, progress=None)",
          "Measures a skeleton against its reference, as `espalier evaluate` does.\n\n"
          "register: lay the result on the reference first. rotate: turn it, too, where that\n"
          "fits clearly better. up: x, y or z. unit: of both, mm, cm or m: then the diameter\n"
          "at breast height is measured. distance: what is called near; 0: by the reference.\n"
          "scan: errors of radii are measured by how much of the wood it saw. threads and\n"
          "progress: as of reconstruct().")
          .c_str());
}

} // namespace espalier::python
