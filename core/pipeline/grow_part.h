#pragma once

#include "core/pipeline/pipeline.h"

#include <vector>

namespace espalier {

// What regrowing a node and growing new branches share: the pipeline, run on a part of a scan.

inline constexpr std::size_t fewestPoints = 20; // that tell a branch from dust

/// The points that no edge of a skeleton explains: they lie farther than `tolerance` [L] from the
/// tube of the edge they are nearest to. Points set aside are none of them.
/// @param isAsFree  by id: points nearest to the edge of such a node are free as well; may be empty
/// pre: the skeleton is not empty. @throws Cancelled if `progress` asks to stop
/// Uses all threads. Time O(N log n).
[[nodiscard]] std::vector<Eigen::Index>
freePoints(const Skeleton& skeleton, const PointCloud& cloud, const PointSet& leftOut,
           double tolerance, const std::vector<bool>& isAsFree = {}, const Progress& progress = {});

/// How far each point is from the nearest tube, and whose edge that is. As assignPoints().
struct PointByTube {
  NodeId child;
  double distance; // to the surface [L]; negative inside
};
[[nodiscard]] std::vector<PointByTube> pointsByTube(const Eigen::Matrix3Xf& points,
                                                    const Eigen::Vector3d& origin,
                                                    const Skeleton& skeleton,
                                                    const Progress& progress = {});

/// What the rules of the option tables follow from. O(N log N).
[[nodiscard]] PlantScale scaleOf(const PointCloud& cloud, UpAxis up);

/// All steps of the pipeline on some points of a cloud, with the settings that its rules give for
/// the whole: so what grows looks like the rest.
/// @param points  columns, ascending
/// @param whole   of the cloud
/// @param root    where it grows from [L], frame of the file
/// @throws Error     if the pipeline fails
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Skeleton grownPart(const PointCloud& cloud, const std::vector<Eigen::Index>& points,
                                 const Eigen::Vector3d& root, const PlantScale& whole,
                                 const PipelineOptions& options, const Progress& progress = {});

/// A grown skeleton hung on a root that stands for `node`; none of it is thicker than that, if that
/// has a radius. Its foot is left out where it lies within half an edge of the node.
[[nodiscard]] Skeleton hungOn(const Node& node, const Skeleton& grown);

} // namespace espalier
