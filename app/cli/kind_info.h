#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/graph/find_root.h"

#include <nlohmann/json_fwd.hpp>

namespace espalier {

/// The axis that is `up` by what is known of a scan; z where that is not known.
[[nodiscard]] UpAxis upIn(const nlohmann::ordered_json& json);

/// Adds to `json`, which says what axis is `up`, what the plant of a scan probably is:
/// kind.{likely, preset}, and the shares of its points:
/// kind.{wood,petioles,blades,needles}. Nothing of too few points.
void addKind(const PointCloud& cloud, const Progress& progress, nlohmann::ordered_json& json);

} // namespace espalier
