// The scan of a project: kept in it, or found again.
#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/files/project_flow.h"
#include "app/window/files/recent_files.h"
#include "core/base/error.h"
#include "core/project/piece_writer.h"
#include "core/project/point_bytes.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <utility>

namespace espalier {
namespace {

const std::string cloudName = keptCloudName; // of the scan, in a project

} // namespace

void ProjectFlow::keepScan(bool isKept) {
  if (!isNamed() || parts_.document.scan() == nullptr)
    throw Error(
        tr("there is no scan in a project: save the plant as a project first").toStdString());
  parts_.jobs.requireIdle();
  recorder_.flush();
  isKeeping_ = isKept;
  auto project = std::make_shared<Project>(recorder_.project()->another());
  const QString name = QFileInfo(QString::fromStdString(project->path().string())).fileName();
  const auto done = [this, isKept, name](bool) {
    isScanKept_ = isKept;
    if (!isKept && !guarded([this] { recorder_.project()->setBytes(cloudName, {}); })) return;
    emit reported(
        {.text = isKept
                     ? tr("%1 holds the scan now").arg(name)
                     : tr("%1 no longer holds the scan: compact it to make it smaller").arg(name)});
  };
  if (isKept)
    parts_.jobs.start(
        tr("Keeping the scan"),
        [project, cloud = parts_.document.scan()->cloud()](const Progress& progress) {
          writeBytes(*project, cloudName, bytesOf(*cloud), progress);
          return true;
        },
        done);
  else
    parts_.jobs.start(
        tr("Looking for the scan"),
        [project](const Progress& progress) {
          if (!project->findScan(progress))
            throw Error(project->path().string() +
                        ": holds the only copy of its scan that is "
                        "found: put the file of the scan beside it first");
          return true;
        },
        done);
}

// A stop that came after the last piece: what was canceled leaves nothing behind.
void ProjectFlow::finishKeeping() {
  if (!std::exchange(isKeeping_, false) || isScanKept_ || recorder_.project() == nullptr) return;
  guarded([this] {
    if (recorder_.project()->hasBytes(cloudName)) recorder_.project()->setBytes(cloudName, {});
  });
}

void ProjectFlow::writeRest() {
  recorder_.writeRest();
  if (isScanKept_ && parts_.document.scan() != nullptr)
    recorder_.writeLater(cloudName,
                         [cloud = parts_.document.scan()->cloud()] { return bytesOf(*cloud); });
}

void ProjectFlow::growScan(const QString& text, GrownScan grown) {
  PlantDocument& document = parts_.document;
  document.requireWritable();
  const PointSet added = PointSet::firstOf(grown.scan->cloud()->size()) -
                         PointSet::firstOf(document.scan()->cloud()->size());
  recorder_.growScan({grown.reference, added});
  scan_ = grown.reference;
  reading_ = {};
  document.growScan(std::move(grown.scan), grown.path);
  document.leaveOut(text, document.leftOut() - added);
  if (isScanKept_ && recorder_.project() != nullptr)
    recorder_.writeLater(cloudName, [cloud = document.scan()->cloud()] { return bytesOf(*cloud); });
  parts_.recent.add(grown.path);
  emit scanGrown();
}

void ProjectFlow::askForScan() {
  const QString path =
      QFileDialog::getOpenFileName(&parts_.window, tr("Find the scan of this project"),
                                   parts_.settings.value(folderKey).toString());
  if (path.isEmpty() || !scan_) return;
  parts_.jobs.start(
      tr("Reading %1").arg(QFileInfo(path).fileName()),
      [path, scan = *scan_, reading = reading_](const Progress& progress) {
        return loadScan(path, scan, reading, progress);
      },
      [this, path](std::unique_ptr<const Scan> scan) {
        ScanReference found = *scan_;
        found.path = toPath(QFileInfo(path).absoluteFilePath());
        parts_.document.setFoundScan(std::move(scan), path);
        setScanReference(found);
        emit scanFound();
      });
}

} // namespace espalier
