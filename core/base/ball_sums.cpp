#include "core/base/ball_sums.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace espalier {
namespace {

constexpr std::uint32_t pointsPerLeaf = 8;

} // namespace

BallSums::BallSums(const Eigen::Matrix3Xf& points, const Progress& progress)
    : points_(3, points.cols()) {
  std::vector<std::uint32_t> order(static_cast<std::size_t>(points.cols()));
  if (order.empty()) return;
  std::iota(order.begin(), order.end(), 0U);
  parts_.push_back({.low = {},
                    .high = {},
                    .begin = 0,
                    .end = static_cast<std::uint32_t>(order.size()),
                    .left = 0,
                    .sum = {}});
  for (std::uint32_t part = 0; part < parts_.size(); ++part) {
    if (part % 64 == 0) progress.check();
    split(part, order, points);
  }
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points_.col(i) = points.col(order[static_cast<std::size_t>(i)]);
  for (std::size_t i = parts_.size(); i-- > 0;) { // parts come before those that they hold
    Part& part = parts_[i];
    if (part.left > 0) {
      part.sum = parts_[part.left].sum;
      part.sum += parts_[part.left + 1].sum;
      continue;
    }
    for (std::uint32_t k = part.begin; k < part.end; ++k)
      part.sum += {.positions = points_.col(k).cast<double>(), .count = 1};
  }
}

void BallSums::split(std::uint32_t part, std::vector<std::uint32_t>& order,
                     const Eigen::Matrix3Xf& points) {
  const std::uint32_t begin = parts_[part].begin;
  const std::uint32_t end = parts_[part].end;
  Eigen::Vector3f low = points.col(order[begin]);
  Eigen::Vector3f high = low;
  for (std::uint32_t k = begin; k < end; ++k) {
    low = low.cwiseMin(points.col(order[k]));
    high = high.cwiseMax(points.col(order[k]));
  }
  parts_[part].low = low;
  parts_[part].high = high;
  if (end - begin <= pointsPerLeaf) return;

  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return std::tuple(points(axis, a), a) < std::tuple(points(axis, b), b);
                   });
  parts_[part].left = static_cast<std::uint32_t>(parts_.size());
  parts_.push_back({.low = {}, .high = {}, .begin = begin, .end = middle, .left = 0, .sum = {}});
  parts_.push_back({.low = {}, .high = {}, .begin = middle, .end = end, .left = 0, .sum = {}});
}

BallSums::Sum BallSums::within(const Eigen::Vector3f& place, float radius) const {
  Sum sum;
  if (parts_.empty()) return sum;
  const float squared = radius * radius;
  std::array<std::uint32_t, 128> open{}; // at most one per level, of which there are under 32
  std::size_t depth = 1;
  while (depth > 0) {
    const Part& part = parts_[open[--depth]];
    const Eigen::Vector3f below = part.low - place;
    const Eigen::Vector3f above = place - part.high;
    if (below.cwiseMax(above).cwiseMax(0.0F).squaredNorm() > squared) continue;
    if (below.cwiseAbs().cwiseMax(above.cwiseAbs()).squaredNorm() <= squared) {
      sum += part.sum;
    } else if (part.left > 0) {
      open[depth++] = part.left;
      open[depth++] = part.left + 1;
    } else {
      for (std::uint32_t k = part.begin; k < part.end; ++k)
        if ((points_.col(k) - place).squaredNorm() <= squared)
          sum += {.positions = points_.col(k).cast<double>(), .count = 1};
    }
  }
  return sum;
}

} // namespace espalier
