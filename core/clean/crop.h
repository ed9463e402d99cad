#pragma once

#include "core/base/rule.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

// Points outside of a simple solid about the stem. One entry per point; O(N).
// `points`: 3 x N, z up [L]; `foot`: where the plant stands, in their frame [L].

struct SlabOptions {
  Length from = heights(0); // [L] above the lowest point
  Length to = heights(1);   // [L]
};
[[nodiscard]] std::vector<bool> outsideSlab(const Eigen::Matrix3Xf& points,
                                            const SlabOptions& options);

struct DistanceOptions {
  Length distance = heights(1); // [L] level, from the foot
};
[[nodiscard]] std::vector<bool> outsideDistance(const Eigen::Matrix3Xf& points,
                                                const Eigen::Vector3f& foot,
                                                const DistanceOptions& options);

struct BoxOptions {
  Length width = heights(1);  // [L] along x, its middle above the foot
  Length depth = heights(1);  // [L] along y, likewise
  Length height = heights(1); // [L] from the foot up
};
[[nodiscard]] std::vector<bool> outsideBox(const Eigen::Matrix3Xf& points,
                                           const Eigen::Vector3f& foot, const BoxOptions& options);

} // namespace espalier
