#include "core/decide/error_reasons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace espalier {
namespace {

using Kind = ErrorReason::Kind;
using Features = decltype(featuresOf(ErrorEvidence()));

// By the order of featuresOf().
constexpr std::array<Kind, std::tuple_size_v<Features>> kinds = {
    Kind::extent,   Kind::extent,      Kind::extent, Kind::fewPoints,
    Kind::scatter,  Kind::unexplained, Kind::inAir,  Kind::noPointsOfItsOwn,
    Kind::beside,   Kind::radius,      Kind::turn,   Kind::turn,
    Kind::findings, Kind::end,         Kind::end,    Kind::gap};

} // namespace

std::vector<ErrorReason> reasonsFor(const ErrorEvidence& evidence, const ErrorOdds& odds) {
  const double least = std::log(1.5);
  const Features features = featuresOf(evidence);
  const double value = odds.value(features);
  std::vector<ErrorReason> reasons;
  for (int i = 0; i <= static_cast<int>(Kind::radius); ++i) {
    const auto kind = static_cast<Kind>(i);
    Features usual = features;
    for (std::size_t k = 0; k < usual.size(); ++k)
      if (kinds[k] == kind) usual[k] = usualFeatures()[k];
    const double effect = value - odds.value(usual);
    if (effect >= least) reasons.push_back({kind, effect});
  }
  std::ranges::stable_sort(reasons, std::greater<>(), &ErrorReason::effect);
  return reasons;
}

} // namespace espalier
