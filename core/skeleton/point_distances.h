#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/skeleton_delta.h"

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// How far each point of a scan is from a skeleton, kept up to date edit by edit.
///
/// The distance to the surface is the least of all edges, of the distance to the center line less
/// the radius there: negative inside the wood. Without nodes all distances are infinite.
///
/// Points are taken in runs that lie close together, and the edges that may be nearest to any of a
/// run are found once for all of it. What is computed of a run follows from the skeleton alone, so
/// that update() gives, bit for bit, what is computed anew.
class PointDistances {
public:
  /// @param spacing between neighboring points [L]: sets the size of a run, not the result
  /// pre: `cloud` is not null
  /// @throws Cancelled if `progress` asks to stop
  /// Uses all threads, deterministic. Time O(n log n + N c): c edges may be nearest to a run.
  PointDistances(std::shared_ptr<const PointCloud> cloud, double spacing, const Skeleton& skeleton,
                 const Progress& progress = {});

  /// Takes in an edit; looks again at the points that it can have brought nearer or farther only.
  /// @param skeleton as it is after `delta`; before, it was as it is known here
  /// @return the points that may have changed, in order
  std::vector<Eigen::Index> update(const Skeleton& skeleton, const SkeletonDelta& delta);

  [[nodiscard]] const std::shared_ptr<const PointCloud>& cloud() const { return cloud_; }
  [[nodiscard]] const std::vector<float>& toSurface() const { return toSurface_; } // [L] per point
  /// The upper end of the edge whose surface is nearest; of several, the lowest id. Without meaning
  /// where there are no nodes.
  [[nodiscard]] const std::vector<NodeId>& nearest() const { return nearest_; }

private:
  struct Run {
    Eigen::Index begin = 0, end = 0; // points
    Eigen::AlignedBox3d box;         // about them, frame of the cloud [L]
    double farthestFromAxis = 0;     // [L]
    double farthestFromSurface = 0;
    std::vector<NodeId> owners; // whose axis or surface is nearest to any, lowest first
  };
  struct Candidate;

  void makeRuns(double spacing);
  void plant(); // the index of all edges of now
  [[nodiscard]] std::optional<Frustum> bodyHere(const Skeleton& skeleton, NodeId id) const;
  [[nodiscard]] std::vector<NodeId> candidates(const Run& run) const;
  void measure(Run& run);
  [[nodiscard]] bool mayChange(const Run& run, const std::vector<NodeId>& touched) const;

  std::shared_ptr<const PointCloud> cloud_;
  std::vector<Run> runs_;
  std::vector<float> toSurface_;
  std::vector<NodeId> nearest_;

  std::vector<std::optional<Frustum>> bodies_; // by id, frame of the cloud
  EdgeIndex index_;                            // of them, as they were when it was planted
  std::vector<bool> isLoose_;                  // by id: has changed since
  std::vector<NodeId> loose_;                  // those, lowest first
};

} // namespace espalier
