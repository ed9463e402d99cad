#include "app/about/version.h"
#include "app/cli/arguments.h"
#include "app/cli/batch_manifest.h"
#include "app/cli/batch_summary.h"
#include "app/cli/commands.h"
#include "app/cli/doubt_numbers.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/plant_measures.h"
#include "core/evaluate/traits/breast_height.h"
#include "core/io/atomic_file.h"
#include "core/pipeline/preset.h"
#include "core/project/content_hash.h"
#include "core/skeleton/axes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <system_error>

namespace espalier {
namespace {

namespace fs = std::filesystem;

struct BatchFlags {
  std::string manifest;
  std::string folder;
  bool noRotate = false;
  PipelineFlags pipeline;
};

/// A batch that runs.
struct Batch {
  std::vector<BatchPlant> plants;
  std::vector<std::string> names;
  fs::path folder;
  PipelineOptions options;
  std::string unit; // of all scans; empty: not known
  ReadOptions reading;
  std::string readingText; // the same as it was typed; empty: all of each scan
  MtgStyle mtgStyle = MtgStyle::plantNode;
  RegistrationOptions registration; // of results on their references

  [[nodiscard]] fs::path output(const BatchPlant& plant) const {
    return folder / (plant.name + ".mtg");
  }
  [[nodiscard]] fs::path doubts(const BatchPlant& plant) const {
    return folder / (plant.name + ".doubts.json");
  }
};

/// `value` with a few digits, for a table that people read.
std::string shortNumber(double value, const char* format = "%.6g") {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// All that a result depends on, as a text that differs when any of it differs.
std::string inputsOf(const Batch& batch, const BatchPlant& plant) {
  std::ostringstream text;
  text << programVersion() << '\n' << contentHashOfFile(plant.scan) << '\n';
  if (!plant.reference.empty()) text << contentHashOfFile(plant.reference) << '\n';
  if (plant.root)
    for (const double coordinate : *plant.root)
      text << plainDecimal(coordinate) << '\n';
  text << static_cast<int>(batch.options.up) << ' ' << static_cast<int>(batch.mtgStyle) << '\n';
  writePreset(text, batch.options);
  if (!plant.reference.empty() && !batch.registration.turns) text << "no-rotate\n";
  text << batch.readingText;
  if (!batch.unit.empty()) text << "unit " << batch.unit << '\n';
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx",
                static_cast<unsigned long long>(contentHash(text.str())));
  return digits;
}

bool isDoneAlready(const Batch& batch, const BatchPlant& plant, const BatchSummary& summary,
                   const std::string& inputs) {
  const BatchResult* before = summary.find(plant.name);
  std::error_code isMissing;
  return before != nullptr && before->isDone && before->inputs == inputs &&
         fs::is_regular_file(batch.output(plant), isMissing) &&
         fs::is_regular_file(batch.doubts(plant), isMissing);
}

void describe(const Batch& batch, const PointCloud& cloud, const Reconstruction& result,
              BatchResult& row) {
  const Skeleton& skeleton = *result.skeleton;
  std::size_t tips = 0;
  double rootRadius = 0;
  for (const NodeId id : skeleton.ids()) {
    if (skeleton.children(id).empty()) ++tips;
    if (!skeleton[id].parent) rootRadius = std::max(rootRadius, skeleton[id].radius);
  }
  double total = 0;
  for (const Axis& axis : axes(skeleton))
    total += length(skeleton, axis);
  row.points = std::to_string(cloud.size());
  row.spacing = shortNumber(result.scale.spacing);
  row.nodes = std::to_string(skeleton.size());
  row.tips = std::to_string(tips);
  row.length = shortNumber(total);
  row.height = shortNumber(result.scale.height);
  row.rootRadius = shortNumber(rootRadius);
  row.unit = batch.unit;
  if (!(total > 0)) return;
  const PlantMeasures measures =
      plantMeasures(skeleton, {.up = batch.options.up, .breastHeight = breastHeightIn(batch.unit)});
  row.volume = shortNumber(measures.wood.whole.volume);
  if (measures.stemDiameter) row.stemDiameter = shortNumber(*measures.stemDiameter);
  row.crownArea = shortNumber(measures.traits.crown.area);
}

/// What makes the scores doubtful. A shift alone does not: scans and references seldom have one
/// frame.
std::vector<std::string> doubtsIn(const Comparison& comparison) {
  std::vector<ShownMessage> doubts = comparison.warnings;
  const bool isTurned = comparison.registration && comparison.registration->angle() > 0;
  if (!isTurned) std::erase(doubts, comparison.shiftWarning);
  return eachInEnglish(doubts);
}

/// @param spacing  of the points [L]: F is taken at four of them
void judge(const Skeleton& skeleton, const fs::path& reference,
           const RegistrationOptions& registration, double spacing, const Progress& progress,
           BatchResult& row) {
  const Skeleton truth = plantIn(reference.string()).skeleton;
  const Comparison comparison = about(reference.string(), [&] {
    return compare(skeleton, truth,
                   {.registration = registration,
                    .tolerance = {.distances = {4 * spacing}},
                    .placeDistance = 4 * spacing},
                   progress);
  });
  for (const std::string& doubt : doubtsIn(comparison))
    row.notes.push_back(doubt);
  for (const Score* score : scoresIn(inBrief))
    if (const auto& value = comparison.scores.at(score->key))
      row.scores[score->key] = shortNumber(*value, "%.3f");
  row.distance = shortNumber(4 * spacing);
}

/// Reconstructs a plant and writes its structure.
void reconstruct(const Batch& batch, const BatchPlant& plant, const Progress& progress,
                 BatchResult& row) {
  const auto scan = readPoints(plant.scan, batch.reading, progress.part(0, 0.2, "Read"));
  const auto cloud = std::make_shared<const PointCloud>(scan.value);
  PipelineOptions options = batch.options;
  options.root = plant.root;
  const bool isJudged = !plant.reference.empty();
  const Reconstruction result = about(
      plant.scan.string(), [&] { return Pipeline().run(cloud, options, progress.part(0.2, 0.8)); });
  describe(batch, *cloud, result, row);
  row.notes = eachInEnglish(scan.notes);
  for (const std::string& note : notesOf(result))
    row.notes.push_back(note);
  if (isJudged)
    judge(*result.skeleton, plant.reference, batch.registration, result.scale.spacing,
          progress.part(0.8, 0.9, "Compare"), row);
  const nlohmann::ordered_json inDoubt =
      doubtNumbers(cloud, result, options.up, progress.part(isJudged ? 0.9 : 0.8, 1, "Doubts"));
  if (!inDoubt.is_null()) {
    row.expectedRight = shortNumber(inDoubt["expected_right"].get<double>(), "%.3f");
    row.doubts = std::to_string(inDoubt["count"].get<std::size_t>());
  }
  progress.check();
  requireOutput(batch.output(plant).string(), {plant.scan.string()});
  requireOutput(batch.doubts(plant).string(), {plant.scan.string()});
  writeAtomically(batch.doubts(plant), [&](std::ostream& out) { out << textOf(inDoubt); });
  writeStructure(batch.output(plant), {.skeleton = *result.skeleton}, batch.mtgStyle);
}

/// What comes of a plant, whatever happens. @throws Cancelled if `progress` asks to stop
BatchResult tried(const Batch& batch, const BatchPlant& plant, const std::string& inputs,
                  const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  BatchResult row;
  row.name = plant.name;
  row.inputs = inputs;
  const Clock::time_point start = Clock::now();
  try {
    reconstruct(batch, plant, progress, row);
    row.isDone = true;
  } catch (const std::bad_alloc&) {
    row.problem = "not enough memory: close other programs, or thin the scan";
  } catch (const std::exception& problem) {
    row.problem = problem.what();
  }
  row.seconds = shortNumber(std::chrono::duration<double>(Clock::now() - start).count(), "%.2f");
  return row;
}

/// The result of a plant, of this run or, if nothing changed since, of an earlier one.
BatchResult resultOf(const Batch& batch, const BatchPlant& plant, const BatchSummary& summary,
                     const Progress& progress, bool& isSkipped) {
  std::string inputs;
  try {
    if (!plant.problem.empty()) throw Error(plant.problem);
    inputs = inputsOf(batch, plant);
  } catch (const Error& problem) {
    BatchResult row;
    row.name = plant.name;
    row.problem = problem.what();
    return row;
  }
  isSkipped = isDoneAlready(batch, plant, summary, inputs);
  return isSkipped ? *summary.find(plant.name) : tried(batch, plant, inputs, progress);
}

/// @throws Error if a result would replace what is read
void requireOtherOutput(const Batch& batch, const BatchFlags& flags) {
  std::error_code isMissing;
  std::set<fs::path> read;
  const auto add = [&](const fs::path& file) {
    // One that has no place, as for a name that is too long, cannot be read either.
    const fs::path place = fs::weakly_canonical(file, isMissing);
    if (!place.empty()) read.insert(place);
  };
  add(flags.manifest);
  add(flags.pipeline.preset);
  for (const BatchPlant& plant : batch.plants) {
    add(plant.scan);
    add(plant.reference);
  }
  const auto require = [&](const fs::path& file) {
    if (read.contains(fs::weakly_canonical(file, isMissing)))
      throw Error(file.string() +
                  ": is what is read, and would be replaced: choose another folder");
  };
  for (const BatchPlant& plant : batch.plants)
    if (plant.problem.empty()) {
      require(batch.output(plant));
      require(batch.doubts(plant));
    }
  require(batch.folder / "summary.csv");
}

Batch batchOf(const BatchFlags& flags) {
  Batch batch;
  batch.options = flags.pipeline.options("skeleton");
  batch.unit = flags.pipeline.unit;
  batch.mtgStyle = flags.pipeline.mtgStyle;
  const ReadFlags& read = flags.pipeline.read;
  batch.reading = read.options();
  if (read.most > 0) batch.readingText += "most " + std::to_string(read.most) + '\n';
  if (!read.box.empty()) batch.readingText += "box " + read.box + '\n';
  if (!read.columns.empty()) batch.readingText += "columns " + read.columns + '\n';
  batch.registration = {.turns = !flags.noRotate, .up = batch.options.up};
  Imported<std::vector<BatchPlant>> manifest = readManifest(flags.manifest);
  printNotes(manifest.notes);
  batch.plants = std::move(manifest.value);
  for (const BatchPlant& plant : batch.plants)
    batch.names.push_back(plant.name);
  batch.folder = flags.folder;
  requireOtherOutput(batch, flags);
  std::error_code problem;
  fs::create_directories(batch.folder, problem);
  if (problem || !fs::is_directory(batch.folder))
    throw Error(flags.folder + ": is no folder and cannot be made one: choose another");
  return batch;
}

std::string count(std::size_t number, const std::string& what) {
  return std::to_string(number) + ' ' + what;
}

/// Reports what came of all plants. @throws Error if some failed
void reportAll(const std::vector<BatchResult>& failures, std::size_t skipped, std::size_t all,
               const fs::path& summary) {
  std::string text = summary.string() + ": " + count(all, all == 1 ? "plant" : "plants");
  if (skipped > 0) text += ", " + count(skipped, "of them done before");
  printWritten(text);
  for (const BatchResult& failure : failures)
    printLine(failure.name + ": " + failure.problem);
  if (!failures.empty())
    throw Error(count(failures.size(), "of ") + count(all, all == 1 ? "plant" : "plants") +
                " failed: mend what is reported above and start again, what is done is kept");
}

void run(const BatchFlags& flags) {
  const Threads threads(flags.pipeline.threads);
  const Batch batch = batchOf(flags);
  removeLeftovers(batch.folder);
  BatchSummary summary(batch.folder / "summary.csv");
  requireWritable(summary.file());
  TerminalProgress terminal;
  std::vector<BatchResult> failures;
  std::vector<std::string> notes;
  std::size_t skipped = 0;
  const auto all = static_cast<double>(batch.plants.size());
  for (std::size_t i = 0; i < batch.plants.size(); ++i) {
    const BatchPlant& plant = batch.plants[i];
    const auto done = static_cast<double>(i);
    terminal.setSubject(std::to_string(i + 1) + " of " + std::to_string(batch.plants.size()) +
                        ", " + plant.name + ": ");
    try {
      terminal.check();
      bool isSkipped = false;
      const BatchResult result =
          resultOf(batch, plant, summary,
                   terminal.progress().part(done / all, (done + 1) / all, "Read"), isSkipped);
      if (isSkipped) ++skipped;
      if (!isSkipped) summary.put(result, batch.names);
      if (!result.isDone) failures.push_back(result);
      for (const std::string& note : result.notes)
        notes.push_back(plant.name + ": " + note);
    } catch (const Cancelled&) {
      throw StoppedBetween{"stopped after " + std::to_string(i) + " of " +
                           std::to_string(batch.plants.size()) +
                           " plants; start again to go on with the rest"};
    }
  }
  terminal.clear();
  printNotes(notes);
  reportAll(failures, skipped, batch.plants.size(), summary.file());
}

} // namespace

void addBatch(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "batch", "Reconstruct many plants in turn; a bad one does not stop the rest");
  const auto flags = std::make_shared<BatchFlags>();
  command
      ->add_option("MANIFEST", flags->manifest,
                   "CSV table of the plants: a column scan, and name, reference and root if needed")
      ->required();
  addOutput(*command, flags->folder,
            "Folder of the results: NAME.mtg and NAME.doubts.json, what is in doubt, of each "
            "plant, and summary.csv, a line per plant")
      ->type_name("FOLDER");
  flags->pipeline.read.addTo(*command);
  flags->pipeline.addOptionsTo(*command);
  addMtgStyle(*command, flags->pipeline.mtgStyle);
  addNoRotate(*command, flags->noRotate);
  command->callback([flags] { run(*flags); });
  command->footer(
      "Files are sought from the folder of the manifest. Started again, it passes over\n"
      "plants that are done, unless their scan, reference or options changed.\n\n"
      "Example:\n"
      "  espalier batch orchard.csv -o results");
}

} // namespace espalier
