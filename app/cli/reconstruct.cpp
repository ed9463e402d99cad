#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/doubt_numbers.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/statistics.h"
#include "app/cli/terminal.h"
#include "core/pipeline/quality_of.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// What the two subcommands differ in.
struct Task {
  std::string mainStep; // whose method --method names
  std::string lastStep; // empty: all are run
  Content content;      // of the output
  const char* outputHelp;
};

void writeStatistics(const PipelineFlags& flags, const std::shared_ptr<const PointCloud>& cloud,
                     const nlohmann::ordered_json& part, const PipelineOptions& options,
                     const Reconstruction& result, const TerminalProgress& terminal) {
  if (flags.json.empty()) return;
  nlohmann::ordered_json json = {
      {"scan", flags.scan},
      {"part", part},
      {"unit", flags.unit.empty() ? nlohmann::json(nullptr) : nlohmann::json(flags.unit)},
      {"cloud", statistics(*cloud)}};
  if (!result.skeleton->isEmpty()) json["skeleton"] = statistics(*result.skeleton);
  json["quality"] = statistics(qualityOf(*cloud, result, options), !result.skeleton->isEmpty());
  json.update(statistics(result, terminal.stageSeconds()));
  if (!result.skeleton->isEmpty())
    json["in_doubt"] = doubtNumbers(cloud, result, options.up, terminal.progress());
  terminal.clear();
  writeJson(flags.json, json);
}

/// A skeleton of roots alone is none that one has asked for.
void noteIfBare(const Skeleton& skeleton, const std::string& scan) {
  if (skeleton.roots().size() == skeleton.size())
    printNotes({scan + ": no branch is found: the scan has too few points, or the lengths of the "
                       "steps are too long for it"});
}

void run(const PipelineFlags& flags, const Task& task) {
  const Threads threads(flags.threads);
  const PipelineOptions options = flags.options(task.mainStep);
  const ReadOptions reading = flags.read.options();
  requireApart({flags.output, flags.json});
  requireOutput(flags.output, task.content, {flags.scan, flags.preset});
  requireOutput(flags.json, {flags.scan, flags.preset});
  const TerminalProgress terminal;
  auto scan = readPoints(flags.scan, reading, terminal.progress().part(0, 0.2, "Read"));
  printNotes(scan.notes);
  const nlohmann::ordered_json part = partInfo(reading, scan);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const Reconstruction result = about(flags.scan, [&] {
    return Pipeline().run(cloud, options, terminal.progress().part(0.2, 1), task.lastStep);
  });
  terminal.check();
  terminal.clear();
  if (task.content == Content::structure) {
    noteIfBare(*result.skeleton, flags.scan);
    std::vector<std::string> notes = notesOf(result);
    for (std::string& note : notes)
      note = flags.scan + ": " + note;
    printNotes(notes);
    writeAndReport(flags.output, {.skeleton = *result.skeleton}, flags.mtgStyle, flags.unit);
  } else {
    writeAndReport(flags.output, *cloud, *result.contracted, terminal.progress());
  }
  writeStatistics(flags, cloud, part, options, result, terminal);
}

CLI::App* add(CLI::App& app, const std::string& name, const std::string& help, const Task& task) {
  CLI::App* command = app.add_subcommand(name, help);
  const auto flags = std::make_shared<PipelineFlags>();
  flags->addTo(*command, task.outputHelp);
  if (task.content == Content::structure) addMtgStyle(*command, flags->mtgStyle);
  command->callback([flags, task] { run(*flags, task); });
  return command;
}

} // namespace

void addReconstruct(CLI::App& app) {
  add(app, "reconstruct", "Find the skeleton of a scanned plant, with radii",
      {.mainStep = "skeleton",
       .lastStep = {},
       .content = Content::structure,
       .outputHelp = "Structure to write; its ending sets the format, as .mtg or .txt"})
      ->footer("Examples:\n"
               "  espalier reconstruct pine.las -o pine.mtg\n"
               "  espalier reconstruct pine.las -o pine.mtg --set contract.radius=0.05\n"
               "  espalier reconstruct pine.las -o pine.mtg --mtg-scales plant-axis-node");
}

void addContract(CLI::App& app) {
  add(app, "contract", "Pull the points of a scan towards the axes of the plant",
      {.mainStep = "contract",
       .lastStep = "contract",
       .content = Content::points,
       .outputHelp = "Points to write: PLY (.ply) or text (.xyz, .asc, .txt, .csv, .pts)"})
      ->footer("Example:\n"
               "  espalier contract pine.las -o contracted.ply --set contract.radius=0.05");
}

} // namespace espalier
