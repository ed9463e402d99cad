#pragma once

#include "core/base/box_tree.h"
#include "core/skeleton/frustum.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {

/// The place of a skeleton that is nearest to some other place.
struct NearestPlace {
  NodeId node;              // the lower end of the edge is its parent
  Eigen::Vector3d position; // [L], on the edge from `node` to its parent
  Eigen::Vector3d along;    // direction of that edge, length 1; zero where an end is nearest
  double distance;          // [L]
  double share;             // of the edge, 0 at the parent, 1 at the node
};

/// Finds the edges of a skeleton that are near a place, anywhere along them and not at their nodes
/// alone.
///
/// Copies what it needs of the skeleton. Build O(N log N), one query about O(log N).
/// Queries are const and may run on many threads.
class EdgeIndex {
public:
  explicit EdgeIndex(const Skeleton& skeleton); // center lines; roots are edges without length
  explicit EdgeIndex(std::vector<EdgeBody> edges);

  [[nodiscard]] const std::vector<EdgeBody>& edges() const { return edges_; }

  /// Along the center lines. None if there are no edges.
  [[nodiscard]] std::optional<NearestPlace> nearest(const Eigen::Vector3d& place) const;

  /// From a place to the nearest center line of those that accepts(node) [L]; infinite if none is.
  template <class Accepts>
  [[nodiscard]] double distance(const Eigen::Vector3d& place, const Accepts& accepts) const {
    return leastDistance(place, accepts, [&](const Frustum& body) {
      return (body.at(body.nearestShare(place)) - place).squaredNorm();
    });
  }

  /// From a place to the nearest surface of those that accepts(node), 0 inside [L]; infinite if
  /// none is.
  template <class Accepts>
  [[nodiscard]] double distanceToSurface(const Eigen::Vector3d& place,
                                         const Accepts& accepts) const {
    return leastDistance(place, accepts, [&](const Frustum& body) {
      const double share = body.nearestShare(place);
      const double distance = std::max(0.0, (body.at(share) - place).norm() - body.radiusAt(share));
      return distance * distance;
    });
  }

  /// Calls visit(edge) for each edge of which the box about its frustum is at most `distance` [L]
  /// from `box`, in no order that means anything.
  template <class Visit>
  void within(const Eigen::AlignedBox3d& box, double distance, const Visit& visit) const {
    boxes_.within(box, distance, [&](std::size_t i) { visit(edges_[i]); });
  }

private:
  template <class Accepts, class Squared>
  [[nodiscard]] double leastDistance(const Eigen::Vector3d& place, const Accepts& accepts,
                                     const Squared& squared) const {
    double least = std::numeric_limits<double>::infinity();
    static_cast<void>(boxes_.nearest(place, [&](std::size_t i) {
      if (!accepts(edges_[i].node)) return std::numeric_limits<double>::infinity();
      const double found = squared(edges_[i].body);
      least = std::min(least, found);
      return found;
    }));
    return std::sqrt(least);
  }

  std::vector<EdgeBody> edges_;
  BoxTree boxes_;
};

} // namespace espalier
