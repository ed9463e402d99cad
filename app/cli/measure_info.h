#pragma once

#include "core/pipeline/scan_measures.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace espalier {

/// Keys: spacing.{low,median,high}, scatter, scatter_in_spacings, thickness.{low,median,high},
/// thickness_in_spacings.{low,median,high}, thickness_measured, arc_degrees, gaps, largest_gap,
/// foliage; slabs[].{from,to,points} with the same. Null is what the points do not show.
[[nodiscard]] nlohmann::ordered_json measuresJson(const ScanMeasures& measures);

/// The same as a table with a row of the whole scan and one per slab, the lowest last, as it
/// stands.
[[nodiscard]] std::string measuresText(const ScanMeasures& measures);

} // namespace espalier
