#include "core/clean/organ_features.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/graph/components.h"
#include "core/graph/geodesic.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {
namespace {

using Level = PointPyramid::Level;

constexpr std::size_t scales = 5;
constexpr std::size_t uprightAt = 3; // scale at which it is looked at
constexpr std::size_t firstOther = 2 * scales;

struct Shape {
  float second = 0;  // standard deviation, by the first, in [0, 1]
  float third = 0;   // likewise
  float upright = 0; // of the direction of the first, in [0, 1]
};

Shape shapeAround(const Level& level, Eigen::Index point) {
  const Eigen::Vector3f place = level.points.col(point);
  Moments moments(place.cast<double>());
  moments.add(place);
  const auto begin = static_cast<std::size_t>(point * level.nearest.perPoint);
  for (std::size_t k = 0; k < static_cast<std::size_t>(level.nearest.perPoint); ++k)
    moments.add(Eigen::Vector3f(level.points.col(level.nearest.indices[begin + k])));
  const auto components = moments.components();
  const Eigen::Vector3d deviations = components.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (!(deviations[2] > 0)) return {};
  return {static_cast<float>(deviations[1] / deviations[2]),
          static_cast<float>(deviations[0] / deviations[2]),
          static_cast<float>(std::abs(components.eigenvectors()(2, 2)))};
}

std::vector<Shape> shapesOf(const Level& level, const Progress& progress) {
  std::vector<Shape> shapes(static_cast<std::size_t>(level.points.cols()));
  parallelFor(
      level.points.cols(),
      [&](Eigen::Index i) { shapes[static_cast<std::size_t>(i)] = shapeAround(level, i); },
      progress);
  return shapes;
}

constexpr std::array goesOn = {8.0F, 30.0F}; // [spacings] paths that lead on are longer

/// What shortest paths from the root lead on to behind the points of a level.
struct Behind {
  std::vector<float> points; // whose paths lead through the point, itself among them
  std::vector<float> length; // of the longest such path from the point on [L]
  std::array<std::vector<float>, goesOn.size()> off; // [L] along the path back to one that goes on
};

/// The root, and of each part that is not linked with it the point nearest to it.
std::vector<Eigen::Index> sourcesIn(const Level& level, const NeighborhoodGraph& graph,
                                    Eigen::Index root) {
  const Components parts = connectedComponents(graph);
  std::vector<Eigen::Index> sources(parts.sizes.size(), -1);
  const Eigen::VectorXf away =
      (level.points.colwise() - Eigen::Vector3f(level.points.col(root))).colwise().squaredNorm();
  for (Eigen::Index i = 0; i < away.size(); ++i) {
    Eigen::Index& source = sources[parts.ofPoint[static_cast<std::size_t>(i)]];
    if (source < 0 || away[i] < away[source]) source = i;
  }
  return sources;
}

Behind behindOf(const Level& level, Eigen::Index root, float spacing, const Progress& progress) {
  constexpr int links = 10;
  const NeighborhoodGraph graph(level.points, links, progress.part(0, 0.5));
  const Geodesics paths =
      geodesics(graph, sourcesIn(level, graph, root), 1, progress.part(0.5, 0.9));
  const std::size_t count = paths.distance.size();
  std::vector<std::uint32_t> farthestFirst(count);
  std::iota(farthestFirst.begin(), farthestFirst.end(), 0U);
  parallelSort(farthestFirst.begin(), farthestFirst.end(), [&](std::uint32_t a, std::uint32_t b) {
    return paths.distance[a] != paths.distance[b] ? paths.distance[a] > paths.distance[b] : a < b;
  });
  progress.check();
  Behind behind{std::vector<float>(count, 1), std::vector<float>(count, 0)};
  for (const std::uint32_t point : farthestFirst) {
    const std::uint32_t before = paths.predecessor[point];
    if (before == Geodesics::none) continue;
    behind.points[before] += behind.points[point];
    behind.length[before] =
        std::max(behind.length[before],
                 behind.length[point] + paths.distance[point] - paths.distance[before]);
  }
  for (std::size_t k = 0; k < goesOn.size(); ++k) {
    std::vector<float>& off = behind.off[k];
    off.assign(count, 0);
    for (std::size_t i = count; i-- > 0;) { // nearest first
      const std::uint32_t point = farthestFirst[i];
      const std::uint32_t before = paths.predecessor[point];
      if (before == Geodesics::none || behind.length[point] >= goesOn[k] * spacing) continue;
      off[point] = off[before] + paths.distance[point] - paths.distance[before];
    }
  }
  return behind;
}

/// The most of the points around each: paths run along some of the points of a branch only.
std::vector<float> mostAround(const Level& level, const std::vector<float>& values) {
  std::vector<float> most(values);
  parallelFor(level.points.cols(), [&](Eigen::Index i) {
    const auto point = static_cast<std::size_t>(i);
    const auto each = static_cast<std::size_t>(level.nearest.perPoint);
    for (std::size_t k = point * each; k < (point + 1) * each; ++k)
      most[point] = std::max(most[point], values[level.nearest.indices[k]]);
  });
  return most;
}

/// Sets the features of each point from a level: set(features, the point of the level for it).
template <class Set>
void setFrom(std::vector<OrganFeatures>& features, const std::vector<std::uint32_t>& inLevel,
             const Set& set) {
  parallelFor(std::ssize(features), [&](Eigen::Index i) {
    set(features[static_cast<std::size_t>(i)], inLevel[static_cast<std::size_t>(i)]);
  });
}

void setShapes(std::vector<OrganFeatures>& features, const PointPyramid& pyramid,
               const Progress& progress) {
  std::vector<std::uint32_t> inLevel(features.size());
  std::iota(inLevel.begin(), inLevel.end(), 0U);
  std::vector<Shape> shapes;
  for (std::size_t scale = 0; scale < scales; ++scale) {
    if (scale < pyramid.levels().size()) {
      if (scale > 0)
        for (std::uint32_t& point : inLevel)
          point = pyramid.levels()[scale - 1].above[point];
      shapes = shapesOf(pyramid.levels()[scale], progress);
    }
    setFrom(features, inLevel, [&](OrganFeatures& its, std::uint32_t point) {
      its[2 * scale] = shapes[point].second;
      its[2 * scale + 1] = shapes[point].third;
      if (scale == uprightAt) its[firstOther] = shapes[point].upright;
    });
  }
}

/// How far the neighbors of a point lie, in spacings, by its logarithm.
void setReach(std::vector<OrganFeatures>& features, const Level& level, double spacing) {
  const auto each = static_cast<std::size_t>(level.nearest.perPoint);
  parallelFor(std::ssize(features), [&](Eigen::Index i) {
    const auto point = static_cast<std::size_t>(i);
    const double reach = each == 0 ? 0
                                   : std::sqrt(static_cast<double>(
                                         level.nearest.squaredDistances[(point + 1) * each - 1]));
    features[point][firstOther + 1] = static_cast<float>(std::log(reach / spacing + 0.1));
  });
}

void setBehind(std::vector<OrganFeatures>& features, const PointPyramid& pyramid, Eigen::Index root,
               double spacing, const Progress& progress) {
  const bool isThin = pyramid.levels().size() > 1;
  const Level& level = pyramid.levels()[isThin ? 1 : 0];
  std::vector<std::uint32_t> inLevel(features.size());
  std::iota(inLevel.begin(), inLevel.end(), 0U);
  if (isThin) inLevel = pyramid.levels()[0].above;
  const auto unit = static_cast<float>(spacing);
  const Behind behind = behindOf(level, inLevel[static_cast<std::size_t>(root)], unit, progress);
  const std::vector<float> most = mostAround(level, behind.points);
  const std::vector<float> wide = mostAround(level, most);
  const std::vector<float> longest = mostAround(level, behind.length);
  const float height = level.points.row(2).maxCoeff() - level.points.row(2).minCoeff();
  const auto all = static_cast<float>(level.points.cols());
  setFrom(features, inLevel, [&](OrganFeatures& its, std::uint32_t point) {
    its[firstOther + 2] = std::log(most[point]);
    its[firstOther + 3] = std::log(wide[point] / all);
    its[firstOther + 4] = std::log(longest[point] / unit + 1);
    its[firstOther + 5] = std::log(longest[point] / (height + unit) + 0.003F);
    for (std::size_t k = 0; k < goesOn.size(); ++k)
      its[firstOther + 6 + k] = std::log(behind.off[k][point] / unit + 1);
  });
}

/// By point of a level: the mean of the points below that it stands for; it is one of them.
Shares handedUp(const Shares& shares, const std::vector<std::uint32_t>& above, const Level& level) {
  std::vector<double> sums(static_cast<std::size_t>(level.points.cols()), 0);
  std::vector<int> counts(sums.size(), 0);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    sums[above[i]] += static_cast<double>(shares[i]);
    ++counts[above[i]];
  }
  Shares means(sums.size(), 0);
  for (std::size_t i = 0; i < means.size(); ++i)
    if (counts[i] > 0) means[i] = static_cast<float>(sums[i] / counts[i]);
  return means;
}

