#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/base/counted.h"
#include "core/base/text.h"
#include "core/pipeline/smoothed_scan.h"
#include "core/pipeline/typed_value.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace espalier {
namespace {

struct SmoothFlags {
  PipelineFlags pipeline;
  std::string fill; // empty: no hole is filled
};

std::string inShort(double length) {
  std::ostringstream text;
  text << std::setprecision(3) << length;
  return text.str();
}

/// Up to which width holes are filled; none: no hole is.
std::optional<Rule> widestHole(const SmoothFlags& flags) {
  if (flags.fill.empty()) return std::nullopt;
  const std::optional<Rule> rule = ruleIn(inUnitOf(flags.pipeline.meters(), flags.fill));
  if (!rule || !(rule->value({.spacing = 1, .height = 1, .thickness = 1}) > 0))
    throw WrongUsage("--fill " + inQuotes(flags.fill) +
                     ": write a length above 0, as 0.05, 12sp for spacings of the points, or, with "
                     "--unit, 50mm");
  return rule;
}

/// Those that are asked for; with a method, as the command is there to smooth.
PipelineOptions optionsOf(const SmoothFlags& flags) {
  const Step& step = smoothingStep();
  const std::string& standard = step.methods.back().name;
  PipelineFlags pipeline = flags.pipeline;
  const bool isChosen = std::ranges::any_of(pipeline.settings, [&](const std::string& setting) {
    return setting.starts_with(step.name + ".method=");
  });
  if (pipeline.method.empty() && pipeline.preset.empty() && !isChosen) pipeline.method = standard;
  PipelineOptions options = pipeline.options(step.name);
  options.methods.try_emplace(step.name, standard); // a preset may have none
  if (isOff(step, options))
    throw WrongUsage("method " + chosenMethod(step, options).name +
                     " smooths nothing: leave it out, or see: espalier methods " + step.name);
  return options;
}

void smooth(const SmoothFlags& flags) {
  const PipelineFlags& pipeline = flags.pipeline;
  const Threads threads(pipeline.threads);
  const PipelineOptions options = optionsOf(flags);
  const std::optional<Rule> widest = widestHole(flags);
  requireApart({pipeline.output, pipeline.json});
  requireOutput(pipeline.output, Content::points, {pipeline.scan, pipeline.preset});
  requireOutput(pipeline.json, {pipeline.scan, pipeline.preset});
  const TerminalProgress terminal;
  auto scan = readPoints(pipeline.scan, terminal.progress().part(0, 0.3, "Read"));
  printNotes(scan.notes);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const SmoothedScan smoothed = about(pipeline.scan, [&] {
    return smoothedScan(cloud, options, widest, terminal.progress().part(0.3, 1));
  });
  terminal.check();
  terminal.clear();
  for (const CleaningRecord& record : smoothed.steps)
    printNotes(eachInEnglish(record.notes));
  const std::string unit = pipeline.unit.empty() ? "" : " " + pipeline.unit;
  printLine("moved by " + inShort(smoothed.moved) + unit + " in the mean");
  if (widest)
    printLine(counted(static_cast<std::size_t>(smoothed.added), "new point") + " in holes");
  writeAndReport(pipeline.output, smoothed.points, smoothed.points.positions(),
                 terminal.progress());
  if (pipeline.json.empty()) return;
  writeJson(pipeline.json, {{"scan", pipeline.scan},
                            {"points", cloud->size()},
                            {"kept", smoothed.points.size() - smoothed.added},
                            {"added", smoothed.added},
                            {"mean_move", smoothed.moved},
                            {"spacing", smoothed.scale.spacing},
                            {"method", options.methods.at(smoothingStep().name)}});
}

} // namespace

void addSmooth(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "smooth", "Move the points of a scan to the surface that they sample, and fill its holes");
  const auto flags = std::make_shared<SmoothFlags>();
  flags->pipeline.addTo(*command,
                        "Points to write: PLY (.ply) or text (.xyz, .asc, .txt, .csv, .pts)");
  command
      ->add_option("--fill", flags->fill,
                   "Fill holes of the surface up to this across with new points: a length, as for "
                   "--set")
      ->type_name("LENGTH");
  command->callback([flags] { smooth(*flags); });
  command->footer("Examples:\n"
                  "  espalier smooth trunk.las -o smooth.ply --method planes\n"
                  "  espalier smooth trunk.las -o smooth.ply --set smooth.radius=8sp\n"
                  "  espalier smooth trunk.las -o filled.ply --fill 50mm --unit m");
}

} // namespace espalier
