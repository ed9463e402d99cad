#pragma once

#include "app/window/files/scan_part.h"
#include "core/base/progress.h"
#include "core/mtg/structure.h"
#include "core/project/project.h"
#include "ui/document/length_unit.h"
#include "ui/document/scan.h"

#include <QString>
#include <QStringList>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

class QSettings;

namespace espalier {

/// What a set of files holds: at most one scan and one structure.
struct LoadedFiles {
  std::unique_ptr<const Scan> scan; // null: none
  QString scanPath;
  LengthUnit unit = LengthUnit::unknown; // of the scan, as its file says, else as its bounds show
  ScanPart part;                         // of the file that the scan is
  std::optional<ScanReference> scanReference; // to find it again
  std::optional<Structure> structure;
  QString structurePath;
  QStringList notes; // what their user should know of how they were read
};

/// What of a scan is wanted.
struct ScanRequest {
  std::optional<Eigen::AlignedBox3d> box; // all that lies in it [L], frame of the file; none: all
  std::uint64_t mostAtOnce = mostPointsAtOnce; // of a file with more, a sample of as many
  std::vector<PointField> columns = {};        // of a text file; empty: found out
};

/// As the settings have it.
[[nodiscard]] ScanRequest scanRequest(const QSettings& settings,
                                      const std::optional<Eigen::AlignedBox3d>& box = {});
void keepMostAtOnce(QSettings& settings, std::uint64_t most); // for scans from then on

/// Reads the files, each for what its content shows.
/// @throws Error     which file, where in it, what is wrong; or if there are two of a kind
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] LoadedFiles loadFiles(const QStringList& paths, const ScanRequest& request = {},
                                    const Progress& progress = {});

/// As unitOfBounds() of core/io/glance.h.
[[nodiscard]] LengthUnit likelyUnit(const Eigen::AlignedBox3d& bounds);

/// The path of a QString, for core.
[[nodiscard]] std::filesystem::path toPath(const QString& path);

} // namespace espalier
