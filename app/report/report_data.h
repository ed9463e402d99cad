#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/differences/differences.h"
#include "core/evaluate/study/ranking.h"
#include "core/skeleton/skeleton.h"

#include <memory>
#include <vector>

namespace espalier {

/// All that a report of two structures is made of, but for its pictures.
struct ReportData {
  Comparison comparison;                            // the very numbers that JSON and CSV hold
  Skeleton result;                                  // laid on the reference
  Skeleton reference;                               //
  double tolerance = 0;                             // [L], what is called near
  ToleranceScore score{};                           // of `comparison`, at the tolerance
  std::vector<ToleranceScore> curve;                // at even distances from 0 on
  Differences differences;                          // at the tolerance
  std::vector<std::size_t> ignored;                 // by hand; where they stand in its parts
  Ranking intervals;                                // of the result alone, at the tolerance
  std::shared_ptr<const PointCloud> scan = nullptr; // null: there is none
  /// From the frame of the reference to that of the scan: identity, or back to where the result
  /// lay, whichever the points are nearer to.
  Eigen::Isometry3d toScan = Eigen::Isometry3d::Identity();
};

/// Which errors a report shows, at most six: the two longest of each kind, or more where there are
/// fewer of another, the longest first; none that is ignored.
/// @return where they stand in differences.parts
[[nodiscard]] std::vector<std::size_t> shownErrors(const ReportData& data);

/// Takes out of what is shown what somebody decided to be no error.
/// @param ignored by their kinds and places, in the frame in which the result lay
void ignore(ReportData& data, const std::vector<DifferingPart>& ignored);

/// Measures what a report shows beyond a comparison.
///
/// @param comparison of these two; its distances hold `tolerance`
/// @param result     where it lay before it was registered
/// @param scan       may be null
/// @param tolerance  [L]; 0 = usualTolerance()
/// @throws Error     if `comparison` was not measured at the tolerance
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see differences(), toleranceCurve() and ranking().
[[nodiscard]] ReportData reportData(Comparison comparison, const Skeleton& result,
                                    const Skeleton& reference,
                                    std::shared_ptr<const PointCloud> scan = nullptr,
                                    double tolerance = 0, const Progress& progress = {});

} // namespace espalier
