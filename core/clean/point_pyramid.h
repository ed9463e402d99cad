#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace espalier {

/// Fewer and fewer of the points of a cloud: each level has every 4th of the one before, so that
/// neighbors there are twice as far on a surface, and all levels cost a third more than the first.
class PointPyramid {
public:
  struct Level {
    Eigen::Matrix3Xf points;
    NearestOthers nearest;            // of each of its points, among them
    std::vector<std::uint32_t> above; // by point: the nearest in the next level; empty in the last
  };

  /// As many levels as have enough points for the neighbors that are asked for, at least one.
  /// @param points  3 x N, finite, near ones together in their order
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic, on all threads. Time O(N log N).
  PointPyramid(const Eigen::Matrix3Xf& points, int neighbors, std::size_t mostLevels,
               const Progress& progress = {});

  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }

private:
  std::vector<Level> levels_;
};

} // namespace espalier
