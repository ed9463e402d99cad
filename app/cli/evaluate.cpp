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
#include <array>
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
  bool where = false;
  std::string json;
  int threads = 0;
};

double percent(double share) {
  return 100 * share;
}

/// What hangs on what, within the distance of the landmarks.
void printConnections(const Comparison& comparison) {
  const PathLengthAgreement& ways = comparison.pathLengths;
  const ArchitectureAgreement& architecture = comparison.architecture;
  std::printf("within %.4g of each other: DIADEM-like score %.3f\n", comparison.diadem.distance,
              comparison.diadem.score);
  std::printf("  %5.1f%% of ways along the plant are as long, up to a tenth\n",
              percent(ways.withinTenth));
  std::printf("  %5.1f%% of the length is of the same order, %.1f%% on the same axis\n",
              percent(architecture.sameOrder), percent(architecture.sameAxis));
  std::printf("  %5.1f%% of matched segments begin with the same type of edge\n",
              percent(architecture.sameEdge));
}

void print(const Comparison& comparison, const std::string& unit) {
  const AuthorsComparison& authors = comparison.authors;
  std::printf("%zu of %zu segments matched with %zu of the reference\n", authors.matches.size(),
              authors.resultSegments.size(), authors.referenceSegments.size());
  std::printf("mapping %.3f  geometric index %.3f  structural index %.3f\n", authors.mapping,
              authors.geometric, authors.structural);
  std::printf("over all segments of the reference, structural index %.3f; one to many, geometric "
              "index %.3f\n",
              authors.structuralOfAll, comparison.paths.geometric);
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
  printConnections(comparison);
  std::printf("%12s %10s %10s %10s %10s %10s\n",
              (unit.empty() ? "distance" : "distance/" + unit).c_str(), "precision", "recall", "F",
              "capped G", "capped T");
  for (std::size_t k = 0; k < comparison.tolerance.scores.size(); ++k) {
    const ToleranceScore& score = comparison.tolerance.scores[k];
    std::printf("%12.4g %10.3f %10.3f %10.3f %10.3f %10.3f\n", score.distance, score.precision,
                score.recall, score.f(), comparison.capped[k].geometric,
                comparison.capped[k].structuralOfAll);
  }
}

/// How the wood of a result compares with that of the reference: 0 where there should be none.
double excess(double result, double reference) {
  return reference > 0 ? percent(result / reference - 1) : 0;
}

void printWhere(const Comparison& comparison) {
  const AgreementByPlace& agreed = comparison.byPlace;
  const char* row = "%18s %10.3f %10.3f %12.6g %12.6g\n";
  const auto head = [](const char* what) {
    std::printf("\n%18s %10s %10s %12s %12s\n", what, "precision", "recall", "result", "reference");
  };
  std::printf("\nwithin %.4g, with the lengths there are:", agreed.distance);
  head("order");
  for (const PartAgreement& part : agreed.byOrder)
    std::printf(row, std::to_string(static_cast<int>(part.from)).c_str(), part.precision,
                part.recall, part.resultLength, part.referenceLength);
  head("height");
  for (const PartAgreement& part : agreed.byHeight) {
    std::array<char, 40> range{};
    std::snprintf(range.data(), range.size(), "%.4g to %.4g", part.from, part.to);
    std::printf(row, range.data(), part.precision, part.recall, part.resultLength,
                part.referenceLength);
  }
  std::printf("\n%18s %12s %12s %12s\n", "radius up to", "length +%", "area +%", "volume +%");
  const std::vector<WoodAmount>& result = comparison.resultWood.byRadius;
  const std::vector<WoodAmount>& reference = comparison.referenceWood.byRadius;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    std::array<char, 40> limit{};
    if (k < comparison.radiusLimits.size())
      std::snprintf(limit.data(), limit.size(), "%.4g", comparison.radiusLimits[k]);
    std::printf("%18s %12.1f %12.1f %12.1f\n", limit[0] == 0 ? "more" : limit.data(),
                excess(result[k].length, reference[k].length),
                excess(result[k].area, reference[k].area),
                excess(result[k].volume, reference[k].volume));
  }
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
  if (flags.where) printWhere(comparison);
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
  command->add_flag("--where", flags->where,
                    "Tell by order, height and radius where the two agree");
  command->add_option("--json", flags->json, "File to write all numbers to")->type_name("FILE");
  addThreads(*command, flags->threads);
  command->callback([flags] { evaluate(*flags); });
  command->footer("Lengths are in the unit of the structures.\n\n"
                  "Example:\n"
                  "  espalier evaluate pine.mtg expert.mtg --json numbers.json");
}

} // namespace espalier
