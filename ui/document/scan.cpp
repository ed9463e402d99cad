#include "ui/document/scan.h"

#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/plant_scale.h"

#include <cassert>
#include <utility>

namespace espalier {
namespace {

/// Of the points that are not set aside; `otherwise` if they have none.
PlantSides measured(const PointCloud& cloud, const SpatialIndex& index, const PointSet& leftOut,
                    const PlantSides& otherwise, const Progress& progress = {}) {
  const PlantSides sides = plantSides(cloud, index, leftOut, progress);
  return sides.spacing > 0 ? sides : otherwise;
}

} // namespace

Scan::Scan(PointCloud cloud, const Progress& progress)
    : cloud_(std::make_shared<const PointCloud>(std::move(cloud))),
      index_(cloud_->positions(), progress), sides_(measured(*cloud_, index_, {}, {}, progress)),
      bounds_(plantBounds(*cloud_)) {
  assert(!cloud_->isEmpty());
  progress.check();
  if (!repeatedPoints(*cloud_).isEmpty()) index_ = index_.passingOver(notCounted(*cloud_));
}

Scan::Scan(const Scan& whole, const PointSet& leftOut)
    : cloud_(whole.cloud_), leftOut_(leftOut & PointSet::firstOf(cloud_->size())),
      index_(whole.index_.passingOver(notCounted(*cloud_, leftOut_))),
      sides_(measured(*cloud_, index_, leftOut_, whole.sides_)),
      bounds_(plantBounds(*cloud_, leftOut_)) {
  if (bounds_.isEmpty()) bounds_ = plantBounds(*cloud_); // all is set aside
}

Scan Scan::leavingOut(const PointSet& points) const {
  return {*this, points};
}

Eigen::Vector3d Scan::onPoints(const Eigen::Vector3d& place) const {
  constexpr int neighbors = 5; // as PlantScan3D's "Stick to points"
  const Eigen::Vector3f local = (place - cloud_->origin()).cast<float>();
  const std::vector<Neighbor> nearest = index_.nearest(local, neighbors);
  if (nearest.empty()) return place;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Neighbor& neighbor : nearest)
    sum += cloud_->position(neighbor.index);
  return sum / static_cast<double>(nearest.size());
}

Eigen::Vector3d Scan::onPoints(const Eigen::Vector3d& place, double reach) const {
  const Eigen::Vector3d snapped = onPoints(place);
  return (snapped - place).norm() <= reach ? snapped : place;
}

std::vector<Eigen::Vector3d> Scan::near(const Eigen::Vector3d& place, double radius) const {
  const Eigen::Vector3f local = (place - cloud_->origin()).cast<float>();
  std::vector<Eigen::Vector3d> result;
  for (const Neighbor& neighbor : index_.within(local, static_cast<float>(radius)))
    result.push_back(cloud_->position(neighbor.index));
  return result;
}

std::optional<Eigen::Vector3d> Scan::along(const Eigen::Vector3d& place,
                                           const Eigen::Vector3d& direction,
                                           const ExtendOptions& options) const {
  const auto local =
      extendAlong(index_, cloud_->positions(), place - cloud_->origin(), direction, options);
  if (!local) return std::nullopt;
  return *local + cloud_->origin();
}

SpatialIndex freeIndex(const Scan& scan) {
  return scan.index().passingOver(notCounted(*scan.cloud(), scan.leftOut()));
}

} // namespace espalier
