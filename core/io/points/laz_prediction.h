#pragma once

#include "core/io/points/adaptive_models.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace espalier {

/// About the median of the last numbers: of five, from which the largest and the smallest go in
/// turn.
class StreamedMedian {
public:
  [[nodiscard]] std::int32_t value() const { return sorted_[2]; }
  void add(std::int32_t number);

private:
  std::array<std::int32_t, 5> sorted_{};
  bool dropsLargest_ = true;
};

/// The context of a difference across one axis, by the bits of those across the axes before.
/// @param most  even
[[nodiscard]] constexpr std::size_t axisContext(std::uint32_t bits, std::uint32_t most,
                                                bool isSingleReturn) {
  return std::min(bits & ~1U, most) + (isSingleReturn ? 1 : 0);
}

/// A context, below 16, of a return of this number (0 to 7) among so many of its pulse (0 to 7).
[[nodiscard]] std::size_t returnContext(std::uint32_t returns, std::uint32_t number);

/// The same, below 6, of points of formats 6 to 10, where both are up to 15.
[[nodiscard]] std::size_t layeredReturnContext(std::uint32_t returns, std::uint32_t number);

/// How many returns came after this one, up to 7.
[[nodiscard]] constexpr std::size_t returnLevel(std::uint32_t returns, std::uint32_t number) {
  return std::min(std::max(returns, number) - std::min(returns, number), 7U);
}

using LazColor = std::array<std::uint16_t, 3>;

/// Decoder of colors: their bytes by those of the color before and by how red and green changed.
class ColorDecoder {
public:
  [[nodiscard]] LazColor next(RangeDecoder& in, const LazColor& last);

private:
  SymbolModel changes_{128};
  SymbolModels bytes_{6, 256};
};

} // namespace espalier
