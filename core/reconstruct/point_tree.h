#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <vector>

namespace espalier {

/// A tree of many nodes, in the making. Node 0 is its root; parents have lower numbers than their
/// children, so that a loop upwards or downwards over the numbers visits them in order.
struct PointTree {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  using Children = std::vector<std::vector<std::uint32_t>>; // by node, ascending

  std::vector<Eigen::Vector3d> positions; // [L]
  std::vector<std::uint32_t> parents;     // none of the root

  [[nodiscard]] std::size_t size() const { return positions.size(); }
  [[nodiscard]] Children children() const;
  [[nodiscard]] Eigen::Vector3d edge(std::size_t node) const { // from the parent; pre: not the root
    return positions[node] - positions[parents[node]];
  }
  /// Length of the longest path down from each node [L].
  [[nodiscard]] std::vector<double> longestDown() const;
  /// Length of all edges that each node carries [L].
  [[nodiscard]] std::vector<double> lengthCarried() const;
};

struct PointTreeOptions {
  PointLinks neighbors = 12; // of each point
  double power = 1;          // a link costs its length to this power, >= 1
  double widestGap = 0;      // [L] parts farther apart are not joined; 0 = join all
};

/// The shortest paths from `root` to all points that links lead to.
///
/// Points are linked to their nearest neighbors, and what falls apart is joined by the shortest
/// bridges. With power 2 the paths are nearly those of the links of a Delaunay triangulation, and
/// of all links there can be: a link pays only if no point lies in the sphere over it.
/// @param points 3 x N [L], finite
/// @throws Error     if under half of the points can be reached
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N).
[[nodiscard]] PointTree shortestPathTree(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                         const PointTreeOptions& options,
                                         const Progress& progress = {});

/// The nodes that are attached to node 0 by `children`, numbered anew.
[[nodiscard]] PointTree renumbered(const std::vector<Eigen::Vector3d>& positions,
                                   const PointTree::Children& children);

/// The tree with nodes at most `spacing` [L] apart: longer edges get more of them.
[[nodiscard]] Skeleton skeletonOf(const PointTree& tree, double spacing);

} // namespace espalier
