#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"
#include "core/evaluate/comparison_warnings.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/study/noise_study.h"
#include "core/io/csv.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <ostream>

namespace espalier {
namespace {

struct NoiseFlags {
  std::string reference;
  std::vector<std::string> kinds;
  std::vector<std::string> scores; // to print; empty: what a reader compares first
  std::uint64_t seed = 1;
  std::size_t repeats = 5;
  bool registers = false;
  double distance = 0; // [L]; 0 = the rule
  std::string unit;
  std::string csv;
  std::string json;
  int threads = 0;
};

std::vector<std::string> kindNames() {
  std::vector<std::string> names;
  for (const PerturbationEntry& entry : perturbations())
    names.push_back(entry.name);
  return names;
}

/// @throws WrongUsage if it is no number
double levelIn(const std::string& level, const std::string& name) {
  if (const auto value = numberIn(level)) return *value;
  throw WrongUsage("level " + inQuotes(level) + " of " + name + ": expected numbers, as " + name +
                   "=0.1,0.5");
}

/// The series that "prune=0.1,0.5" or "prune" stands for.
NoiseSeries seriesOf(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const std::vector<std::string> names = kindNames();
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw WrongUsage(inQuotes(name) + " is no kind of noise: choose one of " +
                     CLI::detail::join(names, ", "));
  NoiseSeries series{static_cast<Perturbation>(found - names.begin()), {}};
  if (equals == std::string::npos) return series;
  for (const std::string& level : CLI::detail::split(text.substr(equals + 1), ','))
    series.levels.push_back(levelIn(level, name));
  return series;
}

struct NoiseColumn {
  std::string key; // of a score
  std::string title;
};

/// The scores that are asked for, or what a reader compares first: all are in the files.
std::vector<NoiseColumn> columnsOf(const std::vector<std::string>& asked) {
  std::vector<NoiseColumn> columns;
  for (const std::string& key : asked)
    columns.push_back({key, key});
  if (asked.empty())
    for (const Score* score : scoresIn(inNoiseText))
      columns.push_back({score->key, score->symbol});
  return columns;
}

void print(const NoiseStudy& study, const std::vector<NoiseColumn>& columns,
           const std::string& unit) {
  const auto widthOf = [](const NoiseColumn& column) {
    return std::max(9, static_cast<int>(column.title.size()));
  };
  const std::string named = unit.empty() ? unit : " " + unit;
  std::printf(
      "means of %zu plants; capped G and F within %.4g%s, DIADEM-like score and paths within "
      "%.4g%s\n",
      study.repeats, study.scores.distance, named.c_str(), study.scores.landmarkDistance,
      named.c_str());
  for (const NoiseCurve& curve : study.curves) {
    const PerturbationEntry& entry = perturbations()[static_cast<std::size_t>(curve.kind)];
    std::printf("\n%22s", (entry.name + ", " + entry.unit).c_str());
    for (const NoiseColumn& column : columns)
      std::printf(" %*s", widthOf(column), column.title.c_str());
    std::printf("\n");
    for (const NoisePoint& point : curve.points) {
      std::printf("%22.4g", point.level);
      for (const NoiseColumn& column : columns)
        std::printf(" %*.3f", widthOf(column), point.scores.at(column.key).mean);
      std::printf("\n");
    }
  }
}

void writeFiles(const NoiseFlags& flags, const NoiseStudy& study) {
  writeAndReport(flags.csv, [&](std::ostream& out) {
    for (const std::vector<std::string>& row : toTable(study))
      out << csvLine(row);
  });
  auto json = toJson(study);
  json["reference"] = flags.reference;
  writeJson(flags.json, json);
}

void noise(const NoiseFlags& flags) {
  const Threads threads(flags.threads);
  requireApart({flags.csv, flags.json});
  requireOutput(flags.csv, {flags.reference});
  requireOutput(flags.json, {flags.reference});
  NoiseOptions options{.series = {},
                       .repeats = flags.repeats,
                       .seed = flags.seed,
                       .registers = flags.registers,
                       .scores = {.distance = flags.distance}};
  for (const std::string& kind : flags.kinds)
    options.series.push_back(seriesOf(kind));
  const TerminalProgress terminal;
  const Skeleton reference = plantIn(flags.reference).skeleton;
  requireComparable(reference, flags.reference);
  const auto ofTrees = warningOfTrees(traits(reference), ComparedAs::reference);
  if (ofTrees) printNotes({inEnglish(*ofTrees)});
  const NoiseStudy study =
      about(flags.reference, [&] { return noiseStudy(reference, options, terminal.progress()); });
  terminal.clear();
  print(study, columnsOf(flags.scores), flags.unit);
  writeFiles(flags, study);
}

} // namespace

void addNoise(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "noise", "Make a reference worse step by step, and see how the scores of evaluate fall");
  const auto flags = std::make_shared<NoiseFlags>();
  command->add_option("REFERENCE", flags->reference, "Structure that is made worse")->required();
  command
      ->add_option("--kind", flags->kinds,
                   "What to do to it, and how much: " + CLI::detail::join(kindNames(), ", ") +
                       ", with levels as in prune=0.1,0.5; without it all, each by its own levels")
      ->type_name("KIND[=LEVEL,...]")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--repeats", flags->repeats, "Plants that are made for each level, 1 to 1000")
      ->type_name("N")
      ->check(wholeNumber(1, 1000))
      ->capture_default_str();
  command->add_option("--seed", flags->seed, "The same seed gives the same plants")
      ->type_name("N")
      ->check(wholeNumber(0, 1e15))
      ->capture_default_str();
  command
      ->add_option("--score", flags->scores,
                   "Score to print, instead of those that are compared first: " +
                       CLI::detail::join(keysOf(scoresIn(inStudies)), ", "))
      ->type_name("NAME")
      ->check(oneOf(keysOf(scoresIn(inStudies))))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--register", flags->registers, "Lay each plant on the reference first");
  command
      ->add_option("--distance", flags->distance,
                   "How far apart counts as near for capped indices, precision, recall and F")
      ->type_name("LENGTH")
      ->check(number(1e-12, 1e12))
      ->default_str("2/9 of the median edge");
  addUnit(*command, flags->unit, "Unit of the structure, to be named with the numbers");
  command->add_option("--csv", flags->csv, "File to write the table of all scores to")
      ->type_name("FILE");
  command->add_option("--json", flags->json, "File to write all numbers to")->type_name("FILE");
  addThreads(*command, flags->threads);
  command->callback([flags] { noise(*flags); });
  command->footer(
      "Examples:\n"
      "  espalier noise expert.mtg --csv noise.csv\n"
      "  espalier noise expert.mtg --kind position=0.5,1,2 --kind prune --repeats 20\n"
      "  espalier noise expert.mtg --kind spurs --score barcode --score invented_length");
}

} // namespace espalier
