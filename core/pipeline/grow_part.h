#pragma once

#include "core/pipeline/pipeline_options.h"
#include "core/skeleton/assign_points.h"

#include <vector>

namespace espalier {

// What regrowing a node and growing new branches share: the steps, run on some points of a scan.

inline constexpr std::size_t fewestPoints = 20; // that distinguish a branch from dust
inline constexpr std::size_t fewestChosen = 5;  // of those that someone chose: a twig has few
inline constexpr double widestAhead = 30; // spacings: gap that a branch leads over straight on
inline constexpr int partLinks = 12;      // of a point, to find what is connected

/// How far from the surface of wood [L] a point is explained by it, unless one asks for another
/// distance: 3 spacings or, of a scan with much noise, 3 scatters.
[[nodiscard]] double usualTolerance(const PlantScale& whole);

/// The points of a cloud that no edge of a skeleton explains: they lie farther than its bark from
/// the axis of the edge that they are nearest to. Points set aside are none of them, and each place
/// counts once.
/// @param places    where on the skeleton each point is, as assignPoints()
/// @param bark      by id [L], as barkReaches()
/// @param isAsFree  by id: points nearest to the edge of such a node are free as well; may be empty
/// @return ascending. Time O(N log N).
[[nodiscard]] std::vector<Eigen::Index> freePoints(const PointCloud& cloud, const PointSet& leftOut,
                                                   const std::vector<PointOnSkeleton>& places,
                                                   const std::vector<double>& bark,
                                                   const std::vector<bool>& isAsFree = {});

/// How far each point is from the nearest frustum, and whose edge that is. As assignPoints().
struct PointByFrustum {
  NodeId child;
  double distance; // to the surface [L]; negative inside
};
[[nodiscard]] std::vector<PointByFrustum> pointsByFrustum(const Eigen::Matrix3Xf& points,
                                                          const Eigen::Vector3d& origin,
                                                          const Skeleton& skeleton,
                                                          const Progress& progress = {});

/// The radius of the wood at a place of an edge [L].
[[nodiscard]] double frustumRadius(const Skeleton& skeleton, const PointOnSkeleton& place);

/// All steps on some points of a cloud, with the settings that their rules give for the whole: so
/// what grows looks like the rest.
/// @param points  columns, ascending
/// @param whole   of the cloud
/// @param root    where it grows from [L], frame of the file
/// @throws Error     if a step fails
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Skeleton grownPart(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                                 const Eigen::Vector3d& root, const PlantScale& whole,
                                 const PipelineOptions& options, const Progress& progress = {});

/// Where a trace along points begins.
enum class TracedFrom {
  end,  // of the points
  start // the place where they are meant: of a node that carries them
};

/// Nodes along some points of a cloud: a trace from end to end of them, or from `start` to the
/// farthest, and one for each branch of 6 spacings or more off it, at most 50. Of fewer than 20
/// points, a straight line.
/// @param points  columns, ascending; not empty
/// @param start   [L], frame of the file: where the points are meant
/// @param edge    [L] wanted length of edges, > 0; shorter in bends
/// @return a tree of two nodes or more; empty if there is no length from first to last
/// @throws Cancelled if `progress` asks to stop
/// Time O(b n log n) for b branches.
[[nodiscard]] Skeleton treeAlong(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                                 const Eigen::Vector3d& start, double edge, TracedFrom from,
                                 const Progress& progress = {});

/// How far points lie from the edges of a skeleton, in the mean [L]; infinite if it has none.
/// @param points  columns of `cloud`; not empty
[[nodiscard]] double meanDistance(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                                  const Skeleton& skeleton);

/// What grows of points by the pipeline, or is traced along them where that follows them as well:
/// of a few points, the pipeline makes a node or two.
/// @param root, edge  as of grownPart() and treeAlong()
/// @return a tree; empty if nothing grows
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Skeleton grownOrTraced(const PointCloud& cloud,
                                     const std::vector<Eigen::Index>& points,
                                     const Eigen::Vector3d& root, const PlantScale& whole,
                                     const PipelineOptions& options, double edge,
                                     const Progress& progress = {});

} // namespace espalier
