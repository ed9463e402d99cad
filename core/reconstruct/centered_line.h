#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

// Lines from place to place, as they become the nodes of a branch. All lengths in [L].

[[nodiscard]] double lengthOfLine(const std::vector<Eigen::Vector3d>& line);

/// Distance from a place to the nearest place of a line. pre: it is not empty
[[nodiscard]] double distanceToLine(const Eigen::Vector3d& place,
                                    const std::vector<Eigen::Vector3d>& line);

/// The same line from end to end by places that are evenly spaced along it, as near to `step` as
/// their number allows; at least its two ends. pre: two places or more, step > 0
/// Time O(places + length / step).
[[nodiscard]] std::vector<Eigen::Vector3d> spacedEvenly(const std::vector<Eigen::Vector3d>& line,
                                                        double step);

/// A line whose places, but for its ends, move by `share` to the mean of their two neighbors.
[[nodiscard]] std::vector<Eigen::Vector3d> smoothedLine(const std::vector<Eigen::Vector3d>& line,
                                                        double share, int rounds);

/// Direction of a line at one of its places; none where it has no length. pre: at < line.size()
[[nodiscard]] std::optional<Eigen::Vector3d> directionAt(const std::vector<Eigen::Vector3d>& line,
                                                         std::size_t at);

/// Wood cut across.
struct WoodSection {
  Eigen::Vector3d middle; // [L]
  double radius;          // [L]
};

/// The wood that points around a place come from: a circle fitted to them across `axis`, without
/// those that are far off it, as the points of a twig that starts there are.
///
/// @param place  in the wood or on its bark [L]
/// @return none where they cover too little of a circle, or are none
/// Time O(N).
[[nodiscard]] std::optional<WoodSection> sectionAt(const Eigen::Vector3d& place,
                                                   const Eigen::Vector3d& axis,
                                                   const std::vector<Eigen::Vector3d>& points);

} // namespace espalier
