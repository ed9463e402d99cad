#include "app/window/files/load_project.h"

#include "app/window/files/load_files.h"
#include "app/window/files/scan_part.h"
#include "core/base/error.h"
#include "core/cloud/file_order.h"
#include "core/io/formats.h"
#include "core/project/content_hash.h"
#include "core/project/point_bytes.h"
#include "core/project/project_frame.h"
#include "ui/document/shown_message.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace espalier {
namespace {

QString nameOf(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

/// What stands beside the plant must not keep it from being read: what fails is noted.
void tryTo(LoadedProject& loaded, const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    loaded.notes.append(shownText(error));
  }
}

/// The scan that is in the project; null: none.
std::unique_ptr<const Scan> keptScan(const Project& project, const Progress& progress) {
  const std::string bytes = project.bytes(keptCloudName);
  if (bytes.empty()) return nullptr;
  progress.update(0.3);
  PointCloud cloud = cloudFrom(bytes);
  if (cloud.isEmpty())
    throw Error(project.path().string() + ": the scan in it has no points: keep it there again");
  progress.update(0.5);
  return std::make_unique<const Scan>(std::move(cloud), progress);
}

/// The scan of a project, whose file is found.
std::unique_ptr<const Scan> scanIn(const std::filesystem::path& path,
                                   const ScanReference& reference, const ReadOptions& reading,
                                   const Progress& progress) {
  PointCloud cloud = readPoints(path, reading, progress.part(0, 0.8)).value;
  if (reference.isByFile) cloud = sortedAsInFile(cloud, progress.part(0.8, 0.9));
  return std::make_unique<const Scan>(std::move(cloud), progress);
}

void addScan(LoadedProject& loaded, const Progress& progress) {
  const std::optional<ScanReference> reference = loaded.project->scan();
  if (!reference) return;
  loaded.scanReference = reference;
  loaded.scanPath = nameOf(reference->path);
  if (!reference->isByFile) // scans that were joined in a file are read whole
    loaded.reading = scanPartIn(loaded.project->document(scanPartName)).reading;
  tryTo(loaded, [&] { loaded.scan = keptScan(*loaded.project, progress); });
  loaded.isScanKept = loaded.scan != nullptr;
  if (!loaded.isScanKept) {
    const auto found = loaded.project->findScan(progress);
    if (!found) return;
    loaded.scan = scanIn(*found, *reference, loaded.reading, progress);
    loaded.scanPath = nameOf(*found);
  }
  ContractedPoints contracted = contractedIn(*loaded.project);
  if (!contracted.positions || contracted.positions->cols() != loaded.scan->cloud()->size()) return;
  loaded.contracted = std::move(contracted);
  const auto isTheirs = [&](const HistoryStep& step) { return step.id == loaded.contracted.step; };
  if (loaded.isDamaged && std::ranges::none_of(loaded.history.steps, isTheirs))
    loaded.contracted.step = {}; // it was before the first that can be read
}

} // namespace

LoadedProject loadProject(const QString& path, Access access, const Progress& progress) {
  LoadedProject loaded;
  loaded.project = std::make_unique<Project>(Project::open(toPath(path), access));
  Imported<History> history = loaded.project->history();
  loaded.isDamaged = !history.notes.empty();
  for (const ShownMessage& note : history.notes)
    loaded.notes.append(shownText(note));
  loaded.history = std::move(history.value);
  tryTo(loaded, [&] { loaded.frame = frameOf(*loaded.project); });
  tryTo(loaded, [&] {
    loaded.unit = unitOfSymbol(QString::fromStdString(loaded.project->document("unit")));
    loaded.file = QString::fromStdString(loaded.project->document("file"));
  });
  tryTo(loaded, [&] {
    Imported<std::vector<PlantVersion>> versions = loaded.project->versions();
    loaded.versions = std::move(versions.value);
    for (const ShownMessage& note : versions.notes)
      loaded.notes.append(shownText(note));
  });
  tryTo(loaded, [&] { addScan(loaded, progress.part(0.1, 1)); });
  return loaded;
}

std::unique_ptr<const Scan> loadScan(const QString& path, const ScanReference& reference,
                                     const ReadOptions& reading, const Progress& progress) {
  if (contentHashOfFile(toPath(path), progress) != reference.hash)
    throw Error(path.toStdString() + ": is not the scan of this project, which was " +
                reference.path.filename().string() +
                ": choose that, or open this one as a plant of its own");
  return scanIn(toPath(path), reference, reading, progress);
}

} // namespace espalier
