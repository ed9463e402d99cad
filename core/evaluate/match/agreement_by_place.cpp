#include "core/evaluate/match/agreement_by_place.h"

#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/even_samples.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

constexpr std::size_t layers = 10; // of height

/// What of one skeleton lies near the other.
struct PlaceSide {
  std::vector<EvenSample> samples;
  std::vector<double> distances; // by sample [L]
  std::vector<int> orderOf;      // by id
  double length = 0;             // each sample stands for [L]
};

PlaceSide sideOf(const Skeleton& skeleton, const Skeleton& other, double step,
                 const Progress& progress) {
  PlaceSide side{
      .samples = evenSamples(skeleton, step), .distances = {}, .orderOf = orders(skeleton)};
  side.distances = distancesTo(EdgeIndex(other), side.samples, progress);
  side.length = totalLength(skeleton) / static_cast<double>(side.samples.size());
  return side;
}

/// Length and share near the other, of the samples that `partOf` puts into each part.
struct Shares {
  std::vector<std::size_t> all;
  std::vector<std::size_t> near;

  template <class PartOf>
  Shares(const PlaceSide& side, std::size_t parts, double distance, const PartOf& partOf)
      : all(parts, 0), near(parts, 0) {
    for (std::size_t i = 0; i < side.samples.size(); ++i) {
      const std::size_t part = partOf(side.samples[i]);
      ++all[part];
      if (side.distances[i] <= distance) ++near[part];
    }
  }
  [[nodiscard]] double share(std::size_t part) const {
    return all[part] == 0 ? 1 : static_cast<double>(near[part]) / static_cast<double>(all[part]);
  }
};

std::vector<PartAgreement> agreement(const Shares& result, double resultLength,
                                     const Shares& reference, double referenceLength) {
  std::vector<PartAgreement> parts(result.all.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
    parts[p] = {.from = static_cast<double>(p),
                .to = static_cast<double>(p),
                .resultLength = resultLength * static_cast<double>(result.all[p]),
                .referenceLength = referenceLength * static_cast<double>(reference.all[p]),
                .precision = result.share(p),
                .recall = reference.share(p)};
  return parts;
}

} // namespace

AgreementByPlace agreementByPlace(const Skeleton& result, const Skeleton& reference,
                                  double distance, double step, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const PlaceSide found = sideOf(result, reference, step, progress.part(0, 0.5));
  const PlaceSide truth = sideOf(reference, result, step, progress.part(0.5, 1));
  AgreementByPlace agreed{.distance = distance, .byOrder = {}, .byHeight = {}};

  const int mostOrder =
      std::max(*std::ranges::max_element(found.orderOf), *std::ranges::max_element(truth.orderOf));
  const auto sharesByOrder = [&](const PlaceSide& side) {
    return Shares(side, static_cast<std::size_t>(mostOrder) + 1, distance, [&](const auto& sample) {
      return static_cast<std::size_t>(side.orderOf[indexOf(sample.node)]);
    });
  };
  agreed.byOrder =
      agreement(sharesByOrder(found), found.length, sharesByOrder(truth), truth.length);

  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlaceSide* side : {&found, &truth})
    for (const EvenSample& sample : side->samples) {
      low = std::min(low, sample.position.z());
      high = std::max(high, sample.position.z());
    }
  const double layer = (high - low) / layers;
  const auto sharesByHeight = [&](const PlaceSide& side) {
    return Shares(side, layers, distance, [&](const auto& sample) {
      const double place = layer > 0 ? (sample.position.z() - low) / layer : 0;
      return std::min(layers - 1, static_cast<std::size_t>(place));
    });
  };
  agreed.byHeight =
      agreement(sharesByHeight(found), found.length, sharesByHeight(truth), truth.length);
  for (std::size_t p = 0; p < layers; ++p) {
    agreed.byHeight[p].from = low + layer * static_cast<double>(p);
    agreed.byHeight[p].to = low + layer * static_cast<double>(p + 1);
  }
  return agreed;
}

} // namespace espalier
