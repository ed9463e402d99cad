#pragma once

#include "core/base/quadratic.h"
#include "core/decide/end_evidence.h"

#include <array>

namespace espalier {

/// What the probability of an end follows from: its lengths and counts by their logarithms.
[[nodiscard]] std::array<double, 10> featuresOf(const EndEvidence& evidence);

/// Whose value is the logarithm of the odds, of a logistic regression.
/// Source: D. R. Cox, "The regression analysis of binary sequences", J. R. Stat. Soc. B 20, 1958.
using EndOdds = Quadratic<10>;

/// The odds that are fitted: by espalier_fit_odds (tests/bench/fit_odds.cpp) on simulated scans.
[[nodiscard]] const EndOdds& fittedEndOdds();

/// How probable it is that an end is a shoot, in (0, 1): that the measure of the method's authors
/// (core/evaluate/match/authors_comparison.h) finds it in the plant, too.
[[nodiscard]] double probabilityOfShoot(const EndEvidence& evidence,
                                        const EndOdds& odds = fittedEndOdds());

} // namespace espalier
