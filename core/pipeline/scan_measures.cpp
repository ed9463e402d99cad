#include "core/pipeline/scan_measures.h"

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/clean/organs.h"
#include "core/clean/standing_points.h"
#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"
#include "core/cloud/spacing_of_places.h"
#include "core/cloud/thin_wood.h"
#include "core/cloud/wood_around.h"
#include "core/graph/scan_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace espalier {
namespace {

constexpr Eigen::Index mostClassified = 40'000; // or a fourth of all, if that is more
constexpr Eigen::Index mostNearest = 8000;      // whose nearest others are looked for
constexpr Eigen::Index mostLookedAt = 800;
constexpr std::size_t slabCount = 5;
constexpr double leastMeasured = 0.2; // of the places: fewer lie along lines by chance

/// What is known of one of the points that stand for all.
struct LookedAt {
  float height = 0;   // [L], about the origin of the cloud
  double nearest = 0; // distance to the nearest other place [L]
  bool isFoliage = false;
  std::optional<WoodAround> wood; // none: not looked for
};

std::optional<Spread> spreadOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return Spread{*quantile(values, 0.1), *quantile(values, 0.5), *quantile(values, 0.9)};
}

/// Every so many of `count`, at most `most` of them.
std::vector<Eigen::Index> evenly(Eigen::Index count, Eigen::Index most) {
  const Eigen::Index taken = std::min(count, most);
  std::vector<Eigen::Index> places(static_cast<std::size_t>(taken));
  for (Eigen::Index i = 0; i < taken; ++i)
    places[static_cast<std::size_t>(i)] = i * count / taken;
  return places;
}

/// The measures of places between two heights.
WoodMeasures measuresOf(const std::vector<LookedAt>& places, const std::vector<ScanGap>& gaps,
                        float from, float to) {
  WoodMeasures measures;
  std::vector<double> nearest;
  std::vector<double> scatters;
  std::vector<double> thicknesses;
  std::vector<double> arcs;
  std::size_t seen = 0;
  std::size_t looked = 0;
  std::size_t leaves = 0;
  for (const LookedAt& place : places) {
    if (place.height < from || place.height > to) continue;
    ++seen;
    leaves += place.isFoliage;
    if (place.nearest > 0) nearest.push_back(place.nearest);
    if (!place.wood) continue;
    ++looked;
    if (place.wood->thickness) thicknesses.push_back(*place.wood->thickness);
    if (place.wood->scatter) scatters.push_back(*place.wood->scatter);
    if (place.wood->arc) arcs.push_back(*place.wood->arc);
  }
  measures.spacing = spreadOf(nearest);
  measures.scatter = quantile(scatters, 0.5);
  measures.arc = quantile(arcs, 0.5);
  if (looked > 0)
    measures.measured = static_cast<double>(thicknesses.size()) / static_cast<double>(looked);
  if (measures.measured >= leastMeasured) measures.thickness = spreadOf(thicknesses);
  if (seen > 0) measures.foliage = static_cast<double>(leaves) / static_cast<double>(seen);
  for (const ScanGap& gap : gaps)
    if (gap.middle.z() >= from && gap.middle.z() <= to) measures.gaps.push_back(gap.width);
  return measures;
}

/// The points that stand for all, and what they lie on.
std::vector<LookedAt> classified(const Eigen::Matrix3Xf& points,
                                 const std::vector<Eigen::Index>& places,
                                 const Progress& progress) {
  const Eigen::Matrix3Xf some = points(Eigen::all, places);
  const double spacing = pointSpacing(some, progress);
  const std::vector<Organ> organs = organsAmong(some, std::nullopt, spacing, progress).ofPoint;
  std::vector<LookedAt> found(places.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].height = some(2, static_cast<Eigen::Index>(i));
    found[i].isFoliage = organs[i] == Organ::blade || organs[i] == Organ::needle;
  }
  return found;
}

