#include "ui/document/scan.h"

#include <cassert>
#include <utility>

namespace espalier {
namespace {

std::vector<bool> maskOf(const PointSet& points, Eigen::Index count) {
  std::vector<bool> mask(static_cast<std::size_t>(count), false);
  for (const Eigen::Index point : points.points())
    mask[static_cast<std::size_t>(point)] = true;
  return mask;
}

} // namespace

Scan::Scan(PointCloud cloud)
    : cloud_(std::make_shared<const PointCloud>(std::move(cloud))), index_(cloud_->positions()),
      height_(cloud_->bounds().sizes().z()), spacing_(pointSpacing(cloud_->positions())) {
  assert(!cloud_->isEmpty());
}

Scan::Scan(const Scan& whole, const PointSet& leftOut)
    : cloud_(whole.cloud_), leftOut_(leftOut & PointSet::firstOf(cloud_->size())),
      index_(whole.index_.passingOver(maskOf(leftOut_, cloud_->size()))), height_(whole.height_),
      spacing_(whole.spacing_) {}

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

} // namespace espalier
