#pragma once

#include "core/base/quadratic.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace espalier {

/// Links of which one is to be chosen, by their features.
template <std::size_t Features> struct LinkChoice {
  std::vector<std::array<double, Features>> links;
  std::vector<bool> isRight; // by link; several may be
  /// By link: the others that are the same answer; empty: none of any are.
  std::vector<std::vector<std::size_t>> alike = {};
  double weight = 1;
};

/// Between which all but two in a hundred links lie.
template <std::size_t Features>
[[nodiscard]] Quadratic<Features> boundsOf(const std::vector<LinkChoice<Features>>& choices) {
  Quadratic<Features> bounds;
  for (std::size_t i = 0; i < bounds.least.size(); ++i) {
    std::vector<double> values;
    for (const LinkChoice<Features>& choice : choices)
      for (const auto& link : choice.links)
        values.push_back(link[i]);
    std::ranges::sort(values);
    bounds.least[i] = values[values.size() / 100];
    bounds.most[i] = values[values.size() - 1 - values.size() / 100];
  }
  return bounds;
}

/// Terms of each link, a row each.
template <std::size_t Features>
[[nodiscard]] Eigen::MatrixXd termsOf(const LinkChoice<Features>& choice,
                                      const Quadratic<Features>& bounds) {
  constexpr auto features = static_cast<Eigen::Index>(Features);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(choice.links.size()), 2 * features);
  for (Eigen::Index row = 0; row < rows.rows(); ++row)
    for (Eigen::Index i = 0; i < features; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double value = std::clamp(choice.links[static_cast<std::size_t>(row)][k],
                                      bounds.least[k], bounds.most[k]);
      rows(row, i) = value;
      rows(row, features + i) = value * value;
    }
  return rows;
}

/// Maximum likelihood of a conditional logit by Newton's method, with a ridge on scaled terms.
template <std::size_t Features>
[[nodiscard]] Quadratic<Features> fittedLogit(const std::vector<LinkChoice<Features>>& choices) {
  constexpr auto features = static_cast<Eigen::Index>(Features);
  constexpr Eigen::Index terms = 2 * features;
  Quadratic<Features> odds = boundsOf(choices);
  std::vector<Eigen::MatrixXd> rows;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(terms);
  double count = 0;
  for (const LinkChoice<Features>& choice : choices) {
    rows.push_back(termsOf(choice, odds));
    squares += rows.back().cwiseAbs2().colwise().sum().transpose();
    count += static_cast<double>(rows.back().rows());
  }
  const Eigen::VectorXd scales = (squares / count).cwiseSqrt().cwiseMax(1e-9);
  for (Eigen::MatrixXd& some : rows)
    some = some * scales.cwiseInverse().asDiagonal();
  Eigen::VectorXd found = Eigen::VectorXd::Zero(terms);
  for (int step = 0; step < 200; ++step) {
    Eigen::VectorXd slope = -1e-3 * found;
    Eigen::MatrixXd curvature = 1e-3 * Eigen::MatrixXd::Identity(terms, terms);
    for (std::size_t i = 0; i < choices.size(); ++i) {
      Eigen::VectorXd share = rows[i] * found;
      share = (share.array() - share.maxCoeff()).exp();
      share /= share.sum();
      Eigen::VectorXd right = share;
      for (Eigen::Index k = 0; k < right.size(); ++k)
        if (!choices[i].isRight[static_cast<std::size_t>(k)]) right[k] = 0;
      right /= std::max(right.sum(), 1e-12);
      const Eigen::VectorXd mean = rows[i].transpose() * share;
      slope += choices[i].weight * (rows[i].transpose() * right - mean);
      curvature += choices[i].weight *
                   (rows[i].transpose() * share.asDiagonal() * rows[i] - mean * mean.transpose());
    }
    const Eigen::VectorXd change = curvature.ldlt().solve(slope);
    const double largest = change.cwiseAbs().maxCoeff();
    found += change * std::min(1.0, 1 / largest);
    if (largest < 1e-8) break;
  }
  found = found.cwiseQuotient(scales);
  for (Eigen::Index i = 0; i < features; ++i) {
    odds.weights[static_cast<std::size_t>(i)] = found[i];
    odds.squareWeights[static_cast<std::size_t>(i)] = found[features + i];
  }
  return odds;
}

/// Of the most probable link of each choice: a reliability diagram as a table, the expected
/// calibration error, and how many are right, beside those that were chosen `before`, a place in
/// the links of a choice.
template <std::size_t Features, class Before>
void printReliability(const std::vector<LinkChoice<Features>>& choices,
                      const Quadratic<Features>& odds, const char* nameOfBefore,
                      const Before& before) {
  struct Bin {
    double said = 0, were = 0;
    int count = 0;
  };
  std::array<Bin, 10> bins;
  double right = 0, rightBefore = 0;
  for (const LinkChoice<Features>& choice : choices) {
    std::vector<double> values;
    for (const auto& link : choice.links)
      values.push_back(odds.value(link));
    const auto best = std::ranges::max_element(values);
    const auto place = static_cast<std::size_t>(best - values.begin());
    double sum = 0;
    for (const double value : values)
      sum += std::exp(value - *best);
    double of = 1; // what is the same answer, by how probable the best is
    if (!choice.alike.empty())
      for (const std::size_t other : choice.alike[place])
        of += std::exp(values[other] - *best);
    const double probability = of / sum;
    Bin& bin = bins[std::min<std::size_t>(9, static_cast<std::size_t>(10 * probability))];
    bin.said += probability;
    bin.were += choice.isRight[place];
    ++bin.count;
    right += choice.isRight[place];
    rightBefore += choice.isRight[before(choice)];
  }
  const auto all = static_cast<double>(choices.size());
  double error = 0;
  std::printf("  choices  said  were\n");
  for (const Bin& bin : bins) {
    if (bin.count == 0) continue;
    std::printf("%9d  %.3f %.3f\n", bin.count, bin.said / bin.count, bin.were / bin.count);
    error += std::abs(bin.said - bin.were) / all;
  }
  std::printf("expected calibration error %.3f; right %.3f, of the %s %.3f\n", error, right / all,
              nameOfBefore, rightBefore / all);
}

} // namespace espalier
