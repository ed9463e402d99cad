#pragma once

#include "core/evaluate/comparison.h"

#include <nlohmann/json_fwd.hpp>

namespace espalier {

/// A comparison as the command line writes it. Keys are stable; lengths are in the unit of the
/// reference, angles in degrees, all else counts and shares in [0, 1]:
///
///   authors      segments.{result,reference}, candidates, box_distance, cost, matched, mapping,
///                geometric, structural, structural_of_all, length_precision, length_recall,
///                one_to_many.{extended,cost,geometric,length_precision,length_recall}
///   capped[]     distance, matched, mapping, geometric, structural, structural_of_all
///   edit_distance distance, removing_all, inserting_all, similarity, matched, removed, inserted;
///                null if it would take too long
///   tolerance[]  distance, precision, recall, f
///   distances    step, {to_reference,to_result}.{mean,percentile_95,far_share,far_mean}
///   shift        [x, y, z] by which the middle of the result was moved; zeros if not registered
///   registration rotation, axis, turned_about, near_distance, near_share, reach, residual_before,
///                residual_after; null if not registered. The result was turned by `rotation`
///                about `axis` (null: not at all) through its middle `turned_about`, then shifted;
///                `near_share` is the share of the length of both within `near_distance` then
///   traits       {result,reference}.{nodes,roots,tips,branchings,segments,length,median_edge,
///                extent,axes_by_order,length_by_order,axes[].{count,mean_length,
///                length_deviation,median_length,mean_chord,mean_insertion,mean_base_radius,
///                mean_top_radius},stem.{length,lowest_branch,highest_branch,base_radius,
///                top_radius},strahler[].{streams,length},
///                branching_angles[].{count,mean,deviation}, divergence likewise, divergences,
///                crown.{height,base_height,depth,area,diameter,spread}},
///                {matched_tips,matched_branchings}.{distance,matched,precision,recall,f}
///   diadem       distance, landmarks, matched, connected, score
///   path_lengths distance, pairs, found, connected, mean_error, median_error, within_tenth
///   network      deviation, missed_length, invented_length, connections, missed_connections,
///                invented_connections
///   barcode      distance
///   radius       distance, compared, mean_error, root_mean_square, concordance; the last three
///                null if nothing could be compared; by_arc[].{from,to,compared,mean_error,
///                root_mean_square,relative_root_mean_square}, empty without a scan, the last three
///                null where nothing could be compared
///   breast_height height, diameter.{result,reference}, error, relative_error, missing; null where
///                there is none, and `missing` says why
///   architecture distance, compared, same_order, same_axis, by_order[].{length,same}, edges,
///                same_edge
///   by_place     distance, {by_order,by_height}[].{from,to,result_length,reference_length,
///                precision,recall}
///   wood         radius_limits, {result,reference}.{whole,by_order[],by_radius[],by_class[]}.
///                {edges,length,area,volume}; by_class[] has scale and class, too
///   light        {result,reference}.{area,star,directions[].{elevation,azimuth,weight,silhouette,
///                star},convergence[].{pixels,star}}; null unless asked for
///   scores       KEY: each of scores(), at the distance of by_place; null where it is not known
///   warnings[]   a line each
///
/// The command line adds result, reference, and what app/cli/evaluate_numbers.h states.
[[nodiscard]] nlohmann::ordered_json toJson(const Comparison& comparison);

} // namespace espalier
