#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/evaluate/comparison.h"
#include "core/skeleton/skeleton.h"

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

/// What a report is of; all must outlive the call.
struct ReportSubject {
  const Comparison& comparison;
  const Skeleton& result; // where it lay, but scaled
  const Skeleton& reference;
  std::shared_ptr<const PointCloud> scan; // may be none
  std::string resultFile;
  std::string referenceFile;
  std::string unit;
  double scale = 1;
  EditOptions edit;
};

/// Measures what else it takes, draws, and writes the report. Tells on standard error what was
/// written.
void writeReport(const ReportFlags& flags, const ReportSubject& subject, const Progress& progress);

} // namespace espalier
