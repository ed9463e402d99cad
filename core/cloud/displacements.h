#pragma once

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// How far contraction moved each point [L].
/// @param scanned, contracted 3 x N [L]
[[nodiscard]] inline std::vector<float> displacements(const Eigen::Matrix3Xf& scanned,
                                                      const Eigen::Matrix3Xf& contracted) {
  const Eigen::RowVectorXf lengths = (contracted - scanned).colwise().norm();
  return {lengths.begin(), lengths.end()};
}

} // namespace espalier
