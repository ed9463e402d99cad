#include "app/plot/plot_files.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"
#include "core/io/csv.h"
#include "core/io/formats.h"
#include "core/pipeline/kept_options.h"
#include "core/project/project.h"

#include <ostream>
#include <system_error>
#include <utility>

namespace espalier {
namespace {

namespace fs = std::filesystem;

/// Files that appear in a folder together, or not at all.
class StagedFiles {
public:
  explicit StagedFiles(fs::path folder)
      : folder_(std::move(folder)), stage_(folder_ / ".espalier-plants") {
    std::error_code problem;
    for (fs::path made = folder_; !made.empty() && !fs::exists(made, problem);
         made = made.parent_path())
      made_.push_back(made);
    fs::create_directories(folder_, problem);
    if (problem || !fs::is_directory(folder_))
      throw Error(folder_.string() + ": is no folder and cannot be made one: choose another");
    fs::remove_all(stage_, problem); // of a run that was killed
    if (!fs::create_directory(stage_, problem))
      throw Error(folder_.string() + ": cannot be written to: choose another folder");
  }
  ~StagedFiles() {
    std::error_code ignored;
    fs::remove_all(stage_, ignored);
    for (const fs::path& made : made_)
      fs::remove(made, ignored); // where nothing came to be in it
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
  std::vector<fs::path> made_; // folders that were missing, the innermost first
  std::vector<std::string> names_;
};

/// Digits enough for all: "pine_03".
std::string nameOf(const std::string& plot, std::size_t number, std::size_t count) {
  const std::string digits = std::to_string(number);
  const std::size_t width = std::to_string(count).size();
  return plot + "_" + std::string(width - digits.size(), '0') + digits;
}

std::string placeText(const Eigen::Vector3d& place) {
  return plainDecimal(place.x()) + " " + plainDecimal(place.y()) + " " + plainDecimal(place.z());
}

/// The scan of a plant and the project it is in.
void writePlant(StagedFiles& staged, const std::string& name, const PointCloud& plant,
                const Eigen::Vector3d& root, const PlotFiles& files, const Progress& progress) {
  const fs::path scan = staged.add(name + ".ply");
  writePoints(scan, plant, progress);
  ScanReference reference = ScanReference::of(scan, plant.bounds(), progress);
  std::error_code problem;
  reference.path = fs::absolute(files.folder / (name + ".ply"), problem).lexically_normal();
  Project project = Project::create(staged.add(name + ".espalier"), {});
  project.setScan(reference);
  project.setDocument("name", name);
  project.setDocument(keptOptionsName, keptText({.root = root, .up = files.up}));
  if (!files.unit.empty()) project.setDocument("unit", files.unit);
}

} // namespace

fs::path plantList(const PlotFiles& files) {
  return files.folder / "plants.csv";
}

std::vector<PlantFile> writePlot(const PointCloud& cloud, const std::vector<CutPlant>& plants,
                                 const PlotFiles& files, const Progress& progress) {
  StagedFiles staged(files.folder);
  std::string list = csvLine({"name", "scan", "root"});
  std::vector<PlantFile> written;
  for (std::size_t i = 0; i < plants.size(); ++i) {
    const double share = 1 / static_cast<double>(plants.size());
    const auto done = static_cast<double>(i);
    const std::string name = nameOf(files.name, i + 1, plants.size());
    const PointCloud plant =
        without(cloud, PointSet::firstOf(cloud.size()) - PointSet::of(plants[i].points));
    writePlant(staged, name, plant, plants[i].root, files,
               progress.part(done * share, (done + 1) * share));
    list += csvLine({name, name + ".ply", placeText(plants[i].root)});
    written.push_back({files.folder / (name + ".espalier"), plant.size()});
  }
  writeAtomically(staged.add(plantList(files).filename().string()),
                  [&](std::ostream& out) { out << list; });
  progress.update(1);
  staged.show();
  return written;
}

} // namespace espalier
