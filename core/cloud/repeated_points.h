#pragma once

#include "core/cloud/point_set.h"

#include <vector>

namespace espalier {

/// The points at the same place as one before them: files of a scan overlap, or were joined twice.
/// Each place counts once, by the first of its points that is not in `leftOut`.
///
/// @return none of `leftOut`. O(N): points at one place follow each other in a cloud
[[nodiscard]] PointSet repeatedPoints(const PointCloud& cloud, const PointSet& leftOut = {});

/// For each point whether it does not count: it is in `leftOut`, or repeated. O(N).
[[nodiscard]] std::vector<bool> notCounted(const PointCloud& cloud, const PointSet& leftOut = {});

/// Calls take(point, before) for each point that does not count and lies at the place of the point
/// right before it: in this order, a value goes from the one that counts to all behind it.
template <class Counts, class Take>
void forEachRepeated(const PointCloud& cloud, const Counts& counts, const Take& take) {
  for (Eigen::Index i = 1; i < cloud.size(); ++i)
    if (!counts(i) && cloud.positions().col(i) == cloud.positions().col(i - 1)) take(i, i - 1);
}

} // namespace espalier
