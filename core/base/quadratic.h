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

/// The same of features and of all products of two of them. Each feature is taken from -1 at its
/// least to 1 at its most, and beyond them as there.
template <std::size_t Features> struct WholeQuadratic {
  static constexpr std::size_t pairs = Features * (Features + 1) / 2;

  double constant = 0;
  std::array<double, Features> weights = {};
  std::array<double, pairs> pairWeights = {}; // of the first with itself and each after it, ...
  std::array<double, Features> least = {};
  std::array<double, Features> most = {};

  [[nodiscard]] std::array<double, Features>
  scaled(const std::array<double, Features>& features) const {
    std::array<double, Features> result = {};
    for (std::size_t i = 0; i < Features; ++i)
      if (most[i] > least[i])
        result[i] =
            2 * (std::clamp(features[i], least[i], most[i]) - least[i]) / (most[i] - least[i]) - 1;
    return result;
  }

  [[nodiscard]] double value(const std::array<double, Features>& features) const {
    const std::array<double, Features> taken = scaled(features);
    double sum = constant;
    std::size_t pair = 0;
    for (std::size_t i = 0; i < Features; ++i) {
      double factor = weights[i];
      for (std::size_t k = i; k < Features; ++k)
        factor += pairWeights[pair++] * taken[k];
      sum += taken[i] * factor;
    }
    return sum;
  }
};

} // namespace espalier
