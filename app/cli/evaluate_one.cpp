#include "app/cli/arguments.h"
#include "app/cli/evaluate_command.h"
#include "app/cli/evaluate_numbers.h"
#include "app/cli/evaluate_text.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "core/base/error.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/comparison_json.h"
#include "core/evaluate/comparison_options.h"
#include "core/evaluate/match/edit_table.h"
#include "core/evaluate/traits_json.h"

#include <nlohmann/json.hpp>

namespace espalier {
namespace {

EditOptions editOptions(const EvaluateFlags& flags) {
  return {.unit = named<EditUnit>(editUnitNames(), flags.editUnit),
          .cost = named<EditCost>(editCostNames(), flags.editCost),
          .mergesPaths = flags.merges};
}

void writeMapping(const std::string& file, const Comparison& comparison, const Skeleton& result,
                  const Skeleton& reference) {
  if (file.empty()) return;
  if (!comparison.edit)
    throw Error(file + ": the plants have too many parts for an edit distance: compare their axes "
                       "by --edit-unit axis");
  writeTable(file, editTable(*comparison.edit, result, reference));
}

} // namespace

void evaluateOne(const EvaluateFlags& flags, const TerminalProgress& terminal) {
  const Skeleton result = skeletonIn(flags.files.front(), flags.scale);
  const Skeleton reference = skeletonIn(flags.files.back());
  ComparisonOptions options;
  options.registers = !flags.noRegister;
  options.registration = registrationIn(flags);
  options.registration.motion = motionIn(flags, result);
  options.edit = editOptions(flags);
  if (flags.light) options.light = LightOptions{.pixels = flags.pixels};
  options = withTolerance(options, reference, flags.distance);
  const Progress& whole = terminal.progress();
  const bool hasReport = !flags.report.file.empty();
  const auto scan = scanFor(flags.report, whole.part(0, 0.1, "Reading"));
  options.scan.cloud = scan;
  options.breastHeight = breastHeightIn(flags.unit);
  Comparison comparison = compare(result, reference, options, whole.part(0.1, 0.4));
  if (flags.noRegister) warnOfPlace(comparison, result, reference, flags, whole.part(0.4, 0.45));
  std::vector<ShownMessage> notes = comparison.warnings;
  std::erase(notes, comparison.shiftWarning); // what is printed names the shift
  printNotes(eachInEnglish(notes));
  terminal.clear();
  print(comparison, options.edit, flags.unit);
  if (flags.where) printWhere(comparison, flags.unit);
  if (flags.traits) printTraits(comparison, flags.unit);
  if (flags.light) printLight(comparison);
  auto json = toJson(comparison);
  json["result"] = flags.files.front();
  json["reference"] = flags.files.back();
  if (comparison.edit) {
    json["edit_distance"]["unit"] = flags.editUnit;
    json["edit_distance"]["cost"] = flags.editCost;
    json["edit_distance"]["merge_paths"] = flags.merges;
  }
  writeMapping(flags.mapping, comparison, result, reference);
  if (!hasReport && flags.csv.empty() && flags.json.empty()) return;
  const ReportData data = reportData(comparison, result, reference, scan, flags.distance,
                                     whole.part(0.45, 0.7, "Measuring"));
  addMeasured(json, data);
  addOrigin(json,
            {{flags.files.front()}, flags.files.back(), flags.report.scan, flags.unit, false});
  if (!flags.csv.empty()) writeTable(flags.csv, tableOf(json));
  writeJson(flags.json, json);
  if (hasReport)
    writeReport(flags.report, data,
                {.resultFile = flags.files.front(),
                 .referenceFile = flags.files.back(),
                 .unit = flags.unit,
                 .scale = flags.scale,
                 .distance = flags.distance,
                 .registration = options.registration,
                 .edit = options.edit},
                whole.part(0.7, 1));
}

} // namespace espalier
