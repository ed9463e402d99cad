#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/evaluate_numbers.h"
#include "app/cli/evaluate_report.h"
#include "app/cli/evaluate_text.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"
#include "core/evaluate/comparable.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/comparison_json.h"
#include "core/evaluate/comparison_warnings.h"
#include "core/evaluate/ranking.h"
#include "core/evaluate/registration.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <ostream>
#include <set>

namespace espalier {
namespace {

struct Flags {
  std::vector<std::string> files; // results, and the reference last
  bool noRegister = false;
  double scale = 1; // of the results
  std::string unit;
  double distance = 0; // [L]; 0 = the rule
  std::string editUnit = "segment";
  std::string editCost = "topology";
  bool merges = false;
  bool where = false;
  bool traits = false;
  bool light = false;
  int pixels = LightOptions().pixels;
  bool ranks = false;
  std::string rankBy; // empty: f
  std::size_t draws = 2000;
  std::uint64_t seed = 1;
  std::string csv;
  std::string json;
  ReportFlags report;
  int threads = 0;
};

Skeleton skeletonIn(const std::string& file, double scale = 1) {
  Imported<Structure> structure = readStructure(file);
  printNotes(structure.notes);
  Skeleton skeleton = std::move(structure.value.skeleton);
  requireComparable(skeleton, file);
  if (scale != 1)
    for (const NodeId id : skeleton.ids()) {
      skeleton.setPosition(id, scale * skeleton[id].position);
      skeleton.setRadius(id, scale * skeleton[id].radius);
    }
  return skeleton;
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

void writeTable(const std::string& file, const std::vector<std::vector<std::string>>& rows) {
  writeAtomically(file, [&](std::ostream& out) {
    for (const std::vector<std::string>& row : rows)
      out << csvLine(row);
  });
}

void writeJson(const std::string& file, const nlohmann::ordered_json& json) {
  if (file.empty()) return;
  writeAtomically(file, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

/// All numbers of a comparison, a line each: "authors.geometric,0.9".
std::vector<std::vector<std::string>> tableOf(const nlohmann::ordered_json& json) {
  std::vector<std::vector<std::string>> rows = {{"name", "value"}};
  const nlohmann::ordered_json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    std::string name = path.substr(1); // they begin with a slash
    std::ranges::replace(name, '/', '.');
    rows.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  return rows;
}

/// Where the two are compared as they lie: how far off the result is, if that decides the scores.
void warnOfShift(Comparison& comparison, const Skeleton& result, const Skeleton& reference,
                 const std::string& unit, const Progress& progress) {
  const double shift = registration(result, reference, {}, progress).shift.norm();
  if (shift <= defaultTolerances(reference).front()) return;
  comparison.warnings.push_back(
      "the result lies about " + plainDecimal(std::round(10 * shift) / 10) +
      (unit.empty() ? "" : " " + unit) +
      " off the reference, which lowers the scores: without --no-register "
      "it is laid on it first");
}

void evaluateOne(const Flags& flags, const TerminalProgress& terminal) {
  const Skeleton result = skeletonIn(flags.files.front(), flags.scale);
  const Skeleton reference = skeletonIn(flags.files.back());
  ComparisonOptions options;
  options.registers = !flags.noRegister;
  options.edit = editOptions(flags);
  if (flags.light) options.light = LightOptions{.pixels = flags.pixels};
  options = withTolerance(options, reference, flags.distance);
  const Progress& whole = terminal.progress();
  const bool hasReport = !flags.report.file.empty();
  const auto scan = scanFor(flags.report, whole.part(0, 0.1, "Reading"));
  Comparison comparison = compare(result, reference, options, whole.part(0.1, 0.4));
  if (flags.noRegister)
    warnOfShift(comparison, result, reference, flags.unit, whole.part(0.4, 0.45));
  std::vector<std::string> notes = comparison.warnings;
  std::erase(notes, comparison.shiftWarning); // what is printed tells of the shift
  printNotes(notes);
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
                 .edit = options.edit},
                whole.part(0.7, 1));
}

void evaluateMany(const Flags& flags, const TerminalProgress& terminal) {
  if (flags.where || flags.merges || flags.traits || flags.light)
    throw WrongUsage("--where, --traits, --light and --merge-paths tell of one result: leave them "
                     "out, or give one");
  if (!flags.report.scan.empty())
    throw WrongUsage("--scan shows the points of one result: leave it out, or give one");
  const std::vector<std::string> names(flags.files.begin(), flags.files.end() - 1);
  const Skeleton reference = skeletonIn(flags.files.back());
  const Traits expected = traits(reference);
  std::vector<Skeleton> results;
  std::vector<std::string> notes;
  for (const std::string& name : names) {
    results.push_back(skeletonIn(name, flags.scale));
    const Traits found = traits(results.back());
    for (const std::string& warning :
         {warningOfTrees(found, "the result"), warningOfSize(found, expected)})
      if (!warning.empty()) notes.push_back(name + ": " + warning);
  }
  printNotes(notes);
  const Ranking found =
      ranking(results, reference,
              {.registers = !flags.noRegister,
               .by = named<Score>(scoreNames(), flags.rankBy.empty() ? "f" : flags.rankBy),
               .distance = flags.distance,
               .draws = flags.draws,
               .seed = flags.seed},
              terminal.progress());
  terminal.clear();
  print(found, names, flags.unit);
  if (!flags.csv.empty()) writeTable(flags.csv, toTable(found, names));
  auto json = toJson(found, names);
  json["reference"] = flags.files.back();
  if (!flags.json.empty()) addOrigin(json, {names, flags.files.back(), {}, flags.unit, true});
  writeJson(flags.json, json);
  if (flags.report.file.empty()) return;
  writeReport(flags.report, rankingReportData(found, results, reference, !flags.noRegister),
              {names, flags.files.back(), flags.unit, flags.scale, notes});
}

void requireSense(const Flags& flags) {
  if (flags.files.size() < 2) throw CLI::RequiredError("REFERENCE");
  const bool isRanking = flags.ranks || flags.files.size() > 2;
  if (!isRanking && !flags.rankBy.empty())
    throw WrongUsage("--rank-by tells how several results are ranked: give more of them, or "
                     "--ranking");
  std::set<std::string> outputs;
  for (const std::string& file : {flags.csv, flags.json, flags.report.file})
    if (!file.empty() && !outputs.insert(file).second)
      throw WrongUsage("two results would be written to " + file + ": give each a file of its own");
}

void evaluate(const Flags& flags) {
  requireSense(flags);
  if (flags.merges && flags.editCost == "topology" && flags.files.size() == 2)
    printNotes(
        {"--merge-paths changes nothing with --edit-cost topology, where each joint costs as "
         "much as the part it saves: choose attributes, length, place or shape"});
  const Threads threads(flags.threads);
  requireOutput(flags.csv, flags.files);
  requireOutput(flags.json, flags.files);
  requireReport(flags.report, flags.files);
  const TerminalProgress terminal;
  if (flags.ranks || flags.files.size() > 2)
    evaluateMany(flags, terminal);
  else
    evaluateOne(flags, terminal);
}

std::vector<std::string> rankingNames() {
  std::vector<std::string> names;
  for (const Score score : rankingScores())
    names.push_back(scoreNames()[static_cast<std::size_t>(score)]);
  return names;
}

void addEdits(CLI::App& command, Flags& flags) {
  command
      .add_option("--edit-unit", flags.editUnit,
                  "What the edit distance edits: node, segment or axis")
      ->check(CLI::IsMember(editUnitNames()).description(""))
      ->type_name("UNIT");
  command
      .add_option("--edit-cost", flags.editCost,
                  "What an edit costs: topology, attributes, length, place or shape")
      ->check(CLI::IsMember(editCostNames()).description(""))
      ->type_name("COST");
  command.add_flag("--merge-paths", flags.merges,
                   "Let one segment stand for up to three that follow each other");
}

void addRanking(CLI::App& command, Flags& flags) {
  command.add_flag("--ranking", flags.ranks,
                   "Rank the results, as is done where there are several");
  command
      .add_option("--rank-by", flags.rankBy,
                  "Score to rank by: " + CLI::detail::join(rankingNames(), ", "))
      ->type_name("NAME")
      ->check(oneOf(rankingNames()))
      ->default_str("f");
  command
      .add_option("--draws", flags.draws,
                  "How often segments are drawn for the intervals of a ranking, 1 to 1000000")
      ->type_name("N")
      ->check(wholeNumber(1, 1e6))
      ->capture_default_str();
  command.add_option("--seed", flags.seed, "The same seed gives the same draws")
      ->type_name("N")
      ->check(wholeNumber(0, 1e15))
      ->capture_default_str();
}

} // namespace

void addEvaluate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "evaluate", "Measure a skeleton against a reference structure, or rank several");
  const auto flags = std::make_shared<Flags>();
  command
      ->add_option("RESULT... REFERENCE", flags->files,
                   "Structures to judge, MTG or node list, and last the one that is taken as true")
      ->expected(1, 10000)
      ->required();
  command->add_flag("--no-register", flags->noRegister,
                    "Compare the two where they lie; without it the result is first laid on the "
                    "reference");
  command
      ->add_option("--scale", flags->scale,
                   "Multiply the results by this first, as by 0.001 from mm to m")
      ->type_name("FACTOR")
      ->check(number(1e-12, 1e12));
  addUnit(*command, flags->unit, "Unit of the structures, to be named with the numbers");
  command
      ->add_option("--distance", flags->distance,
                   "How far apart counts as near, for the report, the ranking and --where")
      ->type_name("LENGTH")
      ->check(number(1e-12, 1e12))
      ->default_str("2/9 of the median edge");
  addEdits(*command, *flags);
  command->add_flag("--where", flags->where,
                    "Tell by order, height and radius where the two agree");
  command->add_flag("--traits", flags->traits,
                    "Tell sizes, Strahler numbers, branching angles and crown of both");
  command->add_flag("--light", flags->light,
                    "Measure how much of its surface each shows to an overcast sky (STAR)");
  command
      ->add_option("--pixels", flags->pixels,
                   "Pixels along the longer side of each picture for --light, 8 to 16384")
      ->type_name("N")
      ->check(wholeNumber(8, 16384))
      ->capture_default_str();
  addRanking(*command, *flags);
  command->add_option("--csv", flags->csv, "File to write all numbers to, as a table")
      ->type_name("FILE");
  command->add_option("--json", flags->json, "File to write all numbers to")->type_name("FILE");
  addReport(*command, flags->report);
  const CLI::Validator isNamed(
      [](const std::string& name) {
        return name.empty() ? std::string("expected the name of a file") : std::string();
      },
      "");
  for (const char* option : {"--csv", "--json", "--report"})
    command->get_option(option)->check(isNamed);
  addThreads(*command, flags->threads);
  command->callback([flags] { evaluate(*flags); });
  command->footer("Lengths are in the unit of the structures.\n\n"
                  "Examples:\n"
                  "  espalier evaluate pine.mtg expert.mtg --json numbers.json\n"
                  "  espalier evaluate pine.mtg expert.mtg --scan pine.ply --report pine.html\n"
                  "  espalier evaluate a.mtg b.mtg c.mtg expert.mtg --csv ranking.csv");
}

} // namespace espalier
