#pragma once

#include "core/cloud/point_cloud.h"

#include <cstdlib>
#include <iostream>
#include <utility>

namespace espalier::test {

/// Ends the program unless the points of a reader make the cloud that others count on.
inline void requireCloud(RawPoints points) {
  const auto isOnePerPoint = [count = points.positions.size()](std::size_t size) {
    return size == 0 || size == count;
  };
  const bool isWhole =
      isOnePerPoint(points.colors.size()) && isOnePerPoint(points.intensities.size());
  if (isWhole && PointCloud(std::move(points)).positions().allFinite()) return;
  std::cerr << "points that make no cloud\n";
  std::abort();
}

} // namespace espalier::test
