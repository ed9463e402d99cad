#pragma once

#include "core/cloud/point_set.h"
#include "core/cloud/thin_wood.h"
#include "core/graph/find_root.h"
#include "core/pipeline/option_table.h"

#include <limits>

namespace espalier {

/// How large a plant is, and where it begins.
struct PlantExtent {
  PlantScale scale;
  /// Of the points that count, along the up axis, about the origin of the cloud [L].
  float lowest = -std::numeric_limits<float>::infinity();
};

/// Measured on the points of a scan that were not set aside, each place once, but for what cannot
/// be plant: far points, and for the height those at its ends that stand alone, as the step Clean
/// has it without options. So strays change nothing, whether cleaning leaves them out or not.
///
/// @param index  of the positions of the cloud; it passes over none but what is set aside or
/// repeated Time O(N + strays log N); memory O(N).
[[nodiscard]] PlantExtent plantExtent(const PointCloud& cloud, const SpatialIndex& index,
                                      const PointSet& leftOut, UpAxis up);

/// How large a plant is along each axis of the file.
struct PlantSides {
  double spacing = 0; // [L]
  ThinWood wood;
  Eigen::Vector3d heights = Eigen::Vector3d::Zero(); // as plantExtent() has it along each axis [L]
};

/// The same along all axes, for the time of one.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] PlantSides plantSides(const PointCloud& cloud, const SpatialIndex& index,
                                    const PointSet& leftOut, const Progress& progress = {});

/// The same, where there is no index of the points. Time O(N log N).
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] PlantScale scaleOf(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                                 const Progress& progress = {});

/// The foot of the plant among some of the points, ascending: findRoot() of those of them that are
/// neither far nor below `lowest`.
/// @param leftOut  that were set aside: what is far follows from the others (farPoints())
/// pre: `points` are not empty
[[nodiscard]] Eigen::Index footAmong(const std::vector<Eigen::Index>& points,
                                     const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                                     float lowest);

} // namespace espalier
