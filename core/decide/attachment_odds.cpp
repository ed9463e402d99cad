#include "core/decide/attachment_odds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace espalier {

std::array<double, 16> featuresOf(const AttachmentEvidence& evidence) {
  const double end = std::log(evidence.end + 1);
  const double there = evidence.isThere ? 1 : 0;
  return {std::log(evidence.gap + 1),
          evidence.goesOn,
          evidence.end > 0 ? 0 : evidence.turn,
          evidence.end > 0 ? evidence.turn : 0,
          std::log(evidence.miss + 1),
          evidence.thicker,
          evidence.inAir,
          evidence.upward,
          end,
          evidence.end > 0 ? 1.0 : 0.0,
          evidence.sibling,
          there,
          there * std::log(evidence.carried + 1),
          there * evidence.sibling,
          there * evidence.turn,
          there * std::log(evidence.gap + 1)};
}

const AttachmentOdds& fittedAttachmentOdds() {
  // espalier_fit_attachments of 120 plants. On 60 others the expected calibration error of the most
  // probable links is 0.009, and 0.969 of them are right, where 0.955 of the present ones are.
  static constexpr AttachmentOdds odds{
      .weights = {-0.8005, -1.7433, 0.2534, -0.3830, -1.9571, -0.2679, -4.8715, 0.9611, -0.6864,
                  1.8723, 0.5214, -0.5064, -0.1946, 0.7105, -0.5072, 0.7008},
      .squareWeights = {-0.3182, 1.5094, 0.6351, 0.9355, 0.3073, 0.5730, 3.3919, -1.2274, 0.0582,
                        1.8723, -1.2537, -0.5064, 0.0218, 0.5557, 1.0696, 0.0995},
      .least = {0.0000, -0.9342, 0.0000, -0.7832, 0.1302, -1.3899, 0.0000, -0.9662, 0.0000, 0.0000,
                -1.0000, 0.0000, 0.0000, -1.0000, 0.0000, 0.0000},
      .most = {3.4179, 0.9996, 0.9968, 0.9980, 3.4357, 1.9229, 0.8621, 0.9880, 4.5089, 1.0000,
               0.9981, 1.0000, 7.1324, 0.9958, 0.9986, 2.3746},
  };
  return odds;
}

std::vector<double> probabilitiesOf(const AttachmentChoice& choice, const AttachmentOdds& odds) {
  std::vector<double> values;
  for (const AttachmentLink& link : choice.links)
    values.push_back(odds.value(featuresOf(link.evidence)));
  const double most = *std::ranges::max_element(values);
  double sum = 0;
  for (double& value : values)
    sum += value = std::exp(value - most);
  for (double& value : values)
    value /= sum;
  return values;
}

} // namespace espalier
