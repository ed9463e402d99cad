#pragma once

#include "core/skeleton/edge_index.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace espalier {

/// A place of a plant that is known, by the path from its root.
struct ReferencePlace {
  NodeId node{};                                      // above it
  double depth = 0;                                   // [L], along the plant from its root
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); // [L]
  double distance = 0;                                // [L], of what was asked for from there
};

/// Where things lie on a plant that is known. It must outlive this.
class ReferencePlaces {
public:
  /// pre: the plant is not empty. O(N log N)
  explicit ReferencePlaces(const Skeleton& plant);

  [[nodiscard]] ReferencePlace nearest(const Eigen::Vector3d& point) const; // O(log N)
  [[nodiscard]] double radiusAt(const ReferencePlace& place) const {        // [L]
    return plant_[place.node].radius;
  }
  /// The place between another and the root that is nearest to a point. O(depth)
  [[nodiscard]] ReferencePlace below(const ReferencePlace& from,
                                     const Eigen::Vector3d& point) const;

private:
  const Skeleton& plant_;
  EdgeIndex index_;
  std::vector<double> depths_; // by id [L]
};

/// Wood that may grow from a place.
struct WoodFrom {
  Eigen::Vector3d from; // [L]
  Eigen::Vector3d to;   // [L] on the wood
};

/// How much more wood of the plant that is known lies between each of several places and what may
/// grow from it than between the best of them [L]; infinite where the wood does not grow from
/// there.
/// @param near  [L] how far a place lies from the path down at most, beside 1.5 radii there
[[nodiscard]] std::vector<double> detours(const std::vector<WoodFrom>& links,
                                          const ReferencePlaces& known, double near);

} // namespace espalier
