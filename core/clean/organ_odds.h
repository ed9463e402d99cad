#pragma once

#include "core/base/quadratic.h"
#include "core/clean/organ_features.h"
#include "core/cloud/organ.h"

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace espalier {

inline constexpr std::size_t organCount = std::tuple_size_v<decltype(allOrgans)>;

/// How probable each organ is, in the order of allOrgans: adds up to 1.
using OrganShares = std::array<float, organCount>;

inline constexpr std::size_t aroundFeatures = 9; // wood, blade and needle at each scale around
inline constexpr std::size_t organFeatureCount = std::tuple_size_v<OrganFeatures>;

using FeaturesAround = std::array<float, organFeatureCount + aroundFeatures>;

/// The logarithm of the odds of each organ: of a point by itself, then with what those around it
/// were found to be.
struct OrganOdds {
  std::array<Quadratic<organFeatureCount>, organCount> alone;
  std::array<Quadratic<organFeatureCount + aroundFeatures>, organCount> around;
};

/// The odds that are fitted: by espalier_fit_organs (tests/bench/fit_organs.cpp) on simulated
/// scans.
[[nodiscard]] const OrganOdds& fittedOrganOdds();

[[nodiscard]] std::vector<OrganShares> sharesAlone(const std::vector<OrganFeatures>& features,
                                                   const OrganOdds& odds,
                                                   const Progress& progress = {});

/// What sharesAround() adds to the features of each point.
[[nodiscard]] std::vector<FeaturesAround> featuresAround(const PointPyramid& pyramid,
                                                         const std::vector<OrganFeatures>& features,
                                                         const std::vector<OrganShares>& alone,
                                                         const Progress& progress = {});

/// The likeliest organ of each point, with the shares of its neighbors added to its own.
[[nodiscard]] std::vector<Organ> organsBy(const OrganOdds& odds, const PointPyramid& pyramid,
                                          const std::vector<OrganFeatures>& features,
                                          const Progress& progress = {});

} // namespace espalier
