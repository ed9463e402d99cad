#pragma once

#include "ui/document/tool_input.h"

#include <Eigen/Geometry>

#include <optional>

namespace espalier {

/// The plane through `place` that faces the eye: where a drag of what is there moves it.
[[nodiscard]] Eigen::Hyperplane<double, 3> screenPlane(const Eigen::Vector3d& place,
                                                       const ToolInput& input);

/// Where the pointer meets the plane, if it does so in front of the eye.
[[nodiscard]] std::optional<Eigen::Vector3d> meet(const Eigen::Hyperplane<double, 3>& plane,
                                                  const ToolInput& input);

/// True once the pointer has left the place where it was pressed by more than a shaky hand does.
[[nodiscard]] bool isDragged(const QPointF& from, const QPointF& to);

} // namespace espalier
