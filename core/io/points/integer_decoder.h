#pragma once

#include "core/io/points/adaptive_models.h"
#include "core/io/points/range_decoder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// Decoder of whole numbers, each coded as its difference from a prediction.
///
/// First comes how many bits the difference has, by a model of the context, then the difference.
class IntegerDecoder {
public:
  static constexpr std::uint32_t modeledBits = 8; // of a difference; lower ones have no model

  /// @param bits  of the numbers: with fewer than 32 they are within [0, 2^bits)
  IntegerDecoder(std::uint32_t bits, std::size_t contexts);

  [[nodiscard]] std::int32_t next(RangeDecoder& in, std::int32_t prediction,
                                  std::size_t context = 0);
  /// How many bits the last difference had.
  [[nodiscard]] std::uint32_t differenceBits() const { return differenceBits_; }

private:
  [[nodiscard]] std::uint32_t difference(RangeDecoder& in, std::size_t context);

  std::uint32_t bits_;
  std::uint32_t differenceBits_ = 0;
  SymbolModels sizes_;
  BitModel zeroOrOne_;
  std::vector<std::optional<SymbolModel>> differences_; // by their bits
};

} // namespace espalier
