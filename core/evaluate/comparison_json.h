#pragma once

#include "core/evaluate/comparison.h"

#include <nlohmann/json_fwd.hpp>

namespace espalier {

/// A comparison as the command line writes it. Keys are stable; lengths are in the unit of the
/// reference, angles in degrees, all else counts and shares in [0, 1]:
///
///   authors      segments.{result,reference}, candidates, box_distance, cost, matched, mapping,
///                geometric, structural, length_precision, length_recall
///   tolerance[]  distance, precision, recall, f
///   distances    step, {to_reference,to_result}.{mean,percentile_95}
///   shift        [x, y, z] by which the result was moved; zeros if it was not registered
///   registration rotation, reach, residual_before, residual_after; null if not registered
///   traits       {result,reference}.{nodes,roots,tips,branchings,segments,length,median_edge,
///                extent,axes_by_order,length_by_order},
///                {matched_tips,matched_branchings}.{distance,matched,precision,recall,f}
///   warnings[]   a line each
[[nodiscard]] nlohmann::ordered_json toJson(const Comparison& comparison);

} // namespace espalier
