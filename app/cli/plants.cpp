#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/pipeline_flags.h"
#include "app/cli/terminal.h"
#include "core/base/counted.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/project/project.h"

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace espalier {
namespace {

namespace fs = std::filesystem;

struct PlantsFlags {
  PipelineFlags pipeline;
  std::vector<std::string> bases; // X,Y,Z
};

/// Files that appear in a folder together, or not at all.
class StagedFiles {
public:
  explicit StagedFiles(fs::path folder)
      : folder_(std::move(folder)), stage_(folder_ / ".espalier-plants") {
    std::error_code problem;
    isNew_ = fs::create_directories(folder_, problem);
    if (problem || !fs::is_directory(folder_))
      throw Error(folder_.string() + ": is no folder and cannot be made one: choose another");
    fs::remove_all(stage_, problem); // of a run that was killed
    if (!fs::create_directory(stage_, problem))
      throw Error(folder_.string() + ": cannot be written to: choose another folder");
  }
  ~StagedFiles() {
    std::error_code ignored;
    fs::remove_all(stage_, ignored);
    if (isNew_) fs::remove(folder_, ignored); // where nothing came to be in it
  }
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// @throws Error if there is a file of this name: it may hold the work of days
  fs::path add(const std::string& name) {
    std::error_code missing;
    if (fs::exists(folder_ / name, missing))
      throw Error((folder_ / name).string() + ": is there already: choose another folder, or move "
                                              "it away");
    names_.push_back(name);
    return stage_ / name;
  }

  /// @throws Error if one cannot be moved; then none is there
  void show() {
    std::error_code problem;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      fs::rename(stage_ / names_[i], folder_ / names_[i], problem);
      if (!problem) continue;
      std::error_code ignored;
      for (std::size_t j = 0; j < i; ++j)
        fs::remove(folder_ / names_[j], ignored);
      throw Error((folder_ / names_[i]).string() + ": cannot be written: " + problem.message());
    }
  }

private:
  fs::path folder_, stage_;
  bool isNew_ = false;
  std::vector<std::string> names_;
};

/// Digits enough for all: "pine_03".
std::string nameOf(const fs::path& scan, std::size_t number, std::size_t count) {
  const std::string digits = std::to_string(number);
  const std::size_t width = std::to_string(count).size();
  return scan.stem().string() + "_" + std::string(width - digits.size(), '0') + digits;
}

std::string placeText(const Eigen::Vector3d& place) {
  return plainDecimal(place.x()) + " " + plainDecimal(place.y()) + " " + plainDecimal(place.z());
}

/// The scan of a plant and the project it is in.
void writePlant(StagedFiles& files, const fs::path& folder, const std::string& name,
                const PointCloud& plant, const PlantsFlags& flags, const Progress& progress) {
  const fs::path scan = files.add(name + ".ply");
  writePoints(scan, plant, progress);
  ScanReference reference = ScanReference::of(scan, plant.bounds(), progress);
  std::error_code problem;
  reference.path = fs::absolute(folder / (name + ".ply"), problem).lexically_normal();
  Project project = Project::create(files.add(name + ".espalier"), {});
  project.setScan(reference);
  project.setDocument("name", name);
  if (!flags.pipeline.unit.empty()) project.setDocument("unit", flags.pipeline.unit);
}

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
  const ReadOptions reading = flags.pipeline.read.options();
  const std::vector<Eigen::Vector3d> bases = basesIn(flags);
  const TerminalProgress terminal;
  auto scan = readPoints(flags.pipeline.scan, reading, terminal.progress().part(0, 0.2, "Read"));
  printNotes(scan.notes);
  const auto cloud = std::make_shared<const PointCloud>(std::move(scan.value));
  const CutPlot cut = about(flags.pipeline.scan, [&] {
    return cutPlot(cloud, bases, options, terminal.progress().part(0.2, 0.9));
  });
  const fs::path folder(flags.pipeline.output);
  StagedFiles files(folder);
  std::string manifest = csvLine({"name", "scan", "root"});
  std::vector<std::string> written;
  for (std::size_t i = 0; i < cut.plants.size(); ++i) {
    const double share = 1 / static_cast<double>(cut.plants.size());
    const Progress writing = terminal.progress().part(0.9, 1).part(
        static_cast<double>(i) * share, static_cast<double>(i + 1) * share);
    const std::string name = nameOf(flags.pipeline.scan, i + 1, cut.plants.size());
    const PointCloud plant =
        without(*cloud, PointSet::firstOf(cloud->size()) - PointSet::of(cut.plants[i].points));
    writePlant(files, folder, name, plant, flags, writing);
    manifest += csvLine({name, name + ".ply", placeText(cut.plants[i].root)});
    written.push_back((folder / (name + ".espalier")).string() + ": " +
                      counted(static_cast<std::size_t>(plant.size()), "point"));
  }
  writeAtomically(files.add("plants.csv"), [&](std::ostream& out) { out << manifest; });
  terminal.check();
  files.show();
  terminal.clear();
  for (const CleaningRecord& record : cut.steps)
    printNotes(record.notes);
  for (const std::string& plant : written)
    printWritten(plant);
  printWritten((folder / "plants.csv").string() + ": " + counted(cut.plants.size(), "plant"));
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
