// What becomes of a registration: one scan of two, and structures that move with theirs.
#include "app/window/align/registration_flow.h"
#include "app/window/files/file_filters.h"
#include "app/window/files/file_flow.h"
#include "app/window/files/project_flow.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "core/cloud/file_order.h"
#include "core/cloud/joined_clouds.h"
#include "core/evaluate/registration/registration.h"
#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "core/io/points/ply.h"
#include "core/skeleton/edits.h"
#include "ui/document/plant_document.h"

#include <QFileInfo>
#include <QSettings>

#include <filesystem>
#include <utility>

namespace espalier {
namespace {

/// What is joined, and where to.
struct Joining {
  std::shared_ptr<const PointCloud> fixed;
  QString fixedName;
  std::shared_ptr<const PointCloud> moved;
  QString movedName;
  Eigen::Isometry3d motion;
  QString path;
};

/// Reads what was written as it will be opened again: what it holds is what the plant gets.
/// @param written  the file, before it has its name
GrownScan readJoined(const std::filesystem::path& written, const Joining& asked,
                     const Progress& progress) {
  PointCloud cloud =
      sortedAsInFile(readPoints(written, progress.part(0, 0.6)).value, progress.part(0.6, 0.7));
  if (cloud.size() != asked.fixed->size() + asked.moved->size())
    throw Error(asked.path.toStdString() +
                ": would not hold all points of the two scans: move the scans nearer to the zero "
                "of their coordinates");
  GrownScan grown{.scan = nullptr,
                  .path = asked.path,
                  .reference = ScanReference::of(written, cloud.bounds(), progress)};
  grown.reference.path = placeOf(toPath(asked.path));
  grown.reference.isByFile = true;
  progress.update(0.8);
  grown.scan = std::make_unique<const Scan>(std::move(cloud), progress);
  progress.update(1);
  return grown;
}

/// What comes of it: the file is shown once the plant takes the scan.
struct Joined {
  StagedFile file;
  GrownScan grown;
};

/// The points of the open scan come first, in their columns: all that names them goes on to.
Joined joinedIn(const Joining& asked, const Progress& progress) {
  const PlacedCloud fixed{.cloud = std::make_shared<const PointCloud>(listedByColumn(*asked.fixed)),
                          .motion = Eigen::Isometry3d::Identity(),
                          .name = asked.fixedName.toStdString()};
  const PlacedCloud moved{
      .cloud = asked.moved, .motion = asked.motion, .name = asked.movedName.toStdString()};
  const PointCloud all = joined({fixed, moved}, progress.part(0, 0.4));
  StagedFile file(toPath(asked.path), [&](std::ostream& out) {
    writePly(out, all, all.positions(), progress.part(0.4, 0.6));
  });
  GrownScan grown = readJoined(file.written(), asked, progress.part(0.6, 1));
  return {std::move(file), std::move(grown)};
}

/// What of a scan the joined one has not, as the other scan has it not; empty: all of it.
QString droppedByJoining(const PointCloud& one, const PointCloud& other) {
  QStringList dropped;
  if (one.colors().empty() != other.colors().empty())
    dropped.append(RegistrationFlow::tr("colors"));
  if (one.intensities().empty() != other.intensities().empty())
    dropped.append(RegistrationFlow::tr("intensities"));
  return dropped.join(RegistrationFlow::tr(" and "));
}

} // namespace

/// Which scans are joined in part, behind a sentence; empty: both are whole.
QString RegistrationFlow::partsText() const {
  QStringList parts;
  if (parts_.files.showsPart()) parts.append(QFileInfo(parts_.document.scanPath()).fileName());
  if (isPart_) parts.append(name());
  if (parts.isEmpty()) return {};
  return tr(". Of %1, it holds the part that was read").arg(parts.join(tr(" and of ")));
}

void RegistrationFlow::join(const QString& path) {
  parts_.document.requireWritable();
  if (QFileInfo(path).suffix().toLower() != "ply")
    throw Error(
        tr("%1: scans are joined as PLY: choose a name that ends in .ply").arg(path).toStdString());
  for (const QString& scan : {path_, parts_.document.scanPath()})
    if (QFileInfo(path) == QFileInfo(scan))
      throw Error(tr("%1 is one of the two scans: choose another name").arg(path).toStdString());
  const PointCloud& fixed = *parts_.document.scan()->cloud();
  const QString dropped = droppedByJoining(fixed, *other_->cloud());
  const QString parts = partsText();
  const Joining asked{.fixed = parts_.document.scan()->cloud(),
                      .fixedName = QFileInfo(parts_.document.scanPath()).fileName(),
                      .moved = other_->cloud(),
                      .movedName = name(),
                      .motion = registration_.motion(),
                      .path = QFileInfo(path).absoluteFilePath()};
  parts_.jobs.start(
      tr("Joining %1").arg(name()),
      [asked](const Progress& progress) { return joinedIn(asked, progress); },
      [this, asked, dropped, parts](Joined joined) {
        const auto kept = std::make_shared<Joined>(std::move(joined));
        parts_.jobs.afterwards([this, asked, dropped, parts, kept] {
          parts_.window.actions.guarded(
              [&] {
                kept->file.show();
                parts_.projects.growScan(tr("Join %1").arg(asked.movedName),
                                         std::move(kept->grown));
                lastMotion_ = asked.motion;
                refreshActions();
                QString text = tr("Joined %1: the scan of the plant is %2 now")
                                   .arg(asked.movedName, QFileInfo(asked.path).fileName());
                if (!dropped.isEmpty())
                  text += tr(", without %1, which only one of the two has").arg(dropped);
                emit reported({.text = text + parts, .isStep = true});
                return true;
              },
              Refusal::inBanner);
        });
      });
}

void RegistrationFlow::moveStructure(const QString& from, const QString& to) {
  parts_.jobs.requireIdle();
  if (QFileInfo(from) == QFileInfo(to))
    throw Error(tr("%1 is the structure to be moved: choose another name").arg(to).toStdString());
  (void)formatToWrite(toPath(to), Content::structure); // throws what is wrong with the name
  parts_.window.settings.setValue(folderKey, QFileInfo(from).absolutePath());
  const Eigen::Isometry3d motion = isActive() ? registration_.motion() : lastMotion_.value();
  parts_.jobs.start(
      tr("Moving %1").arg(QFileInfo(from).fileName()),
      [from, to, motion](const Progress& progress) {
        Structure structure = readAnyStructure(toPath(from)).value;
        progress.update(0.5);
        structure.skeleton = moved(std::move(structure.skeleton), motion);
        writeStructure(toPath(to), structure, MtgStyle::plantNode);
        return structure;
      },
      [this, to](const Structure& structure) {
        Notice notice{.text = tr("Wrote %1").arg(QFileInfo(to).fileName())};
        if (parts_.document.skeleton().isEmpty() && !parts_.document.isReadOnly())
          notice.actions = {
              {tr("Open It Here"), [this, to, structure] { openMoved(to, structure); }}};
        emit reported(notice);
      });
}

/// As the skeleton of the plant, which had none.
void RegistrationFlow::openMoved(const QString& path, const Structure& structure) {
  parts_.document.edit(tr("Open %1").arg(QFileInfo(path).fileName()), [&](SkeletonEditor& editor) {
    replaceSkeleton(editor, structure.skeleton);
  });
}

} // namespace espalier
