#include "core/pipeline/plant_scale.h"

#include "core/cloud/far_points.h"
#include "core/cloud/isolated_points.h"
#include "core/cloud/repeated_points.h"
#include "core/cloud/spacing_of_places.h"
#include "core/cloud/thin_wood.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// Points of a cloud and how far apart they lie.
struct Places {
  const Progress& progress; // of what is measured
  const Eigen::Matrix3Xf& positions;
  const SpatialIndex& index; // finds these places alone, and far points
  std::vector<Eigen::Index> points;
  double spacing; // [L]
  ThinWood wood;

  [[nodiscard]] float height(Eigen::Index point, UpAxis up) const {
    return positions(static_cast<Eigen::Index>(up), point);
  }

  /// The lowest that does not stand alone, of heights times `sign`; the lowest if many do.
  [[nodiscard]] float lowest(UpAxis up, float sign) const {
    const auto isHigher = [&](Eigen::Index a, Eigen::Index b) {
      progress.check();
      return sign * height(a, up) > sign * height(b, up);
    };
    const std::size_t most = (points.size() + 15) / 16; // that are looked at
    std::vector<Eigen::Index> heap = someLowest(up, sign);
    const Eigen::Index first = *std::ranges::max_element(heap, isHigher);
    if (!isIsolated(first)) return height(first, up);
    for (const bool areAll : {false, true}) {
      if (areAll) heap = points;
      const std::size_t known = heap.size();
      std::ranges::make_heap(heap, isHigher);
      while (!heap.empty() && known - heap.size() < most) {
        const Eigen::Index next = heap.front();
        if (!isIsolated(next)) return height(next, up);
        std::ranges::pop_heap(heap, isHigher);
        heap.pop_back();
      }
      if (known >= most) break;
    }
    return height(first, up);
  }

  /// The lowest of all, about 1 of 256, likewise: all up to some height.
  [[nodiscard]] std::vector<Eigen::Index> someLowest(UpAxis up, float sign) const {
    constexpr std::size_t sampled = 4096;
    const std::size_t step = points.size() / sampled + 1;
    std::vector<float> heights;
    for (std::size_t i = 0; i < points.size(); i += step)
      heights.push_back(sign * height(points[i], up));
    const auto border = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 256);
    std::ranges::nth_element(heights, border);
    std::vector<Eigen::Index> some;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % sampled == 0) progress.check();
      if (sign * height(points[i], up) <= *border) some.push_back(points[i]);
    }
    return some;
  }

  [[nodiscard]] bool isIsolated(Eigen::Index point) const {
    return espalier::isIsolated(index, positions.col(point),
                                {.distance = IsolatedPointOptions::usualDistance * spacing});
  }
};

/// Those that count: without what is set aside, repeated or far. Calls measure(places).
template <class Measure>
auto onPlaces(const PointCloud& cloud, const SpatialIndex& index, const PointSet& leftOut,
              const Progress& progress, const Measure& measure) {
  std::vector<bool> isPassed = notCounted(cloud, leftOut);
  progress.check();
  std::vector<bool> isWithout = isPassed;
  for (const Eigen::Index far : farPoints(cloud, isPassed))
    isWithout[static_cast<std::size_t>(far)] = true;
  progress.check();
  std::vector<Eigen::Index> points;
  points.reserve(isWithout.size());
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    if (!isWithout[static_cast<std::size_t>(i)]) points.push_back(i);
  const Eigen::Matrix3Xf& positions = cloud.positions();
  const auto measured = [&](const SpatialIndex& found) {
    Places places{progress, positions, found, std::move(points), 0, {}};
    progress.check();
    places.spacing = spacingOfPlaces(positions, found, places.points);
    progress.check();
    places.wood = thinWood(positions, found, places.points, places.spacing);
    return measure(places);
  };
  const bool areAll = std::ranges::find(isPassed, true) == isPassed.end();
  return areAll ? measured(index) : measured(index.passingOver(std::move(isPassed)));
}

PlantExtent extentOf(const Places& places, UpAxis up) {
  if (places.points.empty()) return {};
  const float lowest = places.lowest(up, 1);
  const float highest = places.lowest(up, -1);
  return {.scale = {.spacing = places.spacing,
                    .height = static_cast<double>(highest) - static_cast<double>(lowest),
                    .thickness = places.wood.thickness,
                    .scatter = places.wood.scatter},
          .lowest = lowest};
}

} // namespace

PlantExtent plantExtent(const PointCloud& cloud, const SpatialIndex& index, const PointSet& leftOut,
                        UpAxis up) {
  return onPlaces(cloud, index, leftOut, {},
                  [up](const Places& places) { return extentOf(places, up); });
}

PlantSides plantSides(const PointCloud& cloud, const SpatialIndex& index, const PointSet& leftOut,
                      const Progress& progress) {
  return onPlaces(cloud, index, leftOut, progress, [](const Places& places) {
    PlantSides sides{.spacing = places.spacing, .wood = places.wood};
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z})
      sides.heights[static_cast<Eigen::Index>(up)] = extentOf(places, up).scale.height;
    return sides;
  });
}

PlantScale scaleOf(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                   const Progress& progress) {
  return plantExtent(cloud, SpatialIndex(cloud.positions(), progress), leftOut, up).scale;
}

Eigen::Index footAmong(const std::vector<Eigen::Index>& points, const PointCloud& cloud,
                       const PointSet& leftOut, UpAxis up, float lowest) {
  const std::vector<Eigen::Index> far = farPoints(cloud, leftOut);
  const auto isOff = [&](Eigen::Index point) {
    return cloud.positions()(static_cast<Eigen::Index>(up), point) < lowest ||
           std::ranges::binary_search(far, point);
  };
  std::vector<Eigen::Index> standing = points;
  std::erase_if(standing, isOff);
  if (standing.empty()) standing = points;
  const Eigen::Matrix3Xf places = cloud.positions()(Eigen::all, standing);
  return standing[static_cast<std::size_t>(findRoot(places, up))];
}

} // namespace espalier
