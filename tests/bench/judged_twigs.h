#pragma once

#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace espalier {

/// A branch of a plant with at most three tips, which the scan shows.
struct Twig {
  NodeId first;                     // its lowest node
  std::vector<NodeId> nodes;        // all of it, parents first
  std::vector<Eigen::Index> points; // within 3 spacings of its wood, and nearest to it; ascending
};

/// A plant without some of its twigs.
struct PrunedPlant {
  Skeleton truth;
  Skeleton pruned; // has the ids of the truth
  std::vector<Twig> twigs;
};

/// Takes twigs off a plant, at most `count`, none of them on another; each has 8 points or more
/// that are over 3 spacings from all other wood. Deterministic for a seed.
[[nodiscard]] PrunedPlant withoutTwigs(const Skeleton& truth,
                                       const std::shared_ptr<const PointCloud>& cloud,
                                       double spacing, std::size_t count, std::uint64_t seed);

/// How wood that was made compares with the twig it was made for. Lengths in [L].
struct TwigScore {
  double length = 0;   // of the twig, outside its bearer, where points show it
  double found = 0;    // of that: new wood lies within tolerance
  double grown = 0;    // of new wood, outside the bearer
  double near = 0;     // of that: within tolerance of the twig
  double sharpest = 0; // turn at a new edge [degrees]
  double air = 0;      // the longest stretch of a new edge without points and far from all wood
  double skin = 0;   // of new wood: in the wood or within a spacing of the skin of other wood, off
                     // the twig
  double begins = 0; // from where the twig leaves its bearer to where the new wood does
};

/// Compares new wood with the truth.
///
/// The tolerance is half the radius of the true wood, or 1.5 spacings where that is more. A stretch
/// leads through air where no point is within 2 spacings of its wood, nor true wood within 3.
class TwigJudge {
public:
  /// All must outlive it.
  TwigJudge(const PrunedPlant& plant, const PointCloud& cloud, double spacing);

  /// @param made   the pruned plant with new nodes
  /// @param added  these
  [[nodiscard]] TwigScore score(const Twig& twig, const Skeleton& made,
                                const std::vector<NodeId>& added) const;

private:
  [[nodiscard]] bool isSeen(const Eigen::Vector3d& place, double radius) const;
  [[nodiscard]] double airOn(const Frustum& edge) const;

  const PrunedPlant& plant_;
  const PointCloud& cloud_;
  double spacing_;
  SpatialIndex points_;
  EdgeIndex truth_;  // bodies
  EdgeIndex pruned_; // likewise
};

} // namespace espalier
