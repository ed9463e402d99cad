#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <nlohmann/json_fwd.hpp>

namespace espalier {

/// Adds to `json`, which says what axis is `up`, what the plant of a scan probably is:
/// kind.{likely, probability, preset}, and the shares of its points:
/// kind.{wood,petioles,blades,needles}. Nothing of too few points.
void addKind(const PointCloud& cloud, const Progress& progress, nlohmann::ordered_json& json);

} // namespace espalier
