#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>

namespace espalier {

struct NetworkOptions {
  double deviation; // [L], > 0: how fast what lies apart counts as wrong
  double distance;  // [L], > 0: the farthest that tips and branchings that are one may be apart
  double step;      // [L], > 0: between samples
};

/// Shares of two plants, as networks, that the other lacks; in [0, 1].
struct NetworkAgreement {
  double deviation = 0;           // [L], as used
  double missedLength = 0;        // geometric false negative rate: of the reference
  double inventedLength = 0;      // geometric false positive rate: of the result
  std::size_t connections = 0;    // of the reference, between landmarks that both have
  double missedConnections = 0;   // share of these that the result lacks; 0 if there are none
  double inventedConnections = 0; // share of those of the result that the reference lacks
};

/// How much of two plants is missed and invented, and how much of what both have is connected
/// otherwise.
///
/// A place at the distance d from the other plant is wrong by 1 - exp(-d^2 / (2 deviation^2)).
/// Landmarks are paired as partnersOf() does; a connection leads from one with a partner down to
/// the next one with a partner. Which way up a plant grows does not matter to its connections.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + samples) log N).
/// Source: D. Mayerich, C. Bjornsson, J. Taylor, B. Roysam, "NetMets: software for quantifying and
/// visualizing errors in biological network segmentation", BMC Bioinformatics 13, 2012.
[[nodiscard]] NetworkAgreement networkAgreement(const Skeleton& result, const Skeleton& reference,
                                                const NetworkOptions& options,
                                                const Progress& progress = {});

} // namespace espalier
