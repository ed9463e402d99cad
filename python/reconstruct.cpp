#include "core/pipeline/pipeline.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/held.h"
#include "python/job.h"
#include "python/options.h"

#include <pybind11/stl.h>

namespace espalier::python {
namespace {

HeldReconstruction reconstruct(const py::object& points, const HeldOptions* given, int threads,
                               const py::object& report) {
  if (!py::isinstance<HeldScan>(points))
    throw py::type_error("scan is a " +
                         std::string(py::str(py::type::of(points).attr("__name__"))) +
                         ": make a Scan of the points, as espalier.Scan(points)");
  const auto& scan = points.cast<const HeldScan&>();
  const PipelineOptions options = given == nullptr ? PipelineOptions() : given->options;
  auto result = std::make_shared<const Reconstruction>(
      resultOf(report, threads, [&](const Progress& progress) {
        return Pipeline().run(scan.cloud, options, progress);
      }));
  return {
      .scan = scan, .up = options.up, .result = result, .skeleton = {.skeleton = result->skeleton}};
}

py::dict valuesOf(const StepRecord& record) {
  const Method& method = methodNamed(stepNamed(record.step), record.method);
  py::dict values;
  for (std::size_t i = 0; i < record.values.size(); ++i)
    values[py::str(record.values[i].first)] = valueOf(method.options[i], record.values[i].second);
  return values;
}

void bindStepRecord(py::module_& module) {
  py::class_<StepRecord> record(module, "StepRecord", ofPlainType(), "What one step did.");
  record.def_readonly("step", &StepRecord::step, "Its name.");
  record.def_readonly("method", &StepRecord::method, "The method that was used.");
  record.def_property_readonly(
      "values", &valuesOf,
      "The value used for each option; lengths in the unit of the scan, angles in degrees.");
  record.def_property_readonly(
      "notes", [](const StepRecord& self) { return eachInEnglish(self.notes); },
      "What is to be said of its result.");
  record.def("__repr__", [](const StepRecord& self) {
    return "<espalier.StepRecord " + self.step + "." + self.method + ">";
  });
}

void bindReconstruction(py::module_& module) {
  py::class_<HeldReconstruction> found(module, "Reconstruction", ofPlainType(),
                                       "A skeleton with radii, and how it was found.");
  found.def_readonly("scan", &HeldReconstruction::scan, "The points.");
  found.def_readonly("skeleton", &HeldReconstruction::skeleton, "In the frame of the points.");
  found.def_property_readonly(
      "contracted",
      [](const HeldReconstruction& self) {
        const auto& places = self.result->contracted;
        return viewOf({places->cols(), 3}, places->data(), places);
      },
      "(n, 3) floats about the origin of the scan: where contraction has drawn its points.");
  found.def_property_readonly(
      "scale",
      [](const HeldReconstruction& self) {
        const PlantScale& scale = self.result->scale;
        py::dict numbers;
        numbers["spacing"] = scale.spacing;
        numbers["height"] = scale.height;
        numbers["thickness"] = scale.thickness;
        numbers["scatter"] = scale.scatter;
        return numbers;
      },
      "What rules follow from: spacing of the points, height of the plant, thickness of its thin\n"
      "wood (infinite if it is not known) and scatter of the points across the wood.");
  found.def_property_readonly(
      "steps", [](const HeldReconstruction& self) { return self.result->steps; },
      "What each step did, in their order.");
  found.def_property_readonly(
      "notes", [](const HeldReconstruction& self) { return notesOf(*self.result); },
      "What steps have to say of their results, a line each.");
  found.def("__repr__", [](const HeldReconstruction& self) {
    return "<espalier.Reconstruction of " + std::to_string(self.skeleton.skeleton->size()) +
           " nodes>";
  });
}

} // namespace

void bindReconstruct(py::module_& module) {
  bindStepRecord(module);
  bindReconstruction(module);
  module.def(
      "reconstruct", &reconstruct, py::arg("scan"), py::arg("options") = py::none(), py::kw_only(),
      py::arg("threads") = 0, py::arg("progress") = py::none(),
      documented("reconstruct(scan, options=None, *, threads=0, progress=None)",
                 "The skeleton of a scan, as `espalier reconstruct` finds it: the same, bit\n"
                 "for bit, on any number of threads.\n\n"
                 "options: an Options; None: every option follows from the scan.\n"
                 "threads: to use; 0: all there are. progress: called with the fraction done\n"
                 "and the stage. Ctrl+C stops it within a tenth of a second, and nothing has\n"
                 "changed.")
          .c_str());
}

} // namespace espalier::python
