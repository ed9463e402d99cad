#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace espalier {

/// How often values are found in ranges of equal width, and outside all of them.
struct BinnedValues {
  double from = 0; // of the first bin
  double to = 0;   // of the last, which includes it
  std::vector<std::size_t> counts;
  std::size_t below = 0;
  std::size_t above = 0;
  double least = 0; // of all values
  double greatest = 0;
  std::size_t total = 0;   // finite values
  std::size_t missing = 0; // which are none, and are in nothing else

  [[nodiscard]] bool isEmpty() const { return counts.empty(); }
  /// pre: !isEmpty()
  [[nodiscard]] double width() const { return (to - from) / static_cast<double>(counts.size()); }
};

/// Counts values in bins. Without a range the bins go from the least value to the greatest or, if
/// few values lie far beyond the others, to the 99.5th percentile. Empty if no value is finite.
[[nodiscard]] BinnedValues binned(std::span<const float> values,
                                  const std::optional<std::pair<double, double>>& range = {});

/// Counts other values in the same bins, so that both can be compared. pre: !bins.isEmpty()
[[nodiscard]] BinnedValues binnedAs(const BinnedValues& bins, std::span<const float> values);

/// As many bins as Rice's rule gives for so many values, within what a small plot can show.
[[nodiscard]] std::size_t binsFor(std::size_t values);

} // namespace espalier
