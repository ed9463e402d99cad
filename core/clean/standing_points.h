#pragma once

#include "core/base/rule.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"
#include "core/graph/find_root.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A length by a rule, for a plant of this scale.
[[nodiscard]] inline Length lengthAt(const Length& length, const PlantScale& scale) {
  return {length.rule().value(scale)};
}

/// Points of a cloud as cleaning looks at them: upright, whatever axis of the file is up.
struct StandingPoints {
  std::vector<Eigen::Index> columns;                  // of the cloud, ascending
  Eigen::Matrix3Xf positions;                         // of these, z up, about its origin [L]
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); // from the file to these
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   // of the cloud [L], frame of the file
  [[nodiscard]] Eigen::Vector3d fromFile(const Eigen::Vector3d& place) const {
    return turn * (place - origin);
  }
  [[nodiscard]] Eigen::Vector3d toFile(const Eigen::Vector3d& place) const {
    return turn.transpose() * place + origin;
  }
  /// Columns of the cloud for places in `columns`, ascending.
  [[nodiscard]] PointSet inCloud(const std::vector<Eigen::Index>& places) const;
};

/// Those that are not left out. O(N).
[[nodiscard]] StandingPoints standingPoints(const PointCloud& cloud,
                                            std::vector<Eigen::Index> columns, UpAxis up);
[[nodiscard]] StandingPoints standingPoints(const PointCloud& cloud, const PointSet& leftOut,
                                            UpAxis up);

} // namespace espalier
