#include "ui/document/binned_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace espalier {
namespace {

constexpr double shownShare = 0.995; // of the values, if the others lie far beyond
constexpr float farBeyond = 0.1F;    // of the range of those shown

/// Values that are numbers, and their extent.
struct Finite {
  std::vector<float> values;
  float least = std::numeric_limits<float>::infinity();
  float greatest = -std::numeric_limits<float>::infinity();
};

Finite finiteOf(std::span<const float> values) {
  Finite finite{.values = std::vector<float>(values.size())};
  std::size_t count = 0;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    finite.values[count++] = value;
    finite.least = std::min(finite.least, value);
    finite.greatest = std::max(finite.greatest, value);
  }
  finite.values.resize(count);
  return finite;
}

/// The value at a place of the sorted values: as std::nth_element, but faster for many of them,
/// since each pass leaves only those of one narrow range. pre: place < finite.values.size()
float valueAt(const Finite& finite, std::size_t place) {
  constexpr std::size_t few = 4096;
  std::array<std::size_t, 1024> counts{};
  if (finite.least == finite.greatest) return finite.least;
  const double from = finite.least;
  const double perUnit = (counts.size() - 1) / (finite.greatest - from);
  const auto rangeOf = [&](float value) {
    return static_cast<std::size_t>((value - from) * perUnit);
  };
  for (const float value : finite.values)
    ++counts[rangeOf(value)];
  std::size_t kept = 0;
  for (; place >= counts[kept]; ++kept)
    place -= counts[kept];
  std::vector<float> near;
  near.reserve(counts[kept]);
  std::ranges::copy_if(finite.values, std::back_inserter(near),
                       [&](float value) { return rangeOf(value) == kept; });
  if (near.size() > few) return valueAt(finiteOf(near), place);
  const auto found = near.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(near, found);
  return *found;
}

/// The range that shows nearly all values well. pre: there is one
std::pair<double, double> rangeOf(const Finite& finite) {
  const auto& [values, least, greatest] = finite;
  const auto last = static_cast<std::size_t>(shownShare * static_cast<double>(values.size()));
  const float percentile = valueAt(finite, std::min(last, values.size() - 1));
  const bool isFar = greatest - percentile > farBeyond * (percentile - least);
  return {least, isFar && percentile > least ? percentile : greatest};
}

/// A range has some width, even that of a single value.
std::pair<double, double> widened(std::pair<double, double> range) {
  const auto [from, to] = range;
  if (to > from) return range;
  const double half = from == 0 ? 0.5 : std::abs(from) / 20;
  return {from - half, from + half};
}

/// pre: from < to
BinnedValues counted(const Finite& finite, double from, double to, std::size_t count) {
  const std::vector<float>& values = finite.values;
  BinnedValues bins{
      .from = from, .to = to, .counts = std::vector<std::size_t>(count), .total = values.size()};
  if (!values.empty()) {
    bins.least = finite.least;
    bins.greatest = finite.greatest;
  }
  const double perUnit = 1 / bins.width();
  for (const double value : values) {
    if (value < from)
      ++bins.below;
    else if (value > to)
      ++bins.above;
    else
      ++bins.counts[std::min(static_cast<std::size_t>((value - from) * perUnit), count - 1)];
  }
  return bins;
}

} // namespace

BinnedValues binned(std::span<const float> values,
                    const std::optional<std::pair<double, double>>& range) {
  const Finite finite = finiteOf(values);
  BinnedValues bins;
  if (!finite.values.empty()) {
    const auto [from, to] = widened(range ? *range : rangeOf(finite));
    bins = counted(finite, from, to, binsFor(finite.values.size()));
  }
  bins.missing = values.size() - finite.values.size();
  return bins;
}

BinnedValues binnedAs(const BinnedValues& bins, std::span<const float> values) {
  const Finite finite = finiteOf(values);
  BinnedValues others = counted(finite, bins.from, bins.to, bins.counts.size());
  others.missing = values.size() - finite.values.size();
  return others;
}

std::size_t binsFor(std::size_t values) {
  constexpr std::size_t most = 80;
  return std::clamp<std::size_t>(
      static_cast<std::size_t>(std::ceil(2 * std::cbrt(static_cast<double>(values)))), 10, most);
}

} // namespace espalier
