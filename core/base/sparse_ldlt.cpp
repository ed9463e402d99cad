#include "core/base/sparse_ldlt.h"

#include "core/base/paced_check.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

namespace espalier {
namespace {

/// Splits parts of the unknowns, again and again.
class Dissection {
public:
  Dissection(const SymmetricPattern& pattern, const Eigen::Matrix3Xf& places,
             const Progress& progress)
      : pattern_(pattern), places_(places), pace_(progress), side_(pattern.size(), 0) {}

  /// Puts `part` in order.
  void split(std::span<std::uint32_t> part) {
    constexpr std::size_t smallest = 48;
    pace_.after(part.size());
    if (part.size() <= smallest) return;
    const Eigen::Index axis = longestAxis(part);
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::ranges::nth_element(part, middle, {}, [&](std::uint32_t i) {
      pace_.after(1);
      return std::tuple(places_(axis, i), i);
    });
    const std::uint32_t right = ++sides_;
    for (auto i = middle; i != part.end(); ++i)
      side_[*i] = right;
    // Of the first half, those that touch the second come last of all.
    const auto touches = [&](std::uint32_t i) {
      const std::span row(pattern_.columns.data() + pattern_.begin[i],
                          pattern_.columns.data() + pattern_.begin[i + 1]);
      pace_.after(row.size());
      return std::ranges::any_of(row, [&](std::uint32_t j) { return side_[j] == right; });
    };
    const auto wall =
        std::stable_partition(part.begin(), middle, [&](std::uint32_t i) { return !touches(i); });
    const auto first = static_cast<std::size_t>(wall - part.begin());
    const auto second = static_cast<std::size_t>(part.end() - middle);
    std::rotate(wall, middle, part.end());
    split(part.subspan(0, first));
    split(part.subspan(first, second));
  }

private:
  [[nodiscard]] Eigen::Index longestAxis(std::span<const std::uint32_t> part) const {
    Eigen::Vector3f low = places_.col(part.front());
    Eigen::Vector3f high = low;
    for (const std::uint32_t i : part) {
      low = low.cwiseMin(places_.col(i));
      high = high.cwiseMax(places_.col(i));
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  const SymmetricPattern& pattern_;
  const Eigen::Matrix3Xf& places_;
  PacedCheck pace_;
  std::vector<std::uint32_t> side_; // number of the half that an unknown was put into last
  std::uint32_t sides_ = 0;
};

} // namespace

std::vector<std::uint32_t> dissectionOrder(const SymmetricPattern& pattern,
                                           const Eigen::Matrix3Xf& places,
                                           const Progress& progress) {
  std::vector<std::uint32_t> order(pattern.size());
  std::iota(order.begin(), order.end(), 0U);
  Dissection(pattern, places, progress).split(order);
  return order;
}

SparseLdlt::SparseLdlt(const SymmetricPattern& pattern, std::vector<std::uint32_t> order,
                       const Progress& progress)
    : pattern_(pattern), order_(std::move(order)), place_(order_.size()),
      parent_(order_.size(), none), begin_(order_.size() + 1, 0), diagonal_(order_.size()),
      met_(order_.size(), none), path_(order_.size()) {
  PacedCheck pace(progress);
  const auto size = static_cast<std::uint32_t>(order_.size());
  for (std::uint32_t k = 0; k < size; ++k)
    place_[order_[k]] = k;
  for (std::uint32_t k = 0; k < size; ++k) {
    met_[k] = k;
    const std::uint32_t row = order_[k];
    for (std::size_t p = pattern.begin[row]; p < pattern.begin[row + 1]; ++p) {
      pace.after(1);
      for (std::uint32_t i = place_[pattern.columns[p]]; i < k && met_[i] != k; i = parent_[i]) {
        pace.after(1);
        if (parent_[i] == none) parent_[i] = k;
        ++begin_[i + 1];
        met_[i] = k;
      }
    }
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  rows_.resize(static_cast<Eigen::Index>(begin_.back()));
  values_.resize(static_cast<Eigen::Index>(begin_.back()));
}

/// Collects the columns that row k of L has entries in, so that each comes before those that it
/// adds to. @return where they begin in path_
std::size_t SparseLdlt::pathOf(std::uint32_t k) {
  std::size_t top = path_.size();
  met_[k] = k;
  const std::uint32_t row = order_[k];
  for (std::size_t p = pattern_.begin[row]; p < pattern_.begin[row + 1]; ++p) {
    std::size_t length = 0;
    for (std::uint32_t i = place_[pattern_.columns[p]]; i < k && met_[i] != k; i = parent_[i]) {
      path_[length++] = i;
      met_[i] = k;
    }
    while (length > 0)
      path_[--top] = path_[--length];
  }
  return top;
}

void SparseLdlt::factor(const Eigen::VectorXd& values, const Progress& progress) {
  PacedCheck pace(progress);
  const auto size = static_cast<std::uint32_t>(order_.size());
  std::vector<double> row(size, 0);
  std::uint32_t* const rows = rows_.data();
  double* const entries = values_.data();
  filled_.assign(begin_.begin(), begin_.end() - 1);
  std::ranges::fill(met_, none);
  for (std::uint32_t k = 0; k < size; ++k) {
    if (k % 16 == 0) progress.update(k / static_cast<double>(size));
    const std::uint32_t unknown = order_[k];
    for (std::size_t p = pattern_.begin[unknown]; p < pattern_.begin[unknown + 1]; ++p)
      if (const std::uint32_t i = place_[pattern_.columns[p]]; i <= k)
        row[i] += values[static_cast<Eigen::Index>(p)];
    double pivot = row[k];
    row[k] = 0;
    for (std::size_t top = pathOf(k); top < path_.size(); ++top) {
      const std::uint32_t i = path_[top];
      const double value = row[i];
      row[i] = 0;
      const std::size_t end = filled_[i]++;
      pace.after(end - begin_[i]);
      for (std::size_t p = begin_[i]; p < end; ++p)
        row[rows[p]] -= entries[p] * value;
      const double entry = value / diagonal_[i];
      pivot -= entry * value;
      rows[end] = k;
      entries[end] = entry;
    }
    diagonal_[k] = std::max(pivot, std::numeric_limits<double>::min()); // rounding
  }
  progress.update(1);
}

Eigen::MatrixX3d SparseLdlt::solve(const Eigen::MatrixX3d& right, const Progress& progress) const {
  PacedCheck pace(progress);
  const auto size = static_cast<std::uint32_t>(order_.size());
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> x(size, 3);
  for (std::uint32_t k = 0; k < size; ++k)
    x.row(k) = right.row(order_[k]);
  const std::uint32_t* const rows = rows_.data();
  const double* const entries = values_.data();
  for (std::uint32_t k = 0; k < size; ++k) {
    pace.after(begin_[k + 1] - begin_[k]);
    for (std::size_t p = begin_[k]; p < begin_[k + 1]; ++p)
      x.row(rows[p]) -= entries[p] * x.row(k);
  }
  for (std::uint32_t k = size; k-- > 0;) {
    pace.after(begin_[k + 1] - begin_[k]);
    x.row(k) /= diagonal_[k];
    for (std::size_t p = begin_[k]; p < begin_[k + 1]; ++p)
      x.row(k) -= entries[p] * x.row(rows[p]);
  }
  Eigen::MatrixX3d result(size, 3);
  for (std::uint32_t k = 0; k < size; ++k)
    result.row(order_[k]) = x.row(k);
  return result;
}

} // namespace espalier
