#include "app/cli/plant_file.h"

#include "app/cli/arguments.h"
#include "app/cli/terminal.h"
#include "core/cloud/file_order.h"
#include "core/io/formats.h"
#include "core/project/point_bytes.h"
#include "core/project/project_frame.h"

#include <optional>
#include <utility>

namespace espalier {

Structure plantIn(const std::string& file) {
  if (!isProject(file)) {
    Imported<Structure> structure = readStructure(file);
    printNotes(structure.notes);
    return std::move(structure.value);
  }
  const Project project = Project::open(file, Access::readOnly);
  Imported<History> history = project.history();
  printNotes(history.notes);
  if (history.value.skeleton.isEmpty())
    throw Error(file + ": has no skeleton: reconstruct it in the window, or give its scan to "
                       "espalier reconstruct");
  return {std::move(history.value.skeleton), frameOf(project)};
}

std::shared_ptr<const PointCloud> pointsOf(const Project& project, const PointSet& leftOut,
                                           const Progress& progress) {
  const auto asPlant = [&](const PointCloud& cloud) {
    return std::make_shared<const PointCloud>(without(cloud, leftOut));
  };
  if (const std::string kept = project.bytes(keptCloudName); !kept.empty())
    return asPlant(cloudFrom(kept));
  const std::optional<ScanReference> reference = project.scan();
  if (!reference) return nullptr;
  const auto file = project.findScan(progress);
  if (!file || !project.document("scan_part").empty()) {
    printNotes({project.path().string() +
                (file ? ": a part of its scan was opened" : ": its scan is not found") +
                ": its points are not read"});
    return nullptr;
  }
  const auto points = readPoints(*file, progress);
  printNotes(points.notes);
  return asPlant(reference->isByFile ? sortedAsInFile(points.value, progress) : points.value);
}

std::string unitOfPlant(const std::string& file, const std::string& given) {
  if (!isProject(file)) return given;
  const std::string own = Project::open(file, Access::readOnly).document("unit");
  if (own.empty()) return given;
  if (!given.empty() && given != own)
    throw WrongUsage("--unit " + given + ": " + file + " is in " + own + ": leave --unit out");
  return own;
}

} // namespace espalier
