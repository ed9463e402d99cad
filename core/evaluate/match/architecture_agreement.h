#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/match/type_agreement.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// How much of one order of the reference has the same order in the result.
struct OrderAgreement {
  double length = 0; // of the reference near the result [L]
  double same = 1;   // in [0, 1]: share of it whose order is the same; 1 if there is none
};

/// Whether orders, axes and edge types are the same where two skeletons lie near each other.
struct ArchitectureAgreement {
  double distance = 0;                 // [L], what is called near
  double compared = 0;                 // in [0, 1]: share of the reference's length that is near
  double sameOrder = 1;                // in [0, 1]: share of that; 1 if nothing is near
  double sameAxis = 1;                 // likewise
  std::vector<OrderAgreement> byOrder; // of the reference, order 0 first
  TypeAgreement types;                 // of the edges by which matched segments are attached
};

/// Compares orders and axes at even samples of the reference with those of the nearest place of the
/// result, and the types of the edges at which matched segments begin.
///
/// Each axis of the reference stands for at most one of the result and the reverse, so that as much
/// length as can be lies on axes that stand for each other: that length is the same axis.
///
/// @param matches  of these very skeletons
/// @param distance [L], > 0
/// @param step     [L] between samples, > 0
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Nodes within an edge change nothing. Time O((N + samples) log N).
[[nodiscard]] ArchitectureAgreement architectureAgreement(const Skeleton& result,
                                                          const Skeleton& reference,
                                                          const AuthorsComparison& matches,
                                                          double distance, double step,
                                                          const Progress& progress = {});

} // namespace espalier