Shares meanAround(const Level& level, const Shares& shares) {
  Shares means(shares);
  const auto each = static_cast<std::size_t>(level.nearest.perPoint);
  parallelFor(level.points.cols(), [&](Eigen::Index i) {
    const auto point = static_cast<std::size_t>(i);
    for (std::size_t k = point * each; k < (point + 1) * each; ++k)
      means[point] += shares[level.nearest.indices[k]];
    means[point] /= static_cast<float>(each + 1);
  });
  return means;
}

} // namespace

PointPyramid organPyramid(const Eigen::Matrix3Xf& points, const Progress& progress) {
  constexpr int neighbors = 16;
  return {points, neighbors, scales, progress};
}

std::vector<OrganFeatures> organFeatures(const PointPyramid& pyramid, Eigen::Index root,
                                         double spacing, const Progress& progress) {
  std::vector<OrganFeatures> features(
      static_cast<std::size_t>(pyramid.levels().front().points.cols()));
  setShapes(features, pyramid, progress.part(0, 0.5));
  setReach(features, pyramid.levels().front(), spacing);
  setBehind(features, pyramid, root, spacing, progress.part(0.5, 1));
  for (const std::size_t scale : {0, 1}) {
    Shares thirds(features.size());
    for (std::size_t i = 0; i < thirds.size(); ++i)
      thirds[i] = features[i][2 * scale + 1];
    const Shares around = sharesAround(pyramid, thirds)[scale];
    for (std::size_t i = 0; i < thirds.size(); ++i)
      features[i][firstOther + 6 + goesOn.size() + scale] = around[i];
  }
  return features;
}

std::array<Shares, 3> sharesAround(const PointPyramid& pyramid, const Shares& shares) {
  std::array<Shares, 3> around;
  Shares ofLevel = shares;
  std::vector<std::uint32_t> inLevel(shares.size());
  std::iota(inLevel.begin(), inLevel.end(), 0U);
  for (std::size_t scale = 0; scale < around.size(); ++scale) {
    if (scale + 1 < pyramid.levels().size()) {
      const std::vector<std::uint32_t>& above = pyramid.levels()[scale].above;
      const Level& level = pyramid.levels()[scale + 1];
      ofLevel = meanAround(level, handedUp(ofLevel, above, level));
      for (std::uint32_t& point : inLevel)
        point = above[point];
    }
    around[scale].resize(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i)
      around[scale][i] = ofLevel[inLevel[i]];
  }
  return around;
}

} // namespace espalier
