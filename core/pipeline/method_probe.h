#pragma once

#include "core/base/spatial_index.h"
#include "core/contract/circle_center.h"
#include "core/graph/densities.h"
#include "core/graph/neighborhood_graph.h"
#include "core/graph/orientations.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// The points of a scan that cleaning keeps; others name them by their place among these.
struct SeenPoints {
  const Eigen::Matrix3Xf& positions;
  const NeighborhoodGraph& graph;
  const SpatialIndex& index;
};

/// Where a contraction looks from.
struct SeenFrom {
  std::uint32_t point = 0;
  double radius = 0; // [L] how far; 0 for those that look at nearest points or links
  Orientation orientation = {};
};

/// What densities follow from: core/graph/densities.h.
struct DensityValues {
  PointLinks neighbors = 0; // of each point
  double radius = 0;        // [L]
  DensityMeasure measure = DensityMeasure::range;
  bool operator==(const DensityValues&) const = default;
};

/// The cones through which a method of the skeleton looks for children of a node.
struct ConeProbe {
  double angle = 0;                             // full opening [rad]
  std::function<double(double density)> length; // [L], at a normalized density
  DensityMeasure measure = DensityMeasure::range;
};

/// How a method looks at the plant, with the values of its options: what can be drawn at a point,
/// and how much of the scan it needs about one. The default sees the point alone.
struct MethodProbe {
  PointLinks links = 7; // of the graph that it looks along
  double reach = 0; // [L] what lies farther off is not looked at; 0: nearest points, links or none
  std::optional<DensityValues> density = {};        // that its radius follows
  std::function<double(float density)> radius = {}; // [L], normalized density
  std::optional<double> orientationRadius = {};     // [L]; none: as its radius
  /// The points that the new place is from; none: the point itself.
  std::function<std::vector<std::uint32_t>(const SeenPoints&, const SeenFrom&)> ball = {};
  /// Fitted to these, in place of their mean; none: no circle is.
  std::function<std::optional<WoodCircle>(const std::vector<Eigen::Vector3f>&, const SeenFrom&)>
      circle = {};
  std::optional<ConeProbe> cones = {};
};

} // namespace espalier
