#include "core/radius/radius_evidence.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

RadiusQuantiles operator*(double factor, const RadiusQuantiles& of) {
  return {factor * of.low, factor * of.middle, factor * of.high};
}

RadiusQuantiles operator+(const RadiusQuantiles& a, const RadiusQuantiles& b) {
  return {a.low + b.low, a.middle + b.middle, a.high + b.high};
}

/// Means of each node and those next to it on its axis, by 1 to 2 to 1.
std::vector<RadiusQuantiles> smoothed(const Skeleton& skeleton,
                                      const std::vector<RadiusQuantiles>& own) {
  std::vector<RadiusQuantiles> result(own.size());
  for (const NodeId id : skeleton.ids()) {
    RadiusQuantiles sum = 2 * own[indexOf(id)];
    double weights = 2;
    for (const auto& next : {previousOnAxis(skeleton, id), nextOnAxis(skeleton, id)})
      if (next) {
        sum = sum + own[indexOf(*next)];
        ++weights;
      }
    result[indexOf(id)] = 1 / weights * sum;
  }
  return result;
}

constexpr double notable = 0.05; // of a correction

/// How much of the middle a radius, in spacings, is corrected by, in [0, 1].
double correction(const RadiusQuantiles& quantiles, double radius) {
  constexpr double certain = 0.5;
  constexpr double uncertain = 0.9;
  constexpr double thick = 3; // spacings
  constexpr double thin = 2;
  const double width = quantiles.high - quantiles.low;
  return std::clamp((width - certain) / (uncertain - certain), 0.0, 1.0) *
         std::clamp((thick - radius) / (thick - thin), 0.0, 1.0);
}

} // namespace

// What is added keeps the logarithm of nothing finite.
std::array<double, 11> featuresOf(const RadiusEvidence& evidence) {
  return {std::log(evidence.radius),
          std::log(evidence.deviation),
          evidence.share,
          std::log(evidence.model / evidence.radius),
          std::log(evidence.pointError + 0.05),
          std::log(evidence.modelSpread),
          std::log((evidence.meanDistance + 0.05) / evidence.radius),
          std::log(evidence.carried + 1),
          evidence.measured > 0 ? std::log(evidence.measured / evidence.radius) : 0,
          evidence.exponent,
          std::log(evidence.points + 1)};
}

RadiusQuantiles RadiusRegression::of(const RadiusEvidence& evidence) const {
  const auto features = featuresOf(evidence);
  const double at = middle.value(features);
  return {std::min(low.value(features), at), at, std::max(high.value(features), at)};
}

std::vector<KnownRadius> knownRadii(const Skeleton& skeleton,
                                    const std::vector<RadiusEvidence>& evidence, double spacing,
                                    const RadiusRegression& regression) {
  std::vector<RadiusQuantiles> quantiles(evidence.size());
  for (const NodeId id : skeleton.ids())
    quantiles[indexOf(id)] = regression.of(evidence[indexOf(id)]);
  quantiles = smoothed(skeleton, quantiles);
  std::vector<KnownRadius> known(evidence.size());
  for (const NodeId id : skeleton.ids()) {
    const RadiusQuantiles& at = quantiles[indexOf(id)];
    const double change = correction(at, evidence[indexOf(id)].radius) * at.middle;
    RadiusSource source = sourceOf(evidence[indexOf(id)].share);
    if (source == RadiusSource::measured && std::abs(change) > notable)
      source = RadiusSource::corrected;
    known[indexOf(id)] = {
        .radius = spacing * evidence[indexOf(id)].radius * std::exp(change),
        .origin = {.source = source,
                   .least = static_cast<float>(std::exp(std::min(at.low - change, 0.0))),
                   .most = static_cast<float>(std::exp(std::max(at.high - change, 0.0)))}};
  }
  return known;
}

} // namespace espalier
