#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/evaluate/comparable.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/comparison_json.h"
#include "core/io/atomic_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <ostream>

namespace espalier {
namespace {

struct Flags {
  std::string result;
  std::string reference;
  bool noRegister = false;
  std::string unit;
  std::string editUnit = "segment";
  std::string editCost = "topology";
  bool merges = false;
  std::string json;
  int threads = 0;
};

void print(const Comparison& comparison, const std::string& unit) {
  const AuthorsComparison& authors = comparison.authors;
  std::printf("%zu of %zu segments matched with %zu of the reference\n", authors.matches.size(),
              authors.resultSegments.size(), authors.referenceSegments.size());
  std::printf("mapping %.3f  geometric index %.3f  structural index %.3f\n", authors.mapping,
              authors.geometric, authors.structural);
  if (comparison.edit)
    std::printf("edit distance %.6g, similarity %.3f: %zu removed, %zu inserted\n",
                comparison.edit->distance.distance, comparison.edit->distance.similarity(),
                comparison.edit->removed, comparison.edit->inserted);
  if (comparison.registration) {
    const Eigen::Vector3d& shift = comparison.registration->shift;
    std::printf("moved by %.4g, %.4g, %.4g %s, %.4g in all, to lie on the reference\n", shift.x(),
                shift.y(), shift.z(),
                unit.empty() ? "(in the unit of the structures)" : unit.c_str(), shift.norm());
  }
  std::printf("%12s %10s %10s %10s\n", (unit.empty() ? "distance" : "distance/" + unit).c_str(),
              "precision", "recall", "F");
  for (const ToleranceScore& score : comparison.tolerance.scores)
    std::printf("%12.4g %10.3f %10.3f %10.3f\n", score.distance, score.precision, score.recall,
                score.f());
}

Skeleton skeletonIn(const std::string& file) {
  Imported<Structure> structure = readStructure(file);
  printNotes(structure.notes);
  return std::move(structure.value.skeleton);
}

/// Where a name that the parser has checked stands in its list.
template <class Enum> Enum named(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<Enum>(std::ranges::find(names, name) - names.begin());
}

EditOptions editOptions(const Flags& flags) {
  return {.unit = named<EditUnit>(editUnitNames(), flags.editUnit),
          .cost = named<EditCost>(editCostNames(), flags.editCost),
          .mergesPaths = flags.merges};
}

void evaluate(const Flags& flags) {
  const Threads threads(flags.threads);
  requireOutput(flags.json, {flags.result, flags.reference});
  const TerminalProgress terminal;
  const Skeleton result = skeletonIn(flags.result);
  const Skeleton reference = skeletonIn(flags.reference);
  requireComparable(result, flags.result);
  requireComparable(reference, flags.reference);
  ComparisonOptions options;
  options.registers = !flags.noRegister;
  options.edit = editOptions(flags);
  const Comparison comparison = compare(result, reference, options, terminal.progress());
  std::vector<std::string> notes = comparison.warnings;
  std::erase(notes, comparison.shiftWarning); // what is printed tells of the shift
  printNotes(notes);
  print(comparison, flags.unit);
  if (flags.json.empty()) return;
  auto json = toJson(comparison);
  json["result"] = flags.result;
  json["reference"] = flags.reference;
  if (comparison.edit) {
    json["edit_distance"]["unit"] = flags.editUnit;
    json["edit_distance"]["cost"] = flags.editCost;
    json["edit_distance"]["merge_paths"] = flags.merges;
  }
  writeAtomically(flags.json, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

} // namespace

void addEvaluate(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Measure a skeleton against a reference structure");
  const auto flags = std::make_shared<Flags>();
  command->add_option("RESULT", flags->result, "Structure to judge: MTG or node list")->required();
  command->add_option("REFERENCE", flags->reference, "Structure that is taken as true")->required();
  command->add_flag("--no-register", flags->noRegister,
                    "Compare the two where they lie; without it the result is first laid on the "
                    "reference");
  addUnit(*command, flags->unit, "Unit of the structures, to be named with the numbers");
  command
      ->add_option("--edit-unit", flags->editUnit,
                   "What the edit distance edits: node, segment or axis")
      ->check(CLI::IsMember(editUnitNames()).description(""))
      ->type_name("UNIT");
  command
      ->add_option("--edit-cost", flags->editCost,
                   "What an edit costs: topology, attributes, length, place or shape")
      ->check(CLI::IsMember(editCostNames()).description(""))
      ->type_name("COST");
  command->add_flag("--merge-paths", flags->merges,
                    "Let one segment stand for up to three that follow each other");
  command->add_option("--json", flags->json, "File to write all numbers to")->type_name("FILE");
  addThreads(*command, flags->threads);
  command->callback([flags] { evaluate(*flags); });
  command->footer("Lengths are in the unit of the structures.\n\n"
                  "Example:\n"
                  "  espalier evaluate pine.mtg expert.mtg --json numbers.json");
}

} // namespace espalier
