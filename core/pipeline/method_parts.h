#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// One value per option of a method, in order.
using Values = std::vector<double>;

/// The method "none" of a step that may be left out.
[[nodiscard]] Method noMethod(std::string help);

/// The points that cleaning kept, ascending.
[[nodiscard]] std::vector<Eigen::Index> keptPoints(const PipelineState& state);

/// Where they are in the scan, about the origin of the cloud [L].
[[nodiscard]] Eigen::Matrix3Xf keptPositions(const PipelineState& state);

/// @throws Error if they are too few for a plant
void requirePlant(const std::vector<Eigen::Index>& kept);

} // namespace espalier
