#pragma once

#include "core/base/box_tree.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// The place of a skeleton that is nearest to some other place.
struct NearestPlace {
  NodeId node;              // the lower end of the edge is its parent
  Eigen::Vector3d position; // [L], on the edge from `node` to its parent
  Eigen::Vector3d along;    // direction of that edge, length 1; zero where an end is nearest
  double distance;          // [L]
};

/// Finds the nearest place on a skeleton, anywhere along its edges and not at its nodes alone.
///
/// Copies what it needs of the skeleton. Build O(N log N), one query about O(log N).
/// Queries are const and may run on many threads.
class EdgeIndex {
public:
  explicit EdgeIndex(const Skeleton& skeleton);

  /// None if the skeleton has no nodes.
  [[nodiscard]] std::optional<NearestPlace> nearest(const Eigen::Vector3d& place) const;

private:
  struct Edge {
    NodeId node;
    Eigen::Vector3d start; // at the parent, if any
    Eigen::Vector3d way;   // from start to the node; zero at a root
    [[nodiscard]] Eigen::AlignedBox3d box() const;
    [[nodiscard]] double nearestShare(const Eigen::Vector3d& place) const; // of way, in [0, 1]
  };
  static std::vector<Edge> edgesOf(const Skeleton& skeleton);
  static BoxTree boxesOf(const std::vector<Edge>& edges);

  std::vector<Edge> edges_;
  BoxTree boxes_;
};

} // namespace espalier
