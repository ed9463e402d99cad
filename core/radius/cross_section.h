#pragma once

#include "core/base/spatial_index.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// The wood about a node, seen along its axis from the tip: places across it are (right, up).
struct CrossSection {
  Eigen::Vector3d center;              // the node [L], frame of the file: place (0, 0)
  Eigen::Vector3d right;               // unit; with `up` it spans the plane across the axis
  Eigen::Vector3d up;                  // unit; as near to +z as it can, to +y about an upright axis
  double halfThickness;                // of the slab that the points are from [L]
  std::vector<Eigen::Vector2d> points; // of the node's own branch [L]
  std::vector<Eigen::Vector2d> others; // of other branches near it [L]

  [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector2d& at) const { // [L], frame of the file
    return center + at.x() * right + at.y() * up;
  }
};

/// The points of a scan and what finds them.
struct IndexedPoints {
  const Eigen::Matrix3Xf& positions; // 3 x N about `origin` [L]
  const Eigen::Vector3d& origin;     // [L], frame of the file
  const SpatialIndex& index;         // of `positions`
  double spacing;                    // of neighboring points [L]
};

/// Takes cross-sections of a skeleton over its scan.
///
/// A section is a slab across the axis, as thick as half a radius but at least 5 point spacings.
/// The axis runs from the wood below to that above, over a length of a radius, so that it does not
/// turn with each short edge. A point belongs to the branch whose edges are nearest, in radii: half
/// of a thick stem would else go to a twig that leaves it. From the node outwards, points count up
/// to the first wide gap.
/// Refers to all it is given. Making it takes O(n log n) for n nodes.
class CrossSections {
public:
  CrossSections(const Skeleton& skeleton, const IndexedPoints& points);
  CrossSections(const CrossSections&) = delete; // the index refers to what stands beside it
  CrossSections& operator=(const CrossSections&) = delete;

  /// The section at a node; none for a node that stands alone, or all of its neighbors with it: it
  /// has no direction. pre: contains(id). Time O(m e) for m points and e edges about the node.
  [[nodiscard]] std::optional<CrossSection> at(NodeId id) const;

private:
  struct Edge {
    Eigen::Vector3d start;
    Eigen::Vector3d along;
    double share; // of an own distance that a point is nearer to count as of this edge; own: 1
    bool isOwn;
  };
  struct Sighting;
  [[nodiscard]] std::vector<Edge> edgesAbout(NodeId id, double radius, double reach) const;
  [[nodiscard]] double radiusAbout(NodeId id) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> axisAt(NodeId id, double reach) const;
  [[nodiscard]] std::vector<Sighting> look(const CrossSection& frame, NodeId id, double radius,
                                           double reach) const;

  const Skeleton& skeleton_;
  IndexedPoints points_;
  std::vector<std::uint32_t> axisOf_; // by id
  std::vector<NodeId> children_;      // the upper ends of all edges
  Eigen::Matrix3Xf middles_;          // of these edges, about the origin of the points
  double longest_ = 0;                // half of an edge [L]
  std::optional<SpatialIndex> edges_; // of middles_; none without edges
};

} // namespace espalier