void lookAround(std::vector<LookedAt>& found, const Eigen::Matrix3Xf& points,
                const SpatialIndex& index, const std::vector<Eigen::Index>& places, double spacing,
                double thinThickness, const Progress& progress) {
  const std::vector<Eigen::Index> some = evenly(std::ssize(found), mostNearest);
  parallelFor(std::ssize(some), [&](Eigen::Index i) {
    const auto at = static_cast<std::size_t>(some[static_cast<std::size_t>(i)]);
    const auto nearest = index.nearest(points.col(places[at]), 2);
    if (nearest.size() > 1)
      found[at].nearest = std::sqrt(static_cast<double>(nearest[1].squaredDistance));
  });
  std::vector<std::size_t> wood;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!found[i].isFoliage) wood.push_back(i);
  const std::vector<Eigen::Index> looked = evenly(std::ssize(wood), mostLookedAt);
  // As thinWood() has it: in larger balls, bends and branches count as scatter, too.
  const WoodLook scatterLook = {.farthest = thinThickness / spacing < 4 ? 8.0 : 32.0,
                                .confirms = false};
  constexpr Eigen::Index grain = 4;
  parallelFor(
      std::ssize(looked),
      [&](Eigen::Index i) {
        const std::size_t at = wood[static_cast<std::size_t>(looked[static_cast<std::size_t>(i)])];
        found[at].wood = woodAround(points, index, places[at], spacing);
        found[at].wood->scatter =
            woodAround(points, index, places[at], spacing, scatterLook).scatter;
      },
      progress, grain);
}

} // namespace

ScanMeasures scanMeasures(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                          const Progress& progress) {
  ScanMeasures measures;
  PointSet without = leftOut | repeatedPoints(cloud, leftOut);
  without = without | PointSet::of(farPoints(cloud, leftOut, progress));
  const StandingPoints standing = standingPoints(cloud, without, up);
  const Eigen::Matrix3Xf& points = standing.positions;
  measures.whole.points = points.cols();
  if (points.cols() < 2) return measures;
  const SpatialIndex index(points, progress);
  progress.update(0.1);
  const std::vector<Eigen::Index> all = evenly(points.cols(), points.cols());
  measures.spacing = spacingOfPlaces(points, index, all);
  progress.update(0.15);
  const std::vector<Eigen::Index> places =
      evenly(points.cols(), std::max(mostClassified, points.cols() / 4));
  std::vector<LookedAt> found = classified(points, places, progress.part(0.15, 0.5));
  const ThinWood thin = thinWood(points, index, all, measures.spacing);
  lookAround(found, points, index, places, measures.spacing, thin.thickness,
             progress.part(0.5, 0.8));
  const std::vector<ScanGap> gaps = scanGaps(points, measures.spacing, progress.part(0.8, 1));
  const float lowest = points.row(2).minCoeff();
  const float highest = points.row(2).maxCoeff();
  measures.whole = measuresOf(found, gaps, lowest, highest);
  measures.whole.points = points.cols();
  if (measures.whole.scatter) measures.whole.scatter = thin.scatter;
  if (!(highest > lowest)) return measures;
  for (std::size_t i = 0; i < slabCount; ++i) {
    const auto at = [&](std::size_t side) {
      return side == slabCount ? highest
                               : lowest + (highest - lowest) * static_cast<float>(side) /
                                              static_cast<float>(slabCount);
    };
    // A place on the border of two slabs is of the upper one.
    const float to = i + 1 == slabCount ? highest : std::nextafter(at(i + 1), lowest);
    MeasuredSlab slab{.measures = measuresOf(found, gaps, at(i), to)};
    slab.measures.points = (points.row(2).array() >= at(i) && points.row(2).array() <= to).count();
    const auto axis = static_cast<Eigen::Index>(up);
    slab.from = cloud.origin()[axis] + static_cast<double>(at(i));
    slab.to = cloud.origin()[axis] + static_cast<double>(at(i + 1));
    measures.slabs.push_back(std::move(slab));
  }
  return measures;
}

} // namespace espalier
