#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/base/counted.h"
#include "core/pipeline/cleaned_scan.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <utility>

namespace espalier {
namespace {

struct CleanFlags {
  PipelineFlags pipeline;
  std::string leftOut; // file for the rest
};

std::string recordText(const CleaningRecord& record) {
  return record.step->name + ", " + record.method->name + ": " +
         counted(static_cast<std::size_t>(record.leftOut), "point") + " left out";
}

void writeRecords(const CleanFlags& flags, const PointCloud& cloud,
                  const nlohmann::ordered_json& part, const CleanedScan& cleaned) {
  if (flags.pipeline.json.empty()) return;
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();
  for (const CleaningRecord& record : cleaned.steps)
    steps.push_back({{"step", record.step->name},
                     {"method", record.method->name},
                     {"left_out", record.leftOut},
                     {"notes", eachInEnglish(record.notes)}});
  writeJson(flags.pipeline.json,
            {{"scan", flags.pipeline.scan},
             {"part", part},
             {"points", cloud.size()},
             {"kept", cloud.size() - static_cast<Eigen::Index>(cleaned.leftOut.size())},
             {"spacing", cleaned.state.extent.scale.spacing},
             {"height", cleaned.state.extent.scale.height},
             {"steps", std::move(steps)}});
}

void clean(const CleanFlags& flags) {
  const PipelineFlags& pipeline = flags.pipeline;
  const Threads threads(pipeline.threads);
  const PipelineOptions options = pipeline.options("clean");
  const ReadOptions reading = pipeline.read.options();
  requireApart({pipeline.output, flags.leftOut, pipeline.json});
  requireOutput(pipeline.output, Content::points, {pipeline.scan, pipeline.preset});
  if (!flags.leftOut.empty())
    requireOutput(flags.leftOut, Content::points, {pipeline.scan, pipeline.preset});
  requireOutput(pipeline.json, {pipeline.scan, pipeline.preset});
  const TerminalProgress terminal;
  auto scan = readPoints(pipeline.scan, reading, terminal.progress().part(0, 0.3, "Read"));
  printNotes(scan.notes);
  const nlohmann::ordered_json part = partInfo(reading, scan);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const CleanedScan cleaned = about(
      pipeline.scan, [&] { return cleanedScan(cloud, options, terminal.progress().part(0.3, 1)); });
  terminal.check();
  terminal.clear();
  for (const CleaningRecord& record : cleaned.steps) {
    printLine(recordText(record));
    printNotes(eachInEnglish(record.notes));
  }
  const PointCloud kept = without(*cloud, cleaned.leftOut);
  writeAndReport(pipeline.output, kept, kept.positions(), terminal.progress());
  if (!flags.leftOut.empty()) {
    const PointCloud rest = without(*cloud, PointSet::firstOf(cloud->size()) - cleaned.leftOut);
    if (rest.isEmpty())
      printNotes({flags.leftOut + ": not written, as no point was left out"});
    else
      writeAndReport(flags.leftOut, rest, rest.positions(), terminal.progress());
  }
  writeRecords(flags, *cloud, part, cleaned);
}

} // namespace

void addClean(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "clean", "Leave out ground, poles, wires and strays, with --preset plot all but one plant");
  const auto flags = std::make_shared<CleanFlags>();
  flags->pipeline.addTo(
      *command, "Points to write that are kept: PLY (.ply) or text (.xyz, .asc, .txt, .csv, .pts)");
  command->add_option("--left-out", flags->leftOut, "Points to write that are left out, likewise")
      ->type_name("FILE");
  command->callback([flags] { clean(*flags); });
  command->footer("Examples:\n"
                  "  espalier clean plot.las -o tree.ply --preset plot --left-out rest.ply\n"
                  "  espalier clean plot.las -o plants.ply --preset plot --set plant.method=none\n"
                  "  espalier clean pine.las -o pine.ply --set ground.method=cloth\n"
                  "  espalier clean pine.las -o thin.ply --set thin.method=spacing \\\n"
                  "    --set thin.spacing=5mm --unit m\n"
                  "  espalier clean plot.laz -o tree.ply --box 12,30,0,18,36,25");
}

} // namespace espalier
