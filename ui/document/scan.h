#pragma once

#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"
#include "core/skeleton/extend_along.h"

#include <memory>
#include <vector>

namespace espalier {

/// The points of a document and what finds them. Never changes.
class Scan {
public:
  /// Time O(N log N): made by the job that reads the file. pre: not empty
  explicit Scan(PointCloud cloud);

  [[nodiscard]] const std::shared_ptr<const PointCloud>& cloud() const { return cloud_; }
  [[nodiscard]] const SpatialIndex& index() const { return index_; } // of the positions of cloud()
  [[nodiscard]] double height() const { return height_; }            // extent along z [L]
  [[nodiscard]] double spacing() const { return spacing_; } // between neighboring points [L]

  /// Centroid of the 5 points nearest to `place` [L]: one point alone is noise of the scanner.
  [[nodiscard]] Eigen::Vector3d onPoints(const Eigen::Vector3d& place) const;

  /// The same, or `place` itself if that would move it farther than `reach` [L].
  [[nodiscard]] Eigen::Vector3d onPoints(const Eigen::Vector3d& place, double reach) const;

  /// The points within `radius` [L] of `place` [L].
  [[nodiscard]] std::vector<Eigen::Vector3d> near(const Eigen::Vector3d& place,
                                                  double radius) const;

  /// Where a branch leads from a place, along the points (core/skeleton/extend_along.h).
  [[nodiscard]] std::optional<Eigen::Vector3d> along(const Eigen::Vector3d& place,
                                                     const Eigen::Vector3d& direction,
                                                     const ExtendOptions& options) const;

private:
  std::shared_ptr<const PointCloud> cloud_;
  SpatialIndex index_;
  double height_;
  double spacing_;
};

} // namespace espalier
