#pragma once

#include "core/io/points/point_glance.h"

#include <nlohmann/json_fwd.hpp>

namespace espalier {

/// Keys: version, compressed, points, points_estimated, stations, columns[].{name,type}, left_out,
/// bounds.{minimum,maximum}, bounds_of_sample, size_in_meters, unit, unit_stated, unit_reason, up,
/// up_stated, up_reason, read_whole. Null or absent is what is not known.
[[nodiscard]] nlohmann::ordered_json scanInfo(const PointGlance& glance);

} // namespace espalier
