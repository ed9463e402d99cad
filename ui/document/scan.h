#pragma once

#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/extend_along.h"

#include <memory>
#include <vector>

namespace espalier {

/// The points of a document and what finds them. Never changes.
///
/// The points set aside are in its cloud, but nothing finds them; of a place, one point is found.
class Scan {
public:
  /// Time O(N log N): made by the job that reads the file. pre: not empty
  /// @throws Cancelled if `progress` asks to stop
  explicit Scan(PointCloud cloud, const Progress& progress = {});

  /// The same scan with exactly these points set aside. O(N): the cloud is shared.
  [[nodiscard]] Scan leavingOut(const PointSet& points) const;

  [[nodiscard]] const std::shared_ptr<const PointCloud>& cloud() const { return cloud_; }
  [[nodiscard]] const PointSet& leftOut() const { return leftOut_; }
  /// Of the positions of cloud(); passes over the points set aside.
  [[nodiscard]] const SpatialIndex& index() const { return index_; }
  [[nodiscard]] double height(UpAxis up) const { // along this axis, of those found [L]
    return sides_.heights[static_cast<Eigen::Index>(up)];
  }
  [[nodiscard]] double spacing() const { return sides_.spacing; }    // likewise (plant_scale.h) [L]
  [[nodiscard]] const ThinWood& wood() const { return sides_.wood; } // likewise
  /// Of those found but the few far ones (plantBounds) [L], frame of the file; of all if all are
  /// set aside.
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  /// Centroid of the 5 points nearest to `place` [L]: one point alone is noise of the scanner.
  /// `place` itself if all points are set aside.
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
  Scan(const Scan& whole, const PointSet& leftOut);

  std::shared_ptr<const PointCloud> cloud_;
  PointSet leftOut_;
  SpatialIndex index_;
  PlantSides sides_;
  Eigen::AlignedBox3d bounds_;
};

/// The index of a scan for a job, which may outlive the scan. Time O(N).
[[nodiscard]] SpatialIndex freeIndex(const Scan& scan);

} // namespace espalier
