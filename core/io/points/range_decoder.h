#pragma once

#include "core/io/points/adaptive_models.h"

#include <cstdint>
#include <string_view>

namespace espalier {

/// Thrown where bytes cannot be what an encoder wrote. The reader of the file makes an Error of it.
struct DamagedStream {};

/// Decoder of an arithmetic code with 32 bits, as LASzip writes it.
///
/// Source: A. Said, "Introduction to Arithmetic Coding - Theory and Practice", HPL-2004-76, 2004.
class RangeDecoder {
public:
  static constexpr std::uint32_t smallestLength = 1U << 24;

  /// @param bytes  must outlive the decoder
  /// @throws DamagedStream here and from all else, if the bytes end early or make no sense
  explicit RangeDecoder(std::string_view bytes);

  [[nodiscard]] bool bit(BitModel& model);
  [[nodiscard]] std::uint32_t symbol(SymbolModel& model);
  [[nodiscard]] std::uint32_t bits(std::uint32_t count); // of no model; pre: 1 <= count <= 32

private:
  [[nodiscard]] std::uint32_t fewBits(std::uint32_t count); // pre: 1 <= count <= 19
  void renormalize();

  std::string_view rest_;
  std::uint32_t value_ = 0; // < length_
  std::uint32_t length_ = 0xffffffff;
};

} // namespace espalier
