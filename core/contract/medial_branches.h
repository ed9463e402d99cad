#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// The line that the samples about one form.
struct SampleLine {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // unit, of either sign
  double share = 0;                                    // of their spread that lies along it, [0, 1]
};

/// Marks the samples that follow each other in rows as done.
///
/// From the most directed sample that is free, rows go on to both sides to the nearest free sample
/// within `radius` that is directed, too, and turns by less than 25 degrees; five samples and more
/// are a branch. @param lines of the free samples @param isDone by sample, added to
/// @throws Cancelled if `progress` asks to stop; it reports no progress
void markBranches(const Eigen::Matrix3Xf& places, const std::vector<SampleLine>& lines,
                  double radius, double leastShare, std::vector<bool>& isDone,
                  const Progress& progress = {});

/// Where points get that move with the three samples nearest to each of them at the start, the
/// nearer the more. @param start @param end of the samples, 3 x S, S > 0
[[nodiscard]] Eigen::Matrix3Xf carriedAlong(const Eigen::Matrix3Xf& points,
                                            const Eigen::Matrix3Xf& start,
                                            const Eigen::Matrix3Xf& end,
                                            const Progress& progress = {});

} // namespace espalier
