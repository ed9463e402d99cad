#pragma once

#include "core/base/quadratic.h"
#include "core/reconstruct/gap_links.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace espalier {

/// What the probability of a link over a gap follows from: its lengths by their logarithms.
/// @param spacing  of points [L]
/// @param up       length 1
[[nodiscard]] std::array<double, 14> featuresOf(const GapEvidence& evidence, double spacing,
                                                const Eigen::Vector3d& up);

/// Whose value is the logarithm of how probable a link is beside others that would bear the same
/// wood, of a conditional logit.
/// Source: D. McFadden, "Conditional logit analysis of qualitative choice behavior", in P. Zarembka
/// (ed.), Frontiers in Econometrics, 1974.
using GapOdds = Quadratic<14>;

/// Links from places so near to each other are one answer (see isAlike()): what the wood grew from
/// is known no better. In spacings.
inline constexpr double alikeWithin = 4;

/// The odds that are fitted: by espalier_fit_gaps (tests/bench/fit_gaps.cpp) on simulated scans.
[[nodiscard]] const GapOdds& fittedGapOdds();

/// How probable it is of each link, in (0, 1), that it is how the wood grew that it would bear:
/// those of one fragment add up to 1.
[[nodiscard]] std::vector<double> probabilitiesOf(const Gaps& gaps, double spacing,
                                                  const Eigen::Vector3d& up,
                                                  const GapOdds& odds = fittedGapOdds());

} // namespace espalier
