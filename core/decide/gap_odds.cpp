#include "core/decide/gap_odds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace espalier {

std::array<double, 10> featuresOf(const GapEvidence& evidence, double spacing,
                                  const Eigen::Vector3d& up) {
  return {std::log(evidence.length / spacing + 1),
          evidence.goesOn,
          evidence.isFromTip ? 1.0 : 0.0,
          evidence.goesOnBelow,
          evidence.radii,
          evidence.isThere ? 1.0 : 0.0,
          std::log(static_cast<double>(evidence.nodes)),
          std::log(evidence.backward + 1),
          evidence.direction.dot(up),
          std::log(evidence.cost / spacing + 1)};
}

const GapOdds& fittedGapOdds() {
  // espalier_fit_gaps of 120 plants. On 60 others the expected calibration error of the most
  // probable links is 0.029, and 0.908 of them are right, where 0.854 of the cheapest are.
  static constexpr GapOdds odds{
      .weights = {-3.3341, -2.0671, 1.3351, -2.2727, 0.5310, 0.7055, 0.1930, -2.4058, 2.0345,
                  -2.5647},
      .squareWeights = {0.8998, 1.3693, 1.3351, 0.2450, 0.8300, 0.7055, -0.0066, 1.0644, 0.0169,
                        -0.2193},
      .least = {0.8857, -0.3151, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, -0.9707, 1.8351},
      .most = {3.9294, 0.9997, 1.0000, 0.9997, 1.4871, 1.0000, 8.9015, 1.9605, 0.9813, 5.8456},
  };
  return odds;
}

std::vector<double> probabilitiesOf(const Gaps& gaps, double spacing, const Eigen::Vector3d& up,
                                    const GapOdds& odds) {
  std::vector<double> values;
  std::vector<double> most(gaps.entries.size(), -std::numeric_limits<double>::infinity());
  for (const GapLink& link : gaps.links) {
    values.push_back(odds.value(featuresOf(link.evidence, spacing, up)));
    most[link.borne] = std::max(most[link.borne], values.back());
  }
  std::vector<double> sums(gaps.entries.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint32_t borne = gaps.links[i].borne;
    values[i] = std::exp(values[i] - most[borne]);
    sums[borne] += values[i];
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] /= sums[gaps.links[i].borne];
  return values;
}

} // namespace espalier
