#include "core/cloud/point_cloud.h"

#include "core/base/coordinates.h"
#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/base/spatial_index.h"
#include "core/cloud/far_points.h"
#include "core/cloud/spacing_of_places.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

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

/// Place of a point along Morton's curve through `bounds`, of the nearest place there if it lies
/// outside.
std::uint64_t mortonCode(const Eigen::Vector3d& point, const Eigen::AlignedBox3d& bounds) {
  const double side = std::max(bounds.sizes().maxCoeff(), 1e-300);
  const Eigen::Vector3d scaled =
      (point.cwiseMax(bounds.min()).cwiseMin(bounds.max()) - bounds.min()) / side * 2097151.0;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
    code |= spreadBits(static_cast<std::uint64_t>(scaled[axis])) << axis;
  return code;
}

struct Place {
  std::uint64_t code;
  std::uint32_t index; // in the file
};

/// The bounds of all places but the far ones.
Eigen::AlignedBox3d withoutFar(const Eigen::AlignedBox3d& bounds, const std::vector<Place>& places,
                               const RawPoints& raw) {
  const auto place = [&](Eigen::Index i) -> const Eigen::Vector3d& {
    return raw.positions[places[static_cast<std::size_t>(i)].index];
  };
  const std::vector<Eigen::Index> far = farPoints(std::ssize(places), place, bounds);
  if (far.empty()) return bounds;
  std::vector<bool> isFar(places.size());
  for (const Eigen::Index i : far)
    isFar[static_cast<std::size_t>(i)] = true;
  Eigen::AlignedBox3d plant;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!isFar[i]) plant.extend(place(static_cast<Eigen::Index>(i)));
  return plant;
}

/// Whether each point has a station of the list, where there are several.
bool haveStations(const std::vector<StationIndex>& stationOf, std::size_t points,
                  const std::vector<Station>& stations) {
  if (stations.size() <= 1) return stationOf.empty();
  const auto isListed = [&](StationIndex station) { return station < stations.size(); };
  return stationOf.size() == points && std::ranges::all_of(stationOf, isListed);
}

} // namespace

PointCloud::PointCloud(RawPoints raw, const Progress& progress) {
  Eigen::AlignedBox3d bounds;
  std::vector<Place> places;
  places.reserve(raw.positions.size());
  constexpr std::size_t often = 65536; // points between two looks at the progress
  for (std::size_t i = 0; i < raw.positions.size(); ++i) {
    if (i % often == 0) progress.check();
    if (!isInRange(raw.positions[i])) continue;
    bounds.extend(raw.positions[i]);
    places.push_back({0, static_cast<std::uint32_t>(i)});
  }
  if (places.empty()) return;
  bounds = withoutFar(bounds, places, raw);
  parallelFor(
      static_cast<Eigen::Index>(places.size()),
      [&](Eigen::Index i) {
        Place& place = places[static_cast<std::size_t>(i)];
        place.code = mortonCode(raw.positions[place.index], bounds);
      },
      progress.part(0, 0.3), 4096);
  // Ties are broken by position, so that the order in the file does not decide.
  parallelSort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    progress.check();
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
  if (!raw.stationOf.empty()) stationOf_.resize(count);
  assert(haveStations(raw.stationOf, raw.positions.size(), raw.stations));
  stations_ = std::move(raw.stations);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % often == 0) progress.check();
    const std::uint32_t from = places[i].index;
    positions_.col(static_cast<Eigen::Index>(i)) = (raw.positions[from] - origin_).cast<float>();
    fileOrder_[i] = from;
    if (!colors_.empty()) colors_[i] = raw.colors[from];
    if (!intensities_.empty()) intensities_[i] = raw.intensities[from];
    if (!stationOf_.empty()) stationOf_[i] = raw.stationOf[from];
  }
  progress.update(1);
}

PointCloud::PointCloud(StoredPoints stored) {
  const auto count = static_cast<std::size_t>(stored.positions.cols());
  const auto isNoneOr = [&](std::size_t size) { return size == 0 || size == count; };
  if (stored.fileOrder.size() != count || !isNoneOr(stored.colors.size()) ||
      !isNoneOr(stored.intensities.size()) ||
      !haveStations(stored.stationOf, count, stored.stations))
    throw ShownError({espalier::Shown::tr("stored points are not complete: open the scan again")});
  // About an origin at the other end of all that is in range, a place is twice as far.
  constexpr auto farthest = static_cast<float>(2 * largestCoordinate);
  const bool areInRange = (stored.positions.array().abs() <= farthest).all();
  const bool areStationsInRange = std::ranges::all_of(stored.stations, [](const Station& station) {
    return !station.scanner || isInRange(*station.scanner);
  });
  if (!areInRange || !isInRange(stored.origin) || !areStationsInRange)
    throw ShownError({espalier::Shown::tr(
        "stored points are not all finite, or beyond any plant: open the scan again")});
  positions_ = std::move(stored.positions);
  origin_ = stored.origin;
  colors_ = std::move(stored.colors);
  intensities_ = std::move(stored.intensities);
  fileOrder_ = std::move(stored.fileOrder);
  stations_ = std::move(stored.stations);
  stationOf_ = std::move(stored.stationOf);
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
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (i == 0 || points.col(i) != points.col(i - 1)) places.push_back(i);
  return spacingOfPlaces(points, index, places);
}

} // namespace espalier
