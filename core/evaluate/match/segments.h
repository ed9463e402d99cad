#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// Maximal unbranched chain of nodes, whatever the types of its edges: the unit of comparison.
struct Segment {
  std::vector<NodeId> nodes;             // from the root side to the tip side; never empty
  std::vector<Eigen::Vector3d> polyline; // [L]: the parent of nodes.front(), if any, then nodes
  double length = 0;                     // [L], of polyline
  Eigen::AlignedBox3d box;               // of polyline
  std::optional<std::size_t> parent;     // the segment this one stands on; none at a root
};

/// Cuts a skeleton into its unbranched segments.
///
/// A segment starts at each root and at each node whose parent has several children, and runs to
/// the next node with several children, included, or to the apex. Each node is in one segment.
/// @return segments in the order of skeleton.ids() of their first nodes: parents before their
/// children, a successor before branches. Time and memory O(N).
/// Source: the authors' comparison program (thesis, 5.4.1). No node is moved or left out.
[[nodiscard]] std::vector<Segment> unbranchedSegments(const Skeleton& skeleton);

/// Symmetric Hausdorff distance between the vertices of two polylines [L].
///
/// Vertices only, as the authors measure: it depends on how densely nodes lie along an edge.
/// pre: neither is empty. Time O(A B).
[[nodiscard]] double vertexHausdorff(const std::vector<Eigen::Vector3d>& a,
                                     const std::vector<Eigen::Vector3d>& b);

} // namespace espalier
