#include "core/skeleton/shift_onto_cloud.h"

#include "core/base/spatial_index.h"
#include "core/cloud/far_points.h"
#include "core/skeleton/bounds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace espalier {
namespace {

constexpr std::size_t mostMeasured = 1000;
constexpr std::size_t fewestNodes = 4;

/// Nodes against the points of a cloud.
class Distances {
public:
  Distances(const Skeleton& skeleton, const PointCloud& cloud)
      : cloud_(cloud), index_(cloud.positions()), spacing_(pointSpacing(cloud.positions(), index_)),
        extent_(plantBounds(cloud).sizes().norm()) {
    const std::vector<NodeId> ids = skeleton.ids();
    const std::size_t count = std::min(ids.size(), mostMeasured);
    for (std::size_t i = 0; i < count; ++i)
      places_.push_back(skeleton[ids[i * ids.size() / count]].position);
  }

  /// Median distance from a node to the nearest point, once it is moved by `shift` [L].
  /// pre: there are nodes and points
  [[nodiscard]] double median(const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) const {
    std::vector<double> distances;
    for (const Eigen::Vector3d& place : places_) {
      const Eigen::Vector3f local = (place + shift - cloud_.origin()).cast<float>();
      const auto nearest = index_.nearestOne(local)->index;
      distances.push_back((place + shift - cloud_.position(nearest)).norm());
    }
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, middle);
    return *middle;
  }

  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] bool isOnPoints(double distance) const {
    return distance <= std::max(0.02 * extent_, 3 * spacing_);
  }

private:
  const PointCloud& cloud_;
  SpatialIndex index_;
  double spacing_;
  double extent_;
  std::vector<Eigen::Vector3d> places_;
};

/// Of all points but those that lie far off.
Eigen::Vector3d meanOf(const PointCloud& cloud) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(); // about the origin, to keep digits
  const std::vector<Eigen::Index> allFar = farPoints(cloud);
  auto far = allFar.begin();
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    if (far != allFar.end() && *far == i)
      ++far;
    else
      sum += cloud.positions().col(i).cast<double>();
  return cloud.origin() + sum / static_cast<double>(cloud.size() - std::ssize(allFar));
}

bool isOff(const Distances& distances) {
  return !distances.isOnPoints(distances.median());
}

} // namespace

std::optional<Eigen::Vector3d> shiftOntoCloud(const Skeleton& skeleton, const PointCloud& cloud) {
  if (skeleton.size() < fewestNodes || cloud.isEmpty()) return std::nullopt;
  const Distances distances(skeleton, cloud);
  const double before = distances.median();
  if (before <= distances.spacing()) return std::nullopt;
  const Eigen::Vector3d mean = meanOf(cloud);
  const double after = distances.median(mean);
  if (after > before / 3 || !distances.isOnPoints(after)) return std::nullopt;
  return mean;
}

std::optional<Misfit> misfitOf(const Skeleton& skeleton, const PointCloud& cloud) {
  if (skeleton.isEmpty() || cloud.isEmpty()) return std::nullopt;
  constexpr double small = 1.0 / 50;
  constexpr double large = 3;
  const Eigen::AlignedBox3d box = bounds(skeleton);
  const double extent = plantBounds(cloud).sizes().norm();
  if (!(extent > 0)) return std::nullopt;
  const double size = box.sizes().norm() / extent;
  const bool isSmall = size < small && skeleton.size() >= fewestNodes;
  if (isSmall || (size > large && isOff(Distances(skeleton, cloud))))
    return Misfit{.size = size, .isOfOtherSize = true};
  if (!box.intersects(plantBounds(cloud))) return Misfit{.size = size, .isOfOtherSize = false};
  return std::nullopt;
}

} // namespace espalier
