#pragma once

#include "core/base/quadratic.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

namespace espalier {

/// An example that a logistic regression is fitted to.
template <std::size_t Features> struct LabelledFeatures {
  std::array<double, Features> values;
  double label = 0; // in [0, 1]: how much of it is what the odds are of
  double weight = 1;
};

/// The values of a feature with the weights of their examples, least first.
template <std::size_t Features>
[[nodiscard]] std::vector<std::pair<double, double>>
sortedValues(const std::vector<LabelledFeatures<Features>>& examples, std::size_t feature) {
  std::vector<std::pair<double, double>> values;
  values.reserve(examples.size());
  for (const auto& example : examples)
    values.emplace_back(example.values[feature], example.weight);
  std::ranges::sort(values);
  return values;
}

/// The value of a feature that a share of the examples is at or below, by weight.
[[nodiscard]] inline double quantile(const std::vector<std::pair<double, double>>& sorted,
                                     double share) {
  double all = 0, below = 0, found = 0;
  for (const auto& [value, weight] : sorted)
    all += weight;
  for (const auto& [value, weight] : sorted) {
    if (below > share * all) break;
    found = value;
    below += weight;
  }
  return found;
}

/// Between which all but two in a hundred examples lie, by weight.
template <std::size_t Features>
[[nodiscard]] Quadratic<Features>
boundedQuadratic(const std::vector<LabelledFeatures<Features>>& examples) {
  Quadratic<Features> bounds;
  for (std::size_t i = 0; i < Features; ++i) {
    const auto values = sortedValues(examples, i);
    bounds.least[i] = quantile(values, 0.01);
    bounds.most[i] = quantile(values, 0.99);
  }
  return bounds;
}

/// The weights of terms that make the labels most likely, a row of terms an example: logistic
/// regression by Newton's method, with a ridge of a ten-thousandth on scaled terms.
[[nodiscard]] inline Eigen::VectorXd
logisticWeights(Eigen::MatrixXd rows, const Eigen::VectorXd& labels, Eigen::VectorXd weights) {
  weights /= weights.mean();
  Eigen::VectorXd scales = (rows.cwiseAbs2().colwise().mean()).cwiseSqrt().transpose();
  for (double& scale : scales)
    if (scale == 0) scale = 1; // nothing has it
  rows = rows * scales.cwiseInverse().asDiagonal();
  Eigen::VectorXd found = Eigen::VectorXd::Zero(rows.cols());
  const double ridge = 1e-4 * static_cast<double>(rows.rows());
  for (int step = 0; step < 100; ++step) {
    const Eigen::VectorXd said = 1 / (1 + (-(rows * found)).array().exp());
    const Eigen::VectorXd slope =
        rows.transpose() * (weights.array() * (labels - said).array()).matrix() - ridge * found;
    const Eigen::VectorXd spread = weights.array() * said.array() * (1 - said.array());
    Eigen::MatrixXd curvature = rows.transpose() * spread.asDiagonal() * rows;
    curvature.diagonal().array() += ridge;
    const Eigen::VectorXd change = curvature.ldlt().solve(slope);
    found += change;
    if (change.cwiseAbs().maxCoeff() < 1e-10) break;
  }
  return found.cwiseQuotient(scales);
}

template <std::size_t Features>
[[nodiscard]] Eigen::VectorXd labelsOf(const std::vector<LabelledFeatures<Features>>& examples) {
  Eigen::VectorXd labels(static_cast<Eigen::Index>(examples.size()));
  for (Eigen::Index i = 0; i < labels.size(); ++i)
    labels[i] = examples[static_cast<std::size_t>(i)].label;
  return labels;
}

template <std::size_t Features>
[[nodiscard]] Eigen::VectorXd weightsOf(const std::vector<LabelledFeatures<Features>>& examples) {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(examples.size()));
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    weights[i] = examples[static_cast<std::size_t>(i)].weight;
  return weights;
}

/// The logistic regression of examples on their features, each taken as it is and squared.
template <std::size_t Features>
[[nodiscard]] Quadratic<Features>
fittedQuadratic(const std::vector<LabelledFeatures<Features>>& examples) {
  constexpr auto features = static_cast<Eigen::Index>(Features);
  Quadratic<Features> odds = boundedQuadratic(examples);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(examples.size()), 1 + 2 * features);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const auto& example = examples[static_cast<std::size_t>(i)];
    rows(i, 0) = 1;
    for (Eigen::Index k = 0; k < features; ++k) {
      const auto at = static_cast<std::size_t>(k);
      rows(i, 1 + k) = std::clamp(example.values[at], odds.least[at], odds.most[at]);
      rows(i, 1 + features + k) = rows(i, 1 + k) * rows(i, 1 + k);
    }
  }
  const Eigen::VectorXd found =
      logisticWeights(std::move(rows), labelsOf(examples), weightsOf(examples));
  odds.constant = found[0];
  for (Eigen::Index i = 0; i < features; ++i) {
    odds.weights[static_cast<std::size_t>(i)] = found[1 + i];
    odds.squareWeights[static_cast<std::size_t>(i)] = found[1 + features + i];
  }
  return odds;
}

/// The logistic regression of examples on their features and all products of two of them.
template <std::size_t Features>
[[nodiscard]] WholeQuadratic<Features>
fittedWholeQuadratic(const std::vector<LabelledFeatures<Features>>& examples) {
  constexpr auto features = static_cast<Eigen::Index>(Features);
  constexpr auto pairs = static_cast<Eigen::Index>(WholeQuadratic<Features>::pairs);
  WholeQuadratic<Features> odds;
  const Quadratic<Features> bounds = boundedQuadratic(examples);
  odds.least = bounds.least;
  odds.most = bounds.most;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(examples.size()), 1 + features + pairs);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const auto taken = odds.scaled(examples[static_cast<std::size_t>(i)].values);
    Eigen::Index next = 0;
    rows(i, next++) = 1;
    for (const double value : taken)
      rows(i, next++) = value;
    for (std::size_t k = 0; k < Features; ++k)
      for (std::size_t m = k; m < Features; ++m)
        rows(i, next++) = taken[k] * taken[m];
  }
  const Eigen::VectorXd found =
      logisticWeights(std::move(rows), labelsOf(examples), weightsOf(examples));
  odds.constant = found[0];
  std::copy_n(found.begin() + 1, features, odds.weights.begin());
  std::copy_n(found.begin() + 1 + features, pairs, odds.pairWeights.begin());
  return odds;
}

/// A list of numbers as it stands in the sources.
template <std::size_t Count>
void printNumbers(const char* name, const std::array<double, Count>& values) {
  std::printf("      .%s = {", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.4f", i ? ", " : "", values[i]);
  std::printf("},\n");
}

/// As it stands in the sources.
template <std::size_t Features> void printQuadratic(const Quadratic<Features>& odds) {
  std::printf("      .constant = %.4f,\n", odds.constant);
  printNumbers("weights", odds.weights);
  printNumbers("squareWeights", odds.squareWeights);
  printNumbers("least", odds.least);
  printNumbers("most", odds.most);
}

template <std::size_t Features> void printQuadratic(const WholeQuadratic<Features>& odds) {
  std::printf("      .constant = %.4f,\n", odds.constant);
  printNumbers("weights", odds.weights);
  printNumbers("pairWeights", odds.pairWeights);
  printNumbers("least", odds.least);
  printNumbers("most", odds.most);
}

} // namespace espalier
