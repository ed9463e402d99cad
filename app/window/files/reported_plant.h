#pragma once

#include "app/report/comparison_report.h"

#include <filesystem>

namespace espalier {

class PlantDocument;

// What a report says of the plant that is open.

/// The plant as it is now, which need not be that of any file.
[[nodiscard]] ReportedFile reportedPlant(const PlantDocument& document);

/// The fingerprint of a structure as it is now.
[[nodiscard]] QString fingerprintOf(const Skeleton& skeleton);

/// The scan by its name; none if there is none.
[[nodiscard]] std::optional<ReportedFile> reportedScan(const PlantDocument& document);

/// Identifies the file that the points came from, as it lies now, if it can still be read.
/// @throws Cancelled if `progress` asks to stop
void identifyScan(std::optional<ReportedFile>& scan, const std::filesystem::path& path,
                  const Progress& progress);

} // namespace espalier
