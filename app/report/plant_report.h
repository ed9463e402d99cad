#pragma once

#include "app/report/comparison_report.h"
#include "app/report/envelope_numbers.h"
#include "core/evaluate/plant_measures.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>

namespace espalier {

/// What the report of one plant by itself is made of, but for its pictures.
struct PlantReportData {
  Skeleton plant; // in the frame of its file
  UpAxis up = UpAxis::z;
  PlantMeasures measures;                           // the very numbers that JSON and CSV hold
  int pixels = 0;                                   // of the pictures for light
  std::shared_ptr<const PointCloud> scan = nullptr; // null: there is none
  std::optional<ReportedEnvelope> envelope = {};    // about its crown; none: none is drawn
};

/// What it states beside its numbers.
struct PlantReportAbout {
  ReportedFile plant;
  std::optional<ReportedFile> scan;
  QString date;                     // as it is to be written
  QString version;                  // of the program
  QString unit;                     // of lengths: "mm"; empty: not known
  std::optional<HandWork> handWork; // none: the plant has no history
};

/// The report of one plant without a reference. Deterministic: it reads no clock.
[[nodiscard]] Report plantReport(const PlantReportData& data, const ReportPictures& pictures,
                                 const PlantReportAbout& about);

/// All its numbers, with what they are of: `file`, `scan`, `unit`, `up`, `version`, then as
/// toJson(PlantMeasures), and `envelope` where one is drawn (envelope_numbers.h).
[[nodiscard]] nlohmann::ordered_json numbersOf(const PlantReportData& data,
                                               const PlantReportAbout& about);

/// Writes them as the name says: a report as HTML or PDF, or all numbers as JSON or CSV.
/// @param pictures are not looked at for numbers
/// @throws Error if the name ends otherwise, or it cannot be written
void writePlantReport(const std::filesystem::path& path, const PlantReportData& data,
                      const ReportPictures& pictures, const PlantReportAbout& about);
/// @throws Error that says how a name may end
void requirePlantReportName(const std::filesystem::path& path);
/// Is it a report, which has pictures?
[[nodiscard]] bool hasPictures(const std::filesystem::path& path);

} // namespace espalier
