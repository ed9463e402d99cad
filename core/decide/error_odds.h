#pragma once

#include "core/base/quadratic.h"
#include "core/decide/error_evidence.h"

#include <array>

namespace espalier {

/// What the probability of an error follows from: lengths and counts by their logarithms.
[[nodiscard]] std::array<double, 16> featuresOf(const ErrorEvidence& evidence);

/// Whose value is the logarithm of the odds, of a logistic regression.
using ErrorOdds = Quadratic<16>;

/// The odds that are fitted: by espalier_fit_errors (tests/bench/fit_errors.cpp) on simulated
/// scans.
[[nodiscard]] const ErrorOdds& fittedErrorOdds();

/// What features are of wood that is right: medians of the plants that the odds are fitted to.
[[nodiscard]] const std::array<double, 16>& usualFeatures();

/// How probable it is that an edge of a piece is wrong, in (0, 1).
[[nodiscard]] double probabilityOfError(const ErrorEvidence& evidence,
                                        const ErrorOdds& odds = fittedErrorOdds());

} // namespace espalier
