#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace espalier {

/// A number that features add up to, each taken as it is and squared: of a regression.
template <std::size_t Features> struct Quadratic {
  double constant = 0;
  std::array<double, Features> weights = {};       // of the features
  std::array<double, Features> squareWeights = {}; // of their squares
  std::array<double, Features> least = {};         // each feature is taken within these bounds:
  std::array<double, Features> most = {};          // what was fitted says nothing beyond them

  [[nodiscard]] double value(const std::array<double, Features>& features) const {
    double sum = constant;
    for (std::size_t i = 0; i < Features; ++i) {
      const double feature = std::clamp(features[i], least[i], most[i]);
      sum += feature * (weights[i] + feature * squareWeights[i]);
    }
    return sum;
  }
};

} // namespace espalier
