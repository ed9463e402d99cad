#include "core/decide/end_odds.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

double probabilityOf(double logOdds) {
  return 1 / (1 + std::exp(-logOdds));
}

} // namespace

// What is added keeps the logarithm of nothing finite.
std::array<double, 10> featuresOf(const EndEvidence& evidence) {
  return {std::log(evidence.length + 0.1),
          standingOf(evidence),
          std::log((evidence.protrusion + 0.1) / (evidence.bearer + 0.1)),
          std::log(evidence.bearer + 0.1),
          shareAlone(evidence),
          std::log((evidence.points + 0.5) / (evidence.length + 1)),
          std::log(evidence.scatter + 0.1),
          evidence.turn,
          std::log(evidence.all.scatter + 0.1),
          std::log(evidence.share + 0.001)};
}

std::array<double, 16> featuresAmongAll(const EndEvidence& evidence) {
  std::array<double, 16> features = {};
  const auto own = featuresOf(evidence);
  auto next = std::ranges::copy(own, features.begin()).out;
  const AllEnds& all = evidence.all;
  for (const double feature : {std::log(all.count + 1), all.standing, all.alone, all.aloneSpread,
                               std::log(all.thickness + 0.1), std::log(all.noise + 0.1)})
    *next++ = feature;
  return features;
}

double probabilityOfShoot(const EndEvidence& evidence, const EndOdds& odds) {
  return probabilityOf(odds.value(featuresOf(evidence)));
}

double probabilityAmongAll(const EndEvidence& evidence) {
  constexpr double few = 12; // ends: of so many, what they are like counts half as much
  const AllEnds& all = evidence.all;
  if (!std::isfinite(all.thickness)) return probabilityOfShoot(evidence);
  const double share = 0.5 * all.count / (all.count + few);
  const double alone = fittedEndOdds().value(featuresOf(evidence));
  const double amongAll = fittedOddsAmongAll().value(featuresAmongAll(evidence));
  return probabilityOf(alone + share * (amongAll - alone));
}

} // namespace espalier
