#pragma once

#include "app/report/ranking_report.h"
#include "app/report/report_data.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace espalier {

/// What is asked for of a report.
struct ReportFlags {
  std::string file; // to write; empty: none is asked for
  std::string scan; // to show the plants on; may be empty
};

void addReport(CLI::App& command, ReportFlags& flags);

/// Makes sure, before the work, that the report can be written.
/// @param inputs files that are read, which it must not replace
/// @throws Error, WrongUsage
void requireReport(const ReportFlags& flags, const std::vector<std::string>& inputs);

/// The points that the report is to show; none if none are.
[[nodiscard]] std::shared_ptr<const PointCloud> scanFor(const ReportFlags& flags,
                                                        const Progress& progress);

/// What a report is of, beside its numbers.
struct ReportSubject {
  std::string resultFile;
  std::string referenceFile;
  std::string unit;
  double scale = 1;
  double distance = 0; // [L], that was asked for; 0 = usualTolerance()
  RegistrationOptions registration;
  EditOptions edit;
};

/// Draws and writes the report. Reports on standard error what was written.
void writeReport(const ReportFlags& flags, const ReportData& data, const ReportSubject& subject,
                 const Progress& progress);

/// What a report of a ranking is of, beside its numbers.
struct RankingSubject {
  std::vector<std::string> resultFiles; // as they were given
  std::string referenceFile;
  std::string unit;
  double scale = 1;
  std::vector<std::string> notes; // what was said before the numbers
};

/// The same of several results.
void writeReport(const ReportFlags& flags, const RankingReportData& data,
                 const RankingSubject& subject);

} // namespace espalier
