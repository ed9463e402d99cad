#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "app/plot/plot_files.h"
#include "core/base/counted.h"
#include "core/base/text.h"
#include "core/pipeline/cleaned_scan.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct PlantsFlags {
  PipelineFlags pipeline;
  std::vector<std::string> bases; // X,Y,Z
};

std::vector<Eigen::Vector3d> basesIn(const PlantsFlags& flags) {
  std::vector<Eigen::Vector3d> bases;
  for (const std::string& text : flags.bases) {
    const std::optional<Eigen::Vector3d> place = placeIn(text);
    if (!place) throw WrongUsage("--base " + inQuotes(text) + ": write three numbers as X,Y,Z");
    bases.push_back(*place);
  }
  return bases;
}

void plants(PlantsFlags flags) {
  if (flags.pipeline.preset.empty()) flags.pipeline.preset = "plot";
  const Threads threads(flags.pipeline.threads);
  const PipelineOptions options = flags.pipeline.options("plant");
  const Step& step = stepNamed("plant");
  if (options.methods.contains(step.name) && isOff(step, options))
    throw WrongUsage(
        "plant.method=none leaves a plot whole, and plants cuts it: leave that out, or "
        "take espalier clean");
  const ReadOptions reading = flags.pipeline.read.options();
  const std::vector<Eigen::Vector3d> bases = basesIn(flags);
  const TerminalProgress terminal;
  auto scan = readPoints(flags.pipeline.scan, reading, terminal.progress().part(0, 0.2, "Read"));
  printNotes(scan.notes);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const CutPlot cut = about(flags.pipeline.scan, [&] {
    return cutPlot(cloud, bases, options, terminal.progress().part(0.2, 0.9));
  });
  const PlotFiles files{.folder = flags.pipeline.output,
                        .name = std::filesystem::path(flags.pipeline.scan).stem().string(),
                        .unit = flags.pipeline.unit,
                        .up = options.up};
  const auto written = writePlot(*cloud, cut.plants, files, terminal.progress().part(0.9, 1));
  terminal.clear();
  for (const CleaningRecord& record : cut.steps)
    printNotes(eachInEnglish(record.notes));
  if (written.size() < bases.size())
    printNotes({"no plant stands at " + std::to_string(bases.size() - written.size()) + " of the " +
                counted(bases.size(), "place") + " of --base"});
  for (const PlantFile& plant : written)
    printWritten(plant.project.string() + ": " +
                 counted(static_cast<std::size_t>(plant.points), "point"));
  printWritten(plantList(files).string() + ": " + counted(written.size(), "plant"));
}

} // namespace

void addPlants(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("plants", "Cut the scan of a plot into its plants, a project each");
  const auto flags = std::make_shared<PlantsFlags>();
  command
      ->add_option("PLOT", flags->pipeline.scan,
                   "Points of several plants, in any format that is read, as PLY or LAS")
      ->required();
  addOutput(*command, flags->pipeline.output,
            "Folder of the results: NAME.ply and NAME.espalier of each plant, and plants.csv, "
            "which espalier batch reads")
      ->type_name("FOLDER");
  command
      ->add_option("--base", flags->bases,
                   "Where a plant stands, as X,Y,Z; once for each plant; without it, stems are "
                   "looked for")
      ->type_name("PLACE")
      ->allow_extra_args(false);
  flags->pipeline.read.addTo(*command);
  flags->pipeline.addOptionsTo(*command);
  command->callback([flags] { plants(*flags); });
  command->footer("Without --preset, the preset plot is used: it leaves out ground, poles, wires\n"
                  "and strays.\n\n"
                  "Examples:\n"
                  "  espalier plants plot.las -o trees\n"
                  "  espalier plants plot.las -o trees --set poles.method=none\n"
                  "  espalier batch trees/plants.csv -o results");
}

} // namespace espalier
