#pragma once

#include <Eigen/Core>

#include <vector>

namespace espalier {

using Polyline = std::vector<Eigen::Vector3d>; // [L]

/// Places along a polyline at even steps of at most `step`, its ends included: where its vertices
/// lie between them does not matter. A polyline without length gives its first vertex.
/// pre: not empty, step > 0
[[nodiscard]] Polyline evenPlaces(const Polyline& polyline, double step);

/// Greatest distance from the places to the polyline, or some distance above `limit` as soon as one
/// is known to be [L]. pre: the polyline is not empty
[[nodiscard]] double farthestOf(const Polyline& places, const Polyline& polyline, double limit);

} // namespace espalier
