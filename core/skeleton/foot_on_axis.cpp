#include "core/skeleton/foot_on_axis.h"

#include "core/base/quantile.h"
#include "core/skeleton/assign_points.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <vector>

namespace espalier {
namespace {

constexpr double nearRoot = 2; // radii within which first edges are looked at
constexpr double straight = 3; // radii beyond over which the direction of the wood is measured
constexpr std::size_t nodesForRadius = 12;

/// A line out of the wood at its foot.
struct FootLine {
  Eigen::Vector3d from;     // where the axis goes on straight [L]
  Eigen::Vector3d outwards; // unit
  double radius;            // of the wood [L]

  [[nodiscard]] double along(const Eigen::Vector3d& place) const {
    return (place - from).dot(outwards);
  }
  [[nodiscard]] double across(const Eigen::Vector3d& place) const {
    return (place - from - along(place) * outwards).norm();
  }
};

/// Path length from the first node of an axis to each.
std::vector<double> pathLengths(const Skeleton& skeleton, const Axis& axis) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < axis.size(); ++i)
    lengths.push_back(lengths.back() + (skeleton[axis[i]].position - //
                                        skeleton[axis[i - 1]].position)
                                           .norm());
  return lengths;
}

/// The first node at least so far along, or the last.
std::size_t firstBeyond(const std::vector<double>& lengths, double least) {
  const auto at = std::ranges::lower_bound(lengths, least);
  return std::min(static_cast<std::size_t>(at - lengths.begin()), lengths.size() - 1);
}

/// What lies beside the line in the wood, and below where it begins.
bool isWithin(const Skeleton& skeleton, NodeId top, const FootLine& line) {
  std::vector<NodeId> nodes = {top};
  while (!nodes.empty()) {
    const NodeId id = nodes.back();
    nodes.pop_back();
    const Eigen::Vector3d& place = skeleton[id].position;
    if (line.across(place) > 1.5 * line.radius || line.along(place) < -line.radius) return false;
    const std::vector<NodeId>& children = skeleton.children(id);
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
  return true;
}

/// How far the points around the line go on along it.
double reachOf(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& origin,
               const FootLine& line) {
  constexpr double most = 0.95; // of the points: the last are strays, or of the ground
  std::vector<double> reaches;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d place = points.col(i).cast<double>() + origin;
    const double along = line.along(place);
    if (along > 0 && along < nearRoot * line.radius && line.across(place) < 1.3 * line.radius)
      reaches.push_back(along);
  }
  return quantile(std::move(reaches), most).value_or(0);
}

} // namespace

Skeleton withFootOnAxis(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                        const Eigen::Vector3d& origin, const Progress& progress) {
  std::vector<Axis> trunks;
  for (Axis& axis : axes(skeleton))
    if (!skeleton[axis.front()].parent && axis.size() > 2) trunks.push_back(std::move(axis));
  if (trunks.empty() || points.cols() == 0) return skeleton;
  std::unordered_map<NodeId, std::size_t> trunkOf; // of nodes whose points give the radius
  for (std::size_t t = 0; t < trunks.size(); ++t)
    for (std::size_t i = 2; i < std::min(trunks[t].size(), nodesForRadius); ++i)
      trunkOf.emplace(trunks[t][i], t);
  std::vector<std::vector<double>> distances(trunks.size());
  for (const PointOnSkeleton& place : assignPoints(points, origin, skeleton, progress))
    if (const auto trunk = trunkOf.find(place.child); trunk != trunkOf.end())
      distances[trunk->second].push_back(place.distance);
  Skeleton result = skeleton;
  SkeletonEditor editor(result);
  for (std::size_t t = 0; t < trunks.size(); ++t) {
    const Axis& axis = trunks[t];
    const double radius = quantile(std::move(distances[t]), 0.5).value_or(0);
    const std::vector<double> lengths = pathLengths(skeleton, axis);
    const std::size_t begins = firstBeyond(lengths, nearRoot * radius);
    const std::size_t ends = firstBeyond(lengths, lengths[begins] + straight * radius);
    if (begins == 0 || ends == begins) continue;
    const auto placeOf = [&](std::size_t i) { return skeleton[axis[i]].position; };
    const FootLine line{placeOf(begins), (placeOf(begins) - placeOf(ends)).normalized(), radius};
    const double across = line.across(placeOf(0));
    const double slope = std::tan(25 * std::numbers::pi / 180);
    if (across < radius / 3 || across < slope * line.along(placeOf(0))) continue;
    const auto besideAxis = [&](std::size_t i) { // branches of a node
      std::vector<NodeId> branches = skeleton.children(axis[i]);
      std::erase(branches, axis[i + 1]);
      return branches;
    };
    const auto isInWood = [&](NodeId branch) { return isWithin(skeleton, branch, line); };
    if (!std::ranges::all_of(besideAxis(0), isInWood)) continue;
    const double reach = std::max(reachOf(points, origin, line), radius / 10);
    for (std::size_t i = 0; i < begins; ++i) {
      const double share = static_cast<double>(begins - i) / static_cast<double>(begins);
      editor.setPosition(axis[i], line.from + share * reach * line.outwards);
    }
    for (std::size_t i = 0; i < ends; ++i)
      for (const NodeId branch : besideAxis(i))
        if (isInWood(branch)) removeSubtree(editor, branch);
  }
  (void)editor.commit();
  return result;
}

} // namespace espalier
