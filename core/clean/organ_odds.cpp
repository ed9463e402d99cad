#include "core/clean/organ_odds.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

template <std::size_t Count>
std::vector<OrganShares> sharesBy(const std::vector<std::array<float, Count>>& features,
                                  const std::array<Quadratic<Count>, organCount>& odds,
                                  const Progress& progress) {
  std::vector<OrganShares> shares(features.size());
  parallelFor(
      std::ssize(features),
      [&](Eigen::Index i) {
        std::array<double, Count> values;
        std::ranges::copy(features[static_cast<std::size_t>(i)], values.begin());
        std::array<double, organCount> each = {};
        double sum = 0;
        for (std::size_t k = 0; k < each.size(); ++k)
          sum += each[k] = 1 / (1 + std::exp(-odds[k].value(values)));
        for (std::size_t k = 0; k < each.size(); ++k)
          shares[static_cast<std::size_t>(i)][k] = static_cast<float>(each[k] / sum);
      },
      progress);
  return shares;
}

/// The likeliest of the shares of a point and of its neighbors together.
std::vector<Organ> likeliest(const PointPyramid::Level& level,
                             const std::vector<OrganShares>& shares, const Progress& progress) {
  std::vector<Organ> organs(shares.size());
  const auto each = static_cast<std::size_t>(level.nearest.perPoint);
  parallelFor(
      std::ssize(organs),
      [&](Eigen::Index i) {
        const auto point = static_cast<std::size_t>(i);
        OrganShares sum = shares[point];
        for (std::size_t k = point * each; k < (point + 1) * each; ++k)
          for (std::size_t organ = 0; organ < sum.size(); ++organ)
            sum[organ] += shares[level.nearest.indices[k]][organ];
        organs[point] =
            allOrgans[static_cast<std::size_t>(std::ranges::max_element(sum) - sum.begin())];
      },
      progress);
  return organs;
}

} // namespace

std::vector<OrganShares> sharesAlone(const std::vector<OrganFeatures>& features,
                                     const OrganOdds& odds, const Progress& progress) {
  return sharesBy(features, odds.alone, progress);
}

std::vector<FeaturesAround> featuresAround(const PointPyramid& pyramid,
                                           const std::vector<OrganFeatures>& features,
                                           const std::vector<OrganShares>& alone,
                                           const Progress& progress) {
  std::vector<FeaturesAround> all(features.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    std::ranges::copy(features[i], all[i].begin());
  std::size_t at = organFeatureCount;
  for (const Organ organ : {Organ::wood, Organ::blade, Organ::needle}) {
    Shares shares(alone.size());
    for (std::size_t i = 0; i < shares.size(); ++i)
      shares[i] = alone[i][static_cast<std::size_t>(organ)];
    for (const Shares& around : sharesAround(pyramid, shares)) {
      progress.check();
      for (std::size_t i = 0; i < all.size(); ++i)
        all[i][at] = around[i];
      ++at;
    }
  }
  return all;
}

std::vector<Organ> organsBy(const OrganOdds& odds, const PointPyramid& pyramid,
                            const std::vector<OrganFeatures>& features, const Progress& progress) {
  const auto alone = sharesAlone(features, odds, progress.part(0, 0.3));
  const auto around = featuresAround(pyramid, features, alone, progress.part(0.3, 0.5));
  return likeliest(pyramid.levels().front(), sharesBy(around, odds.around, progress.part(0.5, 0.9)),
                   progress.part(0.9, 1));
}

} // namespace espalier
