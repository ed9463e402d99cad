#include "core/pipeline/sweep.h"

#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/statistics.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/comparison_warnings.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/csv.h"
#include "core/pipeline/quality_of.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <ostream>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

struct SweepFlags {
  PipelineFlags pipeline;
  std::string name; // STEP.OPTION
  std::vector<std::string> values;
  int count = 7;
  std::string reference;
  bool noRotate = false;
  std::string csv;
};

/// "contract.radius" in its parts.
struct Swept {
  std::string step;
  std::string option;
};

Swept parsed(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos)
    throw WrongUsage(name + " names no option: write STEP.OPTION, such as contract.radius");
  return {name.substr(0, dot), name.substr(dot + 1)};
}

/// The values that were listed, as numbers in the units the option is set in.
std::vector<double> listedValues(const SweepFlags& flags, const Swept& swept,
                                 const PipelineOptions& options, const PlantScale& scale) {
  const Step& step = stepNamed(swept.step);
  const Method& method = chosenMethod(step, options);
  std::vector<double> values;
  const Option& option = optionOfChosen(options, swept.step, swept.option);
  for (const std::string& text : flags.values) {
    PipelineOptions with = options;
    try {
      if (&option == &methodOption(step)) {
        values.push_back(*option.valueOf(methodNamed(step, text).name));
        continue;
      }
      with.setText(step, swept.option, text, flags.pipeline.meters());
    } catch (const Error& problem) {
      throw WrongUsage(problem.what());
    }
    const std::vector<double> all = resolvedValues(step, method, with, scale);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (method.options[i].name == swept.option) values.push_back(all[i]);
  }
  return values;
}

/// What results are scored against, and how they are laid on it first.
struct Reference {
  Skeleton skeleton;
  RegistrationOptions registration;
};

/// What makes scores doubtful of a result that was laid on the reference so.
std::vector<std::string> doubtsIn(const Registration& lay) {
  std::vector<std::string> doubts;
  if (lay.angle() > 0)
    doubts.push_back("the plant was turned by " +
                     plainDecimal(std::round(10 * lay.angle() * 180 / std::numbers::pi) / 10) +
                     " degrees to lie on the reference");
  if (const auto ofFit = warningOfFit(lay)) doubts.push_back(inEnglish(*ofFit));
  return doubts;
}

/// Adds the scores of a result that is laid on the reference first, by their keys, and what makes
/// them doubtful.
void addScores(Json& row, const Skeleton& result, const Reference& reference) {
  const Registration lay = registration(result, reference.skeleton, reference.registration);
  const auto values = studyScores(moved(result, lay.motion), reference.skeleton);
  for (const Score* score : scoresIn(inStudies))
    row["scores"][score->key] = values.at(score->key);
  const std::vector<std::string> doubts = doubtsIn(lay);
  if (!doubts.empty()) row["notes"] = doubts;
}

/// What one value gave.
Json rowOf(const SweepResult& result, const Option& option, const PointCloud& cloud,
           const PipelineOptions& options, const std::optional<Reference>& reference) {
  Json row = {
      {"value", option.takesWords() ? Json(option.wordFor(result.value)) : Json(result.value)}};
  if (!result.failure.empty()) {
    row["failure"] = result.failure;
    return row;
  }
  row["quality"] = statistics(qualityOf(cloud, result.reconstruction, options), true);
  if (reference) addScores(row, *result.reconstruction.skeleton, *reference);
  return row;
}

/// What there is of a row, under the names of its columns.
std::vector<std::pair<std::string, Json>> fieldsOf(const Json& row) {
  std::vector<std::pair<std::string, Json>> fields = {{"value", row["value"]}};
  for (const std::string part : {"quality", "scores"})
    if (row.contains(part))
      for (const auto& [name, value] : row[part].items())
        fields.emplace_back(part + "." + name, value);
  if (row.contains("failure")) fields.emplace_back("failure", row["failure"]);
  return fields;
}

std::string plain(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void writeSweepTable(const std::string& file, const std::vector<Json>& rows) {
  std::vector<std::string> names;
  for (const Json& row : rows)
    for (const auto& [name, value] : fieldsOf(row))
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  writeAndReport(file, [&](std::ostream& out) {
    out << csvLine(names);
    for (const Json& row : rows) {
      std::vector<std::string> line(names.size());
      for (const auto& [name, value] : fieldsOf(row))
        line[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())] =
            plain(value);
      out << csvLine(line);
    }
  });
}

int widthOf(const Score& score) {
  return std::max(5, static_cast<int>(score.key.size()));
}

void printHead(const std::string& name, bool hasReference) {
  std::printf("%20s %9s %7s %9s %7s %10s %11s %6s", name.c_str(), "thickness", "on line",
              "lost tips", "bridges", "length", "unexplained", "nodes");
  if (hasReference)
    for (const Score* score : scoresIn(inBrief))
      std::printf(" %*s", widthOf(*score), score->key.c_str());
  std::printf("\n");
}

void printRow(const Json& row) {
  if (row["value"].is_string())
    std::printf("%20s", row["value"].get<std::string>().c_str());
  else
    std::printf("%20.5g", row["value"].get<double>());
  if (row.contains("failure")) {
    std::printf(" failed: %s\n", row["failure"].get<std::string>().c_str());
    return;
  }
  const Json& quality = row["quality"];
  const std::string tips = quality["lost_tips"].dump() + "/" + quality["tips"].dump();
  std::printf(" %9.2f %6.0f%% %9s %5s %10.5g %11s %6s", quality["residual_thickness"].get<double>(),
              100 * quality["share_on_line"].get<double>(), tips.c_str(),
              quality["webbed_junctions"].dump().c_str(), quality["skeleton_length"].get<double>(),
              quality["unexplained_points"].dump().c_str(), quality["nodes"].dump().c_str());
  if (row.contains("scores"))
    for (const Score* score : scoresIn(inBrief))
      std::printf(" %*.3f", widthOf(*score), row["scores"][score->key].get<double>());
  std::printf("\n");
}

