#include "app/window/files/sample_flow.h"

#include "app/window/files/load_files.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "ui/jobs/job_slot.h"

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QStandardPaths>

#include <utility>

namespace espalier {

SampleFlow::SampleFlow(ActionSet& actions, JobSlot& jobs, const QSettings& settings)
    : jobs_(jobs),
      folder_(
          settings
              .value("sample_folder",
                     QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/samples")
              .toString()) {
  actions.add({.id = "sample_plant",
               .text = tr("Sample Plant"),
               .help = tr("Opens a simulated scan of a small tree, to try the program on"),
               .menu = "file/open"},
              [this] { make(); });
}

void SampleFlow::make() {
  jobs_.requireIdle();
  const QString scan = QDir(folder_).filePath("sample_tree.ply");
  const QString truth = QDir(folder_).filePath("sample_tree.mtg");
  if (QFile::exists(scan) && QFile::exists(truth)) {
    emit made(scan);
    return;
  }
  if (!QDir().mkpath(folder_))
    throw Error(tr("%1 cannot be made: choose Open… and a scan of your own")
                    .arg(QDir::toNativeSeparators(folder_))
                    .toStdString());
  jobs_.start(
      tr("Growing a sample plant"),
      [scan, truth](const Progress& progress) {
        constexpr std::uint64_t seed = 4;
        const Skeleton plant =
            growPlant({.height = 2, .segments = 60}, seed, progress.part(0, 0.1));
        SimulatedScan scanned =
            espalier::scan(plant, {.points = 60'000}, seed, progress.part(0.1, 0.9));
        writeStructure(toPath(truth), plant); // the scan last: it says both are there
        writePoints(toPath(scan), PointCloud(std::move(scanned.points)), progress.part(0.9, 1));
        return scan;
      },
      [this](const QString& path) { jobs_.afterwards([this, path] { emit made(path); }); });
}

} // namespace espalier
