#include "app/window/files/reported_plant.h"

#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/structures/node_list.h"
#include "core/project/project.h"
#include "ui/document/plant_document.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFileInfo>

#include <sstream>

namespace espalier {
namespace {

struct ReportedPlantText {
  Q_DECLARE_TR_FUNCTIONS(ReportedPlant)
};

} // namespace

QString fingerprintOf(const Skeleton& skeleton) {
  std::ostringstream text;
  writeNodeList(text, skeleton);
  const std::string bytes = text.str();
  return QString::fromLatin1(
      QCryptographicHash::hash(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())),
                               QCryptographicHash::Sha256)
          .toHex());
}

ReportedFile reportedPlant(const PlantDocument& document) {
  const QString name = QFileInfo(document.filePath()).fileName();
  const QString scan = QFileInfo(document.scanPath()).fileName();
  const QString unnamed = scan.isEmpty() ? ReportedPlantText::tr("plant")
                                         : ReportedPlantText::tr("plant of %1").arg(scan);
  ReportedFile plant{name.isEmpty() ? unnamed : name, fingerprintOf(document.skeleton()),
                     ReportedPlantText::tr("hashed as a node list")};
  plant.isToExport =
      name.isEmpty() || document.isModified() || isProject(toPath(document.filePath()));
  return plant;
}

std::optional<ReportedFile> reportedScan(const PlantDocument& document) {
  if (document.scan() == nullptr) return std::nullopt;
  const QString name = QFileInfo(document.scanPath()).fileName();
  return ReportedFile{.name = name.isEmpty() ? ReportedPlantText::tr("points of the plant") : name};
}

void identifyScan(std::optional<ReportedFile>& scan, const std::filesystem::path& path,
                  const Progress& progress) {
  if (!scan || path.empty()) return;
  try {
    scan = reportedFile(path, progress);
  } catch (const Error&) {
    scan->note = ReportedPlantText::tr("the file can no longer be read");
  }
}

} // namespace espalier
