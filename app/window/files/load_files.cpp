#include "app/window/files/load_files.h"

#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/io/formats.h"
#include "core/io/glance.h"
#include "ui/document/shown_message.h"

#include <QCoreApplication>
#include <QSettings>

namespace espalier {
namespace {

const QString mostPointsKey = QStringLiteral("most_points_at_once");

Error twoOfAKind(const QString& path, const char* message) {
  return Error(QCoreApplication::translate("LoadFiles", message).arg(path).toStdString());
}

void addNotes(LoadedFiles& loaded, const std::vector<ShownMessage>& notes) {
  for (const ShownMessage& note : firstNotes(notes))
    loaded.notes.append(shownText(note));
}

/// What a file says before it is read; none of a file that says nothing until it is read whole.
std::optional<PointGlance> quickGlance(const std::filesystem::path& path,
                                       const ScanRequest& request) {
  const Format& format = formatOf(path);
  const bool isKnown = format.glance != nullptr || format.glanceByColumns != nullptr;
  if (!isKnown) return std::nullopt;
  return glanceAt(path, request.columns);
}

bool hasMorePoints(const PointGlance& glance, std::uint64_t most) {
  const std::uint64_t error = glance.arePointsEstimated ? glance.points / 10 : 0; // at most
  return glance.points + error > most;
}

void loadScan(LoadedFiles& loaded, const std::filesystem::path& path, const ScanRequest& request,
              const Progress& progress) {
  ReadOptions reading{.box = request.box, .columns = request.columns};
  const std::optional<PointGlance> glance = quickGlance(path, request);
  if (glance && hasMorePoints(*glance, request.mostAtOnce)) reading.most = request.mostAtOnce;
  ImportedCloud points = readPoints(path, reading, progress.part(0, 0.9));
  progress.update(0.9);
  if (points.isPart(reading))
    loaded.part = {reading, points.listed};
  else
    loaded.part.reading.columns = reading.columns;
  loaded.unit = glance ? unitOfSymbol(QString::fromStdString(glance->unit.value))
                       : likelyUnit(points.value.bounds());
  loaded.scanReference = ScanReference::of(path, points.value.bounds(), progress);
  loaded.scan = std::make_unique<const Scan>(std::move(points.value), progress);
  addNotes(loaded, points.notes);
}

} // namespace

ScanRequest scanRequest(const QSettings& settings, const std::optional<Eigen::AlignedBox3d>& box) {
  return {box, settings.value(mostPointsKey, qulonglong{mostPointsAtOnce}).toULongLong()};
}

void keepMostAtOnce(QSettings& settings, std::uint64_t most) {
  settings.setValue(mostPointsKey, qulonglong{most});
}

LoadedFiles loadFiles(const QStringList& paths, const ScanRequest& request,
                      const Progress& progress) {
  LoadedFiles loaded;
  const double share = 1.0 / static_cast<double>(paths.size());
  for (qsizetype i = 0; i < paths.size(); ++i) {
    const Progress part =
        progress.part(share * static_cast<double>(i), share * static_cast<double>(i + 1));
    const std::filesystem::path path = toPath(paths[i]);
    if (formatOf(path).content == Content::points) {
      if (loaded.scan)
        throw twoOfAKind(paths[i],
                         QT_TRANSLATE_NOOP("LoadFiles",
                                           "%1: one scan too many: open two at most, to register "
                                           "one to the other"));
      loadScan(loaded, path, request, part);
      loaded.scanPath = paths[i];
    } else {
      if (loaded.structure)
        throw twoOfAKind(
            paths[i], QT_TRANSLATE_NOOP("LoadFiles", "%1: a second skeleton: open one at a time"));
      Imported<Structure> structure = readAnyStructure(path);
      loaded.structure = std::move(structure.value);
      loaded.structurePath = paths[i];
      addNotes(loaded, structure.notes);
    }
    part.update(1);
  }
  return loaded;
}

LengthUnit likelyUnit(const Eigen::AlignedBox3d& bounds) {
  return unitOfSymbol(QString::fromStdString(unitOfBounds(bounds)));
}

std::filesystem::path toPath(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

} // namespace espalier
