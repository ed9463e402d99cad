#include "app/window/evaluate/load_reference.h"

#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/formats.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <utility>

namespace espalier {

Imported<Skeleton> readReference(const QString& path) {
  const std::filesystem::path file = toPath(path);
  if (isProject(file)) {
    Imported<History> history = Project::open(file, Access::readOnly).history();
    return {std::move(history.value.skeleton), std::move(history.notes)};
  }
  if (formatOf(file).content == Content::points)
    throw Error(QCoreApplication::translate("LoadReference",
                                            "%1 is a scan: a reference is a structure, as an MTG")
                    .arg(QFileInfo(path).fileName())
                    .toStdString());
  Imported<Structure> structure = readStructure(file);
  return {std::move(structure.value.skeleton), std::move(structure.notes)};
}

std::optional<ScanReference> scanOfReference(const QString& path) {
  const std::filesystem::path file = toPath(path);
  if (!isProject(file)) return std::nullopt;
  return Project::open(file, Access::readOnly).scan();
}

} // namespace espalier
