#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/skeleton/branch_end.h"
#include "core/skeleton/edge_index.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// What all ends of a skeleton are like that are long enough to be asked about, before any is taken
/// away, and the scan. Lengths in point spacings.
struct AllEnds {
  double count = 0;
  double scatter = 0;     // median of theirs: of what stands around thin wood in this scan, needles
                          // and leaves the most
  double standing = 0;    // mean logarithm of protrusion by length
  double alone = 0;       // mean share of their points that nothing else explains
  double aloneSpread = 0; // standard deviation of that share
  double thickness = 0;   // of the thin wood of the plant
  double noise = 0;       // of the points about the surface of the wood
};

/// What the points say of an end: whether it is a shoot, or what bumps, noise, leaves and stray
/// points leave on a skeleton. Lengths in point spacings.
struct EndEvidence {
  double length = 0;     // from its foot to its tip
  double protrusion = 0; // from its tip to the nearest place of the rest of the skeleton
  double bearer = 0;     // how far the points of the wood that bears it are from that wood's center
                         // line, mean
  double alone = 0;      // points nearest to it that lie more than twice that and one spacing from
                         // the rest: nothing else explains them
  double points = 0;     // nearest to it
  double scatter = 0;    // how far those are from it, mean
  double turn = 0;       // cosine between it and the wood below it
  double share = 0;      // length, in heights of the plant
  AllEnds all;           // that there were at first
};

/// How far an end stands out by its length, logarithm; at most 0, about.
[[nodiscard]] double standingOf(const EndEvidence& evidence);

/// The share of the points of an end that nothing else explains, in (0, 1).
[[nodiscard]] double shareAlone(const EndEvidence& evidence);

/// The ends of a skeleton and the evidence of each, while some of them are taken away.
class EndsOfSkeleton {
public:
  struct End {
    BranchEnd end;
    EndEvidence evidence;
    Eigen::AlignedBox3d seen; // [L] what its evidence follows from lies in it
  };

  /// @param points  3 x N [L], in the frame of the skeleton after adding `origin`
  /// @param scale   of the plant, spacing and height
  /// pre: the skeleton is not empty; `points` are those of now and later, too
  /// Uses all threads, deterministic. Time O(N log n), n: nodes; memory O(N).
  /// @throws Cancelled if `progress` asks to stop
  EndsOfSkeleton(Skeleton skeleton, const Eigen::Matrix3Xf& points, const Eigen::Vector3d& origin,
                 const PlantScale& scale, const Progress& progress = {});

  [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }
  [[nodiscard]] const std::vector<End>& ends() const { return ends_; }

  /// Takes ends away, by their places in ends(); then looks again at those whose evidence may have
  /// changed. Of the ends at one foot at most all but one go. Points of what is gone count no more.
  void remove(const std::vector<std::size_t>& gone, const Progress& progress = {});

private:
  void shareOut(const Progress& progress);
  void list();
  void keepAll();
  void look(const std::vector<std::size_t>& places, const Progress& progress);
  [[nodiscard]] End lookedAt(std::size_t place) const;
  [[nodiscard]] std::vector<NodeId> bearerOf(std::size_t place) const;
  [[nodiscard]] double toRest(const Eigen::Vector3d& place, std::size_t end) const;
  [[nodiscard]] std::span<const std::uint32_t> pointsOf(NodeId id) const;
  [[nodiscard]] Eigen::Vector3d placeOf(std::uint32_t point) const;

  Skeleton skeleton_;
  const Eigen::Matrix3Xf* points_;
  Eigen::Vector3d origin_;
  PlantScale scale_;
  AllEnds all_;     // that there were at first
  EdgeIndex index_; // of the skeleton as it was at first
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> order_; // points by the node whose edge is nearest; see begins_
  std::vector<float> distances_;     // [L] by point: to it
  std::vector<End> ends_;
  std::vector<std::uint32_t> endOf_; // by id: a place in ends_
};

} // namespace espalier
