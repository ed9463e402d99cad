#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {

/// What a node lies in.
struct TrueWood {
  NodeId node;       // of the truth, at the upper end of the edge
  double radius = 0; // there [L], > 0
};

/// The true wood of the nodes, by id; none where there is none within its radius and a spacing, or
/// where it has no thickness, as a midrib.
/// @param spacing of the points [L], > 0
[[nodiscard]] std::vector<std::optional<TrueWood>> trueWood(const Skeleton& result,
                                                            const Skeleton& truth, double spacing);

/// The radius of a node that lies within the true wood or near it.
struct JudgedRadius {
  double thickness = 0; // true radius, in spacings
  double seen = 0;      // how much of the way around the true wood has points, in [0, 1]
  double error = 0;     // relative, < 0 if too thin
};

/// @param scan    of the truth
/// @param spacing of its points [L], > 0
[[nodiscard]] std::vector<JudgedRadius> judgedRadii(const Skeleton& result, const Skeleton& truth,
                                                    const PointCloud& scan, double spacing);

/// Which wood; lower ends belong to it, upper ones do not.
struct WoodRange {
  double thinnest = 0;
  double thickest = std::numeric_limits<double>::infinity();
  double leastSeen = 0;
  double mostSeen = 2;
};

/// Relative, 0 where there are none.
struct RadiusErrors {
  std::size_t count = 0;
  double median = 0; // of their sizes
  double signedMedian = 0;
};
[[nodiscard]] RadiusErrors errorsOf(const std::vector<JudgedRadius>& judged, const WoodRange& wood);

/// By thickness, and by how much was seen of wood that is over a spacing thick.
void printRadii(const std::vector<JudgedRadius>& judged);

} // namespace espalier
