#pragma once

#include "core/io/bytes/scalar.h"
#include "core/io/points/adaptive_models.h"
#include "core/io/points/laz_layout.h"
#include "core/io/points/laz_prediction.h"
#include "tests/core/io/points/range_encoder.h"

#include <algorithm>
#include <string>
#include <vector>

namespace espalier::test {

// What the writer of LAZ files is made of.

/// Points that are compressed together, in the forms of formats 0 to 5 and 6 to 10. The first lies
/// there as it is. pre: there is one
[[nodiscard]] std::string pointwiseChunk(const std::vector<std::string>& points,
                                         const std::vector<LazItem>& items);
[[nodiscard]] std::string layeredChunk(const std::vector<std::string>& points,
                                       const std::vector<LazItem>& items);

inline std::uint8_t byteOf(const char* bytes) {
  return static_cast<std::uint8_t>(*bytes);
}

inline std::uint16_t wordOf(const char* bytes) {
  return valueAt<std::uint16_t>(bytes);
}

inline std::int32_t wrappedDifference(const char* now, const char* before) {
  return static_cast<std::int32_t>(valueAt<std::uint32_t>(now) - valueAt<std::uint32_t>(before));
}

/// Encodes colors as ColorDecoder reads them.
class ColorEncoder {
public:
  void next(RangeEncoder& out, const LazColor& now, const LazColor& last) {
    const auto byte = [](const LazColor& color, std::size_t channel, std::size_t half) {
      return color[channel] >> (8 * half) & 0xff;
    };
    std::uint32_t changes = now[0] == now[1] && now[0] == now[2] ? 0 : 1 << 6;
    for (std::size_t i = 0; i < 6; ++i)
      if (byte(now, i / 2, i % 2) != byte(last, i / 2, i % 2)) changes |= 1U << i;
    out.symbol(changes_, changes);
    const auto write = [&](std::size_t channel, std::size_t half, int expected) {
      const std::size_t at = 2 * channel + half;
      if ((changes >> at & 1) != 0)
        out.symbol(bytes_[at], (byte(now, channel, half) - std::clamp(expected, 0, 255)) & 0xff);
    };
    for (const std::size_t half : {0U, 1U})
      write(0, half, byte(last, 0, half));
    if ((changes & 1 << 6) == 0) return;
    for (const std::size_t half : {0U, 1U}) {
      const int red = byte(now, 0, half) - byte(last, 0, half);
      const int green = byte(now, 1, half) - byte(last, 1, half);
      write(1, half, byte(last, 1, half) + red);
      write(2, half, byte(last, 2, half) + (red + green) / 2);
    }
  }

private:
  SymbolModel changes_{128};
  SymbolModels bytes_{6, 256};
};

inline LazColor colorOf(const char* bytes) {
  return {wordOf(bytes), wordOf(bytes + 2), wordOf(bytes + 4)};
}

} // namespace espalier::test