void writeResults(const SweepFlags& flags, const std::vector<Json>& rows) {
  writeSweepTable(flags.csv, rows);
  writeJson(flags.pipeline.json,
            {{"scan", flags.pipeline.scan},
             {"option", flags.name},
             {"reference", flags.reference.empty() ? Json(nullptr) : Json(flags.reference)},
             {"results", rows}});
}

/// What makes the scores of each value doubtful, a line each.
std::vector<std::string> notesIn(const std::string& option, const std::vector<Json>& rows) {
  std::vector<std::string> notes;
  for (const Json& row : rows)
    if (const auto found = row.find("notes"); found != row.end())
      for (const Json& note : *found)
        notes.push_back(option + "=" + plain(row["value"]) + ": " + note.get<std::string>());
  return notes;
}

/// What was set of a step whose methods are tried: the one that is chosen alone has it.
std::vector<std::string> notesOnMethods(const Swept& swept, const Option& option,
                                        const PipelineOptions& options) {
  const Step& step = stepNamed(swept.step);
  const auto set = options.settings.find(swept.step);
  if (&option != &methodOption(step) || set == options.settings.end()) return {};
  std::string names;
  for (const auto& [name, rule] : set->second)
    names += (names.empty() ? "" : ", ") + swept.step + '.' + name;
  return {chosenMethod(step, options).name + " is tried with " + names +
          " as set, other methods by their own defaults"};
}

std::optional<Reference> referenceIn(const SweepFlags& flags) {
  const std::string& file = flags.reference;
  if (file.empty()) return std::nullopt;
  Skeleton skeleton = plantIn(file).skeleton;
  requireComparable(skeleton, file);
  return Reference{.skeleton = std::move(skeleton),
                   .registration = {.turns = !flags.noRotate, .up = flags.pipeline.up}};
}

void run(const SweepFlags& flags) {
  const Threads threads(flags.pipeline.threads);
  const Swept swept = parsed(flags.name);
  const PipelineOptions options = flags.pipeline.options(swept.step);
  const ReadOptions reading = flags.pipeline.read.options();
  const Option* option = nullptr;
  try {
    option = &optionOfChosen(options, swept.step, swept.option);
  } catch (const Error& problem) {
    throw WrongUsage(problem.what());
  }
  const std::vector<std::string> inputs = {flags.pipeline.scan, flags.pipeline.preset,
                                           flags.reference};
  requireApart({flags.csv, flags.pipeline.json});
  requireOutput(flags.csv, inputs);
  requireOutput(flags.pipeline.json, inputs);
  const TerminalProgress terminal;
  const std::optional<Reference> reference = referenceIn(flags);
  auto scan = readPoints(flags.pipeline.scan, reading, terminal.progress().part(0, 0.1, "Read"));
  printNotes(scan.notes);
  printNotes(notesOnMethods(swept, *option, options));
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  std::vector<Json> rows;
  Pipeline pipeline;
  const PlantScale scale = about(flags.pipeline.scan, [&] {
    return scaleAt(stepNamed(swept.step), pipeline, cloud, options,
                   terminal.progress().part(0.1, 0.1));
  });
  const std::vector<double> values = flags.values.empty()
                                         ? sweepValues(*option, scale, flags.count)
                                         : listedValues(flags, swept, options, scale);
  about(flags.pipeline.scan, [&] {
    const auto each = [&](const SweepResult& result) {
      rows.push_back(rowOf(result, *option, *cloud, options, reference));
      terminal.clear();
      if (rows.size() == 1) printHead(flags.name, reference.has_value());
      printRow(rows.back());
      std::fflush(stdout);
    };
    runSweep(pipeline, cloud, options, swept.step, swept.option, values, {},
             terminal.progress().part(0.1, 1), each);
  });
  terminal.check();
  terminal.clear();
  printNotes(notesIn(flags.name, rows));
  writeResults(flags, rows);
}

} // namespace

void addSweep(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("sweep", "Try one option over several values, and judge each");
  const auto flags = std::make_shared<SweepFlags>();
  command
      ->add_option("SCAN", flags->pipeline.scan,
                   "Points of one plant, in any format that is read, as PLY or LAS")
      ->required();
  command
      ->add_option("STEP.OPTION", flags->name,
                   "What to vary, such as contract.radius, or STEP.method for its methods "
                   "(see: espalier methods)")
      ->required();
  command
      ->add_option("--values", flags->values,
                   "Values to try, with commas between; as for --set. Without it, some around the "
                   "default")
      ->delimiter(',')
      ->type_name("LIST");
  command->add_option("--count", flags->count, "How many to try without --values")
      ->check(wholeNumber(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--reference", flags->reference,
                   "Structure to score the results against, in any format that is read")
      ->type_name("FILE");
  addNoRotate(*command, flags->noRotate);
  flags->pipeline.read.addTo(*command);
  flags->pipeline.addOptionsTo(*command);
  flags->pipeline.addRootTo(*command);
  command->add_option("--csv", flags->csv, "File to write a table to, a row per value")
      ->type_name("FILE");
  command->add_option("--json", flags->pipeline.json, "File to write all numbers to")
      ->type_name("FILE");
  command->callback([flags] { run(*flags); });
  command->footer("Example:\n"
                  "  espalier sweep pine.las contract.radius --count 5 --csv radius.csv");
}

} // namespace espalier
