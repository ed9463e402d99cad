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
  // probable links is 0.015, and 0.960 of them are right, where 0.903 of the present ones are.
  static constexpr AttachmentOdds odds{
      .weights = {-0.5142, -1.9275, -1.6812, -0.7664, -2.1455, 0.1994, -4.7172, 1.0378, -0.1752,
                  0.4764, 0.1648, -0.3911, -0.4063, 0.6624, 0.9114, -0.3667},
      .squareWeights = {-0.6912, 2.9521, 2.4009, 1.2898, 0.5908, 0.3986, 2.4947, -0.7490, 0.0564,
                        0.4764, -0.6111, -0.3911, 0.0503, 0.9157, -0.1875, 0.3957},
      .least = {0.0000, -0.9437, 0.0000, -0.7990, 0.1342, -1.3908, 0.0000, -0.9662, 0.0000, 0.0000,
                -1.0000, 0.0000, 0.0000, -1.0000, 0.0000, 0.0000},
      .most = {3.4188, 0.9997, 0.9967, 0.9984, 3.4387, 1.8995, 0.8710, 0.9878, 4.5033, 1.0000,
               0.9980, 1.0000, 7.2290, 0.9955, 0.9987, 2.5479},
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
