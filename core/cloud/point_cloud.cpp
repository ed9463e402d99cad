#include "core/cloud/point_cloud.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Spreads the low 21 bits of `value` so that two zero bits follow each.
std::uint64_t spreadBits(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x1f00000000ffff;
  value = (value | value << 16) & 0x1f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  value = (value | value << 2) & 0x1249249249249249;
  return value;
}

/// Place of a point along Morton's curve through `bounds`.
std::uint64_t mortonCode(const Eigen::Vector3d& point, const Eigen::AlignedBox3d& bounds) {
  const double side = std::max(bounds.sizes().maxCoeff(), 1e-300);
  const Eigen::Vector3d scaled = (point - bounds.min()) / side * 2097151.0; // 2^21 - 1
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
    code |= spreadBits(static_cast<std::uint64_t>(scaled[axis])) << axis;
  return code;
}

/// Damaged files hold numbers whose squares, or whose floats, are infinite.
bool isUsable(const Eigen::Vector3d& position) {
  return (position.array().abs() <= PointCloud::largestCoordinate).all(); // not so for NaN
}

struct Place {
  std::uint64_t code;
  std::uint32_t index; // in the file
};

} // namespace

PointCloud::PointCloud(RawPoints raw, const Progress& progress) {
  Eigen::AlignedBox3d bounds;
  std::vector<Place> places;
  places.reserve(raw.positions.size());
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    if (!isUsable(raw.positions[i])) continue;
    bounds.extend(raw.positions[i]);
    places.push_back({0, static_cast<std::uint32_t>(i)});
  }
  if (places.empty()) return;
  parallelFor(
      static_cast<Eigen::Index>(places.size()),
      [&](Eigen::Index i) {
        Place& place = places[static_cast<std::size_t>(i)];
        place.code = mortonCode(raw.positions[place.index], bounds);
      },
      progress.part(0, 0.3), 4096);
  // Ties are broken by position, so that the order in the file does not decide.
  parallelSort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    if (a.code != b.code) return a.code < b.code;
    const Eigen::Vector3d& p = raw.positions[a.index];
    const Eigen::Vector3d& q = raw.positions[b.index];
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] != q[axis]) return p[axis] < q[axis];
    return a.index < b.index;
  });
  progress.update(0.8);

  origin_ = bounds.center().array().round();
  const std::size_t count = places.size();
  positions_.resize(3, static_cast<Eigen::Index>(count));
  fileOrder_.resize(count);
  if (!raw.colors.empty()) colors_.resize(count);
  if (!raw.intensities.empty()) intensities_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t from = places[i].index;
    positions_.col(static_cast<Eigen::Index>(i)) = (raw.positions[from] - origin_).cast<float>();
    fileOrder_[i] = from;
    if (!colors_.empty()) colors_[i] = raw.colors[from];
    if (!intensities_.empty()) intensities_[i] = raw.intensities[from];
  }
  progress.update(1);
}

PointCloud::PointCloud(StoredPoints stored) {
  const auto count = static_cast<std::size_t>(stored.positions.cols());
  const auto isNoneOr = [&](std::size_t size) { return size == 0 || size == count; };
  if (stored.fileOrder.size() != count || !isNoneOr(stored.colors.size()) ||
      !isNoneOr(stored.intensities.size()))
    throw Error("stored points are not complete: open the scan again");
  if (!stored.positions.allFinite() || !isUsable(stored.origin))
    throw Error("stored points are not all finite: open the scan again");
  positions_ = std::move(stored.positions);
  origin_ = stored.origin;
  colors_ = std::move(stored.colors);
  intensities_ = std::move(stored.intensities);
  fileOrder_ = std::move(stored.fileOrder);
}

Eigen::AlignedBox3d PointCloud::bounds() const {
  if (isEmpty()) return {};
  return {positions_.rowwise().minCoeff().cast<double>() + origin_,
          positions_.rowwise().maxCoeff().cast<double>() + origin_};
}

double pointSpacing(const Eigen::Matrix3Xf& points, const Progress& progress) {
  return pointSpacing(points, SpatialIndex(points, progress));
}

double pointSpacing(const Eigen::Matrix3Xf& points, const SpatialIndex& index) {
  constexpr Eigen::Index samples = 20000;
  const Eigen::Index count = std::min(points.cols(), samples);
  std::vector<double> distances(static_cast<std::size_t>(count));
  parallelFor(count, [&](Eigen::Index i) {
    const Eigen::Index point = i * points.cols() / count;
    double& distance = distances[static_cast<std::size_t>(i)];
    for (const Neighbor& neighbor : index.nearest(points.col(point), 8))
      if (neighbor.squaredDistance > 0) {
        distance = std::sqrt(static_cast<double>(neighbor.squaredDistance));
        break;
      }
  });
  double sum = 0;
  Eigen::Index apart = 0;
  for (const double distance : distances) {
    sum += distance;
    if (distance > 0) ++apart;
  }
  return apart > 0 ? sum / static_cast<double>(apart) : 0;
}

} // namespace espalier
