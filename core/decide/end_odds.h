#pragma once

#include "core/base/quadratic.h"
#include "core/decide/end_evidence.h"

#include <array>

namespace espalier {

/// What the probability of an end follows from, by itself: its lengths and counts by their
/// logarithms.
[[nodiscard]] std::array<double, 10> featuresOf(const EndEvidence& evidence);

/// The same, and what all ends of the plant are like and the scan.
[[nodiscard]] std::array<double, 16> featuresAmongAll(const EndEvidence& evidence);

/// Whose value is the logarithm of the odds, of a logistic regression.
/// Source: D. R. Cox, "The regression analysis of binary sequences", J. R. Stat. Soc. B 20, 1958.
using EndOdds = Quadratic<10>;
using OddsAmongAll = WholeQuadratic<16>;

/// The odds that are fitted: by espalier_fit_odds (tests/bench/fit_odds.cpp) on simulated scans.
[[nodiscard]] const EndOdds& fittedEndOdds();
[[nodiscard]] const OddsAmongAll& fittedOddsAmongAll();

/// How probable it is that an end is a shoot, in (0, 1): that the measure of the method's authors
/// (core/evaluate/match/authors_comparison.h) finds it in the plant, too. Of any skeleton, also one
/// that was decided on or corrected.
[[nodiscard]] double probabilityOfShoot(const EndEvidence& evidence,
                                        const EndOdds& odds = fittedEndOdds());

/// The same of a skeleton of which no end was decided on: there, what all its ends are like says
/// what plant and scan it is of, and more are right. Up to halfway between both odds, by their
/// logarithms, since plants that none of the fitted ones is like are judged better so: less far the
/// fewer ends there are, and as by itself where the thickness of the wood is not known.
[[nodiscard]] double probabilityAmongAll(const EndEvidence& evidence);

} // namespace espalier
