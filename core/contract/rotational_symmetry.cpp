#include "core/contract/rotational_symmetry.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/contract/section_grower.h"
#include "core/graph/neighborhoods.h"
#include "core/graph/normals.h"

#include <Eigen/Dense>
#include <oneapi/tbb/enumerable_thread_specific.h>

#include <optional>
#include <span>
#include <vector>

namespace espalier {
namespace {

using Members = std::vector<std::uint32_t>;

/// The direction that these normals keep the same angle to.
Eigen::Vector3f axisOf(const Eigen::Matrix3Xf& normals, std::span<const std::uint32_t> members) {
  Moments moments;
  for (const std::uint32_t point : members)
    moments.add(Eigen::Vector3f(normals.col(point)));
  return moments.components().eigenvectors().col(0).cast<float>();
}

/// The place that the lines through the members along their normals pass nearest to; none if they
/// do not meet: are parallel, pass it farther off than half of its distance to the members, or it
/// is farther than three reaches away.
std::optional<Eigen::Vector3d> meetingPlace(const Eigen::Matrix3Xf& points,
                                            const Eigen::Matrix3Xf& normals, const Members& members,
                                            double reach) {
  constexpr double leastSpread = 0.05; // of the directions of lines
  constexpr double largestMiss = 0.5;
  const Eigen::Vector3d about = points.col(members.front()).cast<double>();
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  const auto acrossLine = [&](std::uint32_t point) {
    const Eigen::Vector3d normal = normals.col(point).cast<double>();
    return Eigen::Matrix3d(Eigen::Matrix3d::Identity() - normal * normal.transpose());
  };
  for (const std::uint32_t point : members) {
    const Eigen::Matrix3d one = acrossLine(point);
    across += one;
    target += one * (points.col(point).cast<double>() - about);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(across);
  const auto count = static_cast<double>(members.size());
  if (solver.eigenvalues()[0] < leastSpread * count) return std::nullopt;
  const Eigen::Vector3d place =
      solver.eigenvectors() *
      (solver.eigenvectors().transpose() * target).cwiseQuotient(solver.eigenvalues());
  double missed = 0;
  double away = 0;
  for (const std::uint32_t point : members) {
    const Eigen::Vector3d d = place - (points.col(point).cast<double>() - about);
    missed += (acrossLine(point) * d).squaredNorm();
    away += d.squaredNorm();
  }
  if (place.norm() > 3 * reach || missed > largestMiss * largestMiss * away) return std::nullopt;
  return about + place;
}

/// Sections of all points, and what follows from them.
class SymmetrySearch {
public:
  SymmetrySearch(const Eigen::Matrix3Xf& points, const NeighborhoodGraph& graph,
                 const Eigen::Matrix3Xf& normals, const RotationalSymmetryOptions& options)
      : points_(points), graph_(graph), normals_(normals), options_(options),
        growers_([&] { return SectionGrower(points, graph); }) {}

  /// Axes of the neighborhoods that normals were taken from: a start.
  [[nodiscard]] Eigen::Matrix3Xf firstAxes(const Neighborhoods& near, const Progress& progress) {
    Eigen::Matrix3Xf axes(3, points_.cols());
    parallelFor(
        points_.cols(), [&](Eigen::Index i) { axes.col(i) = axisOf(normals_, near.of(i)); },
        progress);
    return axes;
  }

  [[nodiscard]] Eigen::Matrix3Xf betterAxes(const Eigen::Matrix3Xf& axes,
                                            const Progress& progress) {
    Eigen::Matrix3Xf found(3, points_.cols());
    parallelFor(
        points_.cols(), [&](Eigen::Index i) { found.col(i) = axisOf(normals_, section(i, axes)); },
        progress.part(0, 0.9), 32);
    Eigen::Matrix3Xf smooth(3, points_.cols());
    parallelFor(
        points_.cols(), [&](Eigen::Index i) { smooth.col(i) = meanAxis(found, i); },
        progress.part(0.9, 1));
    return smooth;
  }

  /// @param isKnown  set by point: whether the normals give the place
  [[nodiscard]] Eigen::Matrix3Xf places(const Eigen::Matrix3Xf& axes, std::vector<char>& isKnown,
                                        const Progress& progress) {
    Eigen::Matrix3Xf result(3, points_.cols());
    const auto put = [&](Eigen::Index i) {
      const Members& members = section(i, axes);
      const auto place = meetingPlace(points_, normals_, members, options_.reach);
      isKnown[static_cast<std::size_t>(i)] = place ? 1 : 0;
      if (place) {
        result.col(i) = place->cast<float>();
        return;
      }
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const std::uint32_t point : members)
        sum += points_.col(point).cast<double>();
      result.col(i) = (sum / static_cast<double>(members.size())).cast<float>();
    };
    parallelFor(points_.cols(), put, progress, 32);
    return result;
  }

private:
  const Members& section(Eigen::Index i, const Eigen::Matrix3Xf& axes) {
    return growers_.local().around(static_cast<std::uint32_t>(i), axes.col(i),
                                   static_cast<float>(options_.width),
                                   static_cast<float>(options_.reach));
  }

  /// Of a point and those linked to it; axes have no sign.
  [[nodiscard]] Eigen::Vector3f meanAxis(const Eigen::Matrix3Xf& axes, Eigen::Index i) const {
    Eigen::Matrix3f sum = axes.col(i) * axes.col(i).transpose();
    for (const NeighborhoodGraph::Link& link : graph_.links(i))
      sum += axes.col(link.to) * axes.col(link.to).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(sum).eigenvectors().col(2);
  }

  const Eigen::Matrix3Xf& points_;
  const NeighborhoodGraph& graph_;
  const Eigen::Matrix3Xf& normals_;
  const RotationalSymmetryOptions& options_;
  oneapi::tbb::enumerable_thread_specific<SectionGrower> growers_;
};

/// Moves places that are not known to the mean of those of linked points.
Eigen::Matrix3Xf followed(const Eigen::Matrix3Xf& places, const std::vector<char>& isKnown,
                          const NeighborhoodGraph& graph, const Progress& progress) {
  Eigen::Matrix3Xf result = places;
  const auto follow = [&](Eigen::Index i) {
    if (isKnown[static_cast<std::size_t>(i)] != 0 || graph.links(i).empty()) return;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const NeighborhoodGraph::Link& link : graph.links(i))
      sum += places.col(link.to).cast<double>();
    result.col(i) = (sum / static_cast<double>(graph.links(i).size())).cast<float>();
  };
  parallelFor(places.cols(), follow, progress);
  return result;
}

} // namespace

Eigen::Matrix3Xf contractedToSymmetryAxes(const Eigen::Matrix3Xf& points,
                                          const RotationalSymmetryOptions& options,
                                          const Progress& progress) {
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.1));
  const Neighborhoods near =
      nearestNeighborhoods(points, options.normalNeighbors, progress.part(0.1, 0.2));
  const Eigen::Matrix3Xf across = orientedNormals(
      points, normals(points, near, progress.part(0.2, 0.25)), graph, progress.part(0.25, 0.3));
  SymmetrySearch search(points, graph, across, options);
  Eigen::Matrix3Xf axes = search.firstAxes(near, progress.part(0.3, 0.35));
  for (int round = 0; round < options.rounds; ++round)
    axes = search.betterAxes(axes, progress.part(0.35 + 0.4 * round / options.rounds,
                                                 0.35 + 0.4 * (round + 1) / options.rounds));
  std::vector<char> isKnown(static_cast<std::size_t>(points.cols()), 0);
  Eigen::Matrix3Xf places = search.places(axes, isKnown, progress.part(0.75, 0.95));
  for (int round = 0; round < options.smoothing; ++round)
    places = followed(places, isKnown, graph, progress.part(0.95, 1));
  progress.update(1);
  return places;
}

} // namespace espalier
