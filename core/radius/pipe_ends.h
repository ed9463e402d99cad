#pragma once

#include "core/base/progress.h"
#include "core/radius/cross_section.h"
#include "core/radius/measured_radius.h"
#include "core/radius/node_count_pipe_model.h"

#include <cstdint>
#include <vector>

namespace espalier {

/// Radii of circles about the lowest wood, by id [L]; 0 where there is none.
///
/// That wood is the chain from the heaviest root over the child that carries most, as far as it
/// carries half of the nodes of the root; while it has fewer than 5 circles, a quarter, an eighth,
/// and so on: many stems may leave one foot. All points about it count, those nearer to other
/// nodes, too: a thick trunk that was not drawn to its axis has several strands of nodes on its
/// bark. Circles that points cover too little of, or lie badly on, are left out: see
/// measuredCircle. Uses all threads. Deterministic. @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<double> lowestWoodRadii(const Skeleton& skeleton,
                                                  const IndexedPoints& points,
                                                  const Progress& progress = {});

/// What the ends of a pipe model follow from.
enum class PipeBasis : std::uint8_t {
  foot,     // the radii of the foot and of the tips
  footOnly, // that of the foot: those of the tips are of no plant beside it
  tipsOnly, // that of the tips: none is known at the foot
  nothing   // no radius is known
};

struct PipeEnds {
  NodeCountPipeOptions radii;
  PipeBasis basis = PipeBasis::nothing;
  double footToTip = 0; // of what was measured; 0 if not both were
};

/// 1 / exponent of the pipe model of published structures: 2.7 to 3.0 in four of them.
inline constexpr double publishedPipe = 2.9;

/// The radii at both ends of a node-count pipe model, over many nodes each.
///
/// Tip: the radius that a hundredth of the outermost wood, of nodes that carry at most 3, is
/// thinner than. A skeleton beside the axis, needles, leaves and twigs that were not found only add
/// to what thin wood measures.
/// Foot: what the median of the exponents leads to that go through the tip and each radius of the
/// lowest wood. An exponent of under 1/5 or over 1 is of no plant: it is 0.33 to 0.37 in published
/// structures, 0.25 to 0.53 in grown plants, and from 1/3 to 1/2 by Murray's law and da Vinci's
/// rule. Then the tips are not trusted, and the exponent is that of published structures. So it is
/// where one of the ends was not measured.
///
/// @param lowest    by lowestWoodRadii; where all are 0, `wood` of the same chain counts
/// @param wood      by id
/// @param otherwise radius of the tips if nothing is known [L], >= 0
/// @return finite radii, that of the apex at most that of the root
/// Deterministic. Time O(n).
/// Chosen on grown plants (12) and structures (9), each bare and in leaf: with the settings of the
/// thesis, the means of the median errors of radii are 0.131, 0.153, 0.117 and 0.146, all else by
/// default 0.089, 0.125, 0.111 and 0.123; with a twentieth instead of a hundredth 0.133, 0.190,
/// 0.084 and 0.199, and 0.091, 0.138, 0.077 and 0.154. Thin radii are corrected first (knownRadii).
[[nodiscard]] PipeEnds pipeEnds(const Skeleton& skeleton, const std::vector<double>& lowest,
                                const std::vector<MeasuredRadius>& wood, double otherwise);

} // namespace espalier
