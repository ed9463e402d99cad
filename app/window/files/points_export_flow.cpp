#include "app/window/files/points_export_flow.h"

#include "app/window/files/file_filters.h"
#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/cloud/point_set.h"
#include "core/io/formats.h"
#include "ui/document/length_unit.h"
#include "ui/document/manual_place.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <utility>

namespace espalier {

PointsExportFlow::PointsExportFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.add({.id = "export_points",
                      .text = tr("Export Points…"),
                      .help = tr("Writes the points that are not set aside, as PLY or text"),
                      .menu = "file/export"},
                     [this] { choose(); });
  for (auto signal : {&PlantDocument::scanChanged, &PlantDocument::leftOutChanged})
    connect(&parts_.document, signal, this, &PointsExportFlow::refresh);
  refresh();
}

void PointsExportFlow::setEnabled(bool isEnabled) {
  isEnabled_ = isEnabled;
  refresh();
}

void PointsExportFlow::refresh() {
  const Scan* scan = parts_.document.scan();
  parts_.actions["export_points"]->setEnabled(
      isEnabled_ && scan != nullptr &&
      static_cast<Eigen::Index>(parts_.document.leftOut().size()) < scan->cloud()->size());
}

void PointsExportFlow::choose() {
  parts_.jobs.requireIdle();
  QFileDialog dialog(&parts_.window, tr("Export the points"));
  setManualPlace(dialog, QStringLiteral("files.md"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(writablePointFilters());
  dialog.setDefaultSuffix(QStringLiteral("ply"));
  proposeBeside(dialog, parts_.document, QStringLiteral(".points.ply"));
  if (dialog.exec() == QDialog::Accepted) write(dialog.selectedFiles().front());
}

void PointsExportFlow::write(const QString& path) {
  (void)formatToWrite(toPath(path), Content::points);
  const QString scan = QFileInfo(parts_.document.scanPath()).canonicalFilePath();
  if (!scan.isEmpty() && QFileInfo(path).canonicalFilePath() == scan)
    throw Error(tr("%1 is the scan itself: choose another name")
                    .arg(QFileInfo(path).fileName())
                    .toStdString());
  parts_.jobs.start(
      tr("Writing %1").arg(QFileInfo(path).fileName()),
      [cloud = parts_.document.scan()->cloud(), leftOut = parts_.document.leftOut(),
       path](const Progress& progress) {
        const PointCloud kept = without(*cloud, leftOut);
        writePoints(toPath(path), kept, progress);
        return static_cast<std::size_t>(kept.size());
      },
      [this, path](std::size_t count) {
        emit reported({.text = tr("Wrote %1: %2 points")
                                   .arg(QDir::toNativeSeparators(path), formatCount(count))});
      });
}

} // namespace espalier
