#include "app/window/files/load_files.h"

#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/io/formats.h"

#include <QCoreApplication>

namespace espalier {
namespace {

Error twoOfAKind(const QString& path, const char* message) {
  return Error(QCoreApplication::translate("LoadFiles", message).arg(path).toStdString());
}

void addNotes(LoadedFiles& loaded, const std::vector<std::string>& notes) {
  for (const std::string& note : firstNotes(notes))
    loaded.notes.append(QString::fromStdString(note));
}

} // namespace

LoadedFiles loadFiles(const QStringList& paths, const Progress& progress) {
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
                                           "%1: a second scan: open one at a time, or join them "
                                           "first with \"espalier register\""));
      Imported<PointCloud> points = readPoints(path, part.part(0, 0.9));
      part.update(0.9);
      loaded.scanReference = ScanReference::of(path, points.value.bounds());
      loaded.scan = std::make_unique<const Scan>(std::move(points.value));
      loaded.scanPath = paths[i];
      addNotes(loaded, points.notes);
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

LengthUnit likelyUnit(double extent) {
  if (extent > 100) return LengthUnit::millimeter; // no tree is 100 m high
  return extent > 0.05 ? LengthUnit::meter : LengthUnit::unknown;
}

std::filesystem::path toPath(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

} // namespace espalier
