#include "core/skeleton/duplicates.h"

#include "core/base/spatial_index.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/path_edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace espalier {
namespace {

/// Places as an index takes them: single precision about the first.
Eigen::Matrix3Xf columns(const std::vector<Eigen::Vector3d>& places) {
  Eigen::Matrix3Xf result(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = (places[i] - places.front()).cast<float>();
  return result;
}

bool areLinked(const Skeleton& skeleton, NodeId a, NodeId b) {
  return skeleton[a].parent == b || skeleton[b].parent == a;
}

/// Samples along all axes, and which axis each is of.
struct Samples {
  std::vector<Eigen::Vector3d> places;
  std::vector<std::size_t> axes;
};

/// At most `spacing` [L] apart, its nodes included; without the node that bears an axis.
Samples sampled(const Skeleton& skeleton, const std::vector<Axis>& axes, double spacing) {
  Samples samples;
  const auto add = [&](const Eigen::Vector3d& place, std::size_t axis) {
    samples.places.push_back(place);
    samples.axes.push_back(axis);
  };
  for (std::size_t i = 0; i < axes.size(); ++i) {
    add(skeleton[axes[i].front()].position, i);
    for (std::size_t k = 1; k < axes[i].size(); ++k) {
      const Eigen::Vector3d& from = skeleton[axes[i][k - 1]].position;
      const Eigen::Vector3d edge = skeleton[axes[i][k]].position - from;
      constexpr double most = 1000; // one edge across a plant of tiny ones
      const double parts = std::min(std::ceil(edge.norm() / spacing), most);
      for (double part = 1; part <= parts; ++part)
        add(from + part / parts * edge, i);
    }
  }
  return samples;
}

} // namespace

double duplicateTolerance(const Skeleton& skeleton) {
  return meanEdgeLength(skeleton) / 4;
}

std::vector<NodeId> duplicatedNodes(const Skeleton& skeleton, double tolerance) {
  assert(tolerance >= 0);
  std::vector<NodeId> ids = skeleton.ids();
  if (ids.empty()) return {};
  std::vector<Eigen::Vector3d> places;
  places.reserve(ids.size());
  for (const NodeId id : ids)
    places.push_back(skeleton[id].position);
  const Eigen::Matrix3Xf points = columns(places);
  const SpatialIndex index(points);
  std::vector<NodeId> result;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto isOther = [&](Eigen::Index other) {
      const auto k = static_cast<std::size_t>(other);
      return k != i && !areLinked(skeleton, ids[i], ids[k]) &&
             (places[i] - places[k]).norm() <= tolerance;
    };
    // The index is in single precision: the exact distance decides.
    const float reach = static_cast<float>(tolerance) * 1.001F + 1e-30F;
    if (index.nearestIf(points.col(static_cast<Eigen::Index>(i)), reach, isOther))
      result.push_back(ids[i]);
  }
  return result;
}

std::vector<NodeId> duplicatedBranches(const Skeleton& skeleton, double tolerance) {
  if (skeleton.isEmpty() || tolerance <= 0) return {};
  const std::vector<Axis> all = axes(skeleton);
  const Samples samples = sampled(skeleton, all, tolerance / 2);
  const Eigen::Matrix3Xf points = columns(samples.places);
  const SpatialIndex index(points);
  std::vector<std::size_t> shortestFirst(all.size());
  std::iota(shortestFirst.begin(), shortestFirst.end(), 0);
  std::vector<double> lengths;
  lengths.reserve(all.size());
  for (const Axis& axis : all)
    lengths.push_back(length(skeleton, axis));
  std::ranges::stable_sort(shortestFirst, [&](std::size_t a, std::size_t b) {
    return lengths[a] != lengths[b] ? lengths[a] < lengths[b] : a > b;
  });

  std::vector<bool> isDuplicate(all.size(), false);
  for (const std::size_t axis : shortestFirst) {
    const bool isBranch = skeleton[all[axis].front()].parent.has_value();
    if (!isBranch || lengths[axis] < 2 * tolerance) continue;
    const auto isNearOther = [&](NodeId id) {
      const Eigen::Vector3f place = (skeleton[id].position - samples.places.front()).cast<float>();
      return index
          .nearestIf(place, static_cast<float>(tolerance),
                     [&](Eigen::Index sample) {
                       const std::size_t other = samples.axes[static_cast<std::size_t>(sample)];
                       return other != axis && !isDuplicate[other];
                     })
          .has_value();
    };
    isDuplicate[axis] = std::ranges::all_of(all[axis], isNearOther);
  }
  std::vector<NodeId> result;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (isDuplicate[i]) result.insert(result.end(), all[i].begin(), all[i].end());
  return result;
}

} // namespace espalier
