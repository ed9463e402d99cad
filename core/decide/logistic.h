#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace espalier {

/// A probability from features, each taken as it is and squared: of a logistic regression.
/// Source: D. R. Cox, "The regression analysis of binary sequences", J. R. Stat. Soc. B 20, 1958.
template <std::size_t Features> struct Logistic {
  double constant = 0;
  std::array<double, Features> weights = {};       // of the features
  std::array<double, Features> squareWeights = {}; // of their squares
  std::array<double, Features> least = {};         // each feature is taken within these bounds:
  std::array<double, Features> most = {};          // what was fitted says nothing beyond them

  /// In (0, 1).
  [[nodiscard]] double probability(const std::array<double, Features>& features) const {
    double sum = constant;
    for (std::size_t i = 0; i < Features; ++i) {
      const double feature = std::clamp(features[i], least[i], most[i]);
      sum += feature * (weights[i] + feature * squareWeights[i]);
    }
    return 1 / (1 + std::exp(-sum));
  }
};

} // namespace espalier
