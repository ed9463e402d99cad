#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// How well two skeletons agree in one part of the plant.
struct PartAgreement {
  double from = 0;            // an order, or a height [L]
  double to = 0;              // likewise: the order again, or a height
  double resultLength = 0;    // [L] there is in this part
  double referenceLength = 0; // [L]
  double precision = 1;       // share of the result's length there that is near the reference
  double recall = 1;          // share of the reference's length there that is near the result
};

/// Where a result agrees with its reference, and where not.
struct AgreementByPlace {
  double distance = 0;                 // [L], what is called near
  std::vector<PartAgreement> byOrder;  // order 0 first; each skeleton by its own orders
  std::vector<PartAgreement> byHeight; // tenths of the height of both together, lowest first
};

/// Precision and recall within one tolerance, by branching order and by height along z.
///
/// Samples and distances are those of toleranceCurve(). A part in which a skeleton has nothing has
/// precision, or recall, 1: nothing is invented, or missed, there.
///
/// @param distance [L], > 0
/// @param step     [L] between samples, > 0
/// @throws Error     as toleranceCurve()
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + samples) log N).
[[nodiscard]] AgreementByPlace agreementByPlace(const Skeleton& result, const Skeleton& reference,
                                                double distance, double step,
                                                const Progress& progress = {});

} // namespace espalier
