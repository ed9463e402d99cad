#pragma once

#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"
#include "core/graph/find_root.h"
#include "ui/view/color_map.h"

#include <optional>
#include <vector>

namespace espalier {

enum class PointColor { uniform, height, intensity, rgb };

/// What the colors of a cloud stand for; none if it is not colored by value, or if all values are
/// equal. A height has the unit of the cloud, which is not known here. O(points).
/// Intensities are cut at their 2nd and 98th percentile: scanners give some very bright ones.
/// @param leftOut points that do not count
[[nodiscard]] std::optional<Legend> pointLegend(const PointCloud& cloud, PointColor by,
                                                UpAxis up = UpAxis::z,
                                                const PointSet& leftOut = {});

/// What a point is colored by: its height, or its intensity. pre: `cloud` has it
[[nodiscard]] double pointValue(const PointCloud& cloud, PointColor by, Eigen::Index point,
                                UpAxis up);

/// The color of each point; `plain` for all if the cloud has not what it is to be colored by.
class PointColors {
public:
  /// @param cloud  must outlive it
  /// @param legend as pointLegend(), with another range or map if wanted
  PointColors(const PointCloud& cloud, PointColor by, const std::optional<Legend>& legend,
              bool dark, const Color& plain, UpAxis up = UpAxis::z);

  [[nodiscard]] Color operator[](Eigen::Index point) const; // pre: of the cloud

private:
  const PointCloud* cloud_;
  PointColor by_;
  std::optional<LegendColors> map_; // none: not by value
  Color plain_;
  UpAxis up_;
};

} // namespace espalier
