#pragma once

#include "core/io/points/read_options.h"
#include "core/mtg/structure.h"
#include "core/project/contracted_points.h"
#include "core/project/project.h"
#include "ui/document/length_unit.h"
#include "ui/document/scan.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// All that a project holds, read.
struct LoadedProject {
  std::unique_ptr<Project> project; // open as it was asked for
  History history;
  std::shared_ptr<const MtgFrame> frame;
  std::unique_ptr<const Scan> scan; // null: none, or not found
  QString scanPath;                 // where it is, or was
  bool isScanKept = false;          // read from the project itself
  ReadOptions reading;              // of the scan in its file
  ContractedPoints contracted;
  std::optional<ScanReference> scanReference;
  LengthUnit unit = LengthUnit::unknown;
  QString file;                       // of a session: where its skeleton was read from or saved to
  std::vector<PlantVersion> versions; // the oldest first
  bool isDamaged = false;
  QStringList notes; // what its user should know
};

/// @throws Error     which file, what is wrong: as Project::open; or that the scan cannot be read
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] LoadedProject loadProject(const QString& path, Access access,
                                        const Progress& progress = {});

/// The scan of a project, at another place than it knows.
/// @param reading  what of the file it is
/// @throws Error if it is another scan
[[nodiscard]] std::unique_ptr<const Scan> loadScan(const QString& path,
                                                   const ScanReference& reference,
                                                   const ReadOptions& reading,
                                                   const Progress& progress = {});

} // namespace espalier
