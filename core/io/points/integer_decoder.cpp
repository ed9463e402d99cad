#include "core/io/points/integer_decoder.h"

#include <algorithm>

namespace espalier {

IntegerDecoder::IntegerDecoder(std::uint32_t bits, std::size_t contexts)
    : bits_(bits), sizes_(contexts, bits + 1), differences_(bits + 1) {}

std::int32_t IntegerDecoder::next(RangeDecoder& in, std::int32_t prediction, std::size_t context) {
  const std::uint32_t number =
      static_cast<std::uint32_t>(prediction) + difference(in, context); // may wrap around
  if (bits_ == 32) return static_cast<std::int32_t>(number);
  return static_cast<std::int32_t>(number & ((1U << bits_) - 1));
}

/// Of k bits, above 0, are the differences from -(2^k - 1) to -2^(k-1), and from 2^(k-1) + 1 to
/// 2^k.
std::uint32_t IntegerDecoder::difference(RangeDecoder& in, std::size_t context) {
  const std::uint32_t k = in.symbol(sizes_[context]);
  differenceBits_ = k;
  if (k == 0) return in.bit(zeroOrOne_) ? 1 : 0;
  if (k == 32) return 1U << 31;
  std::optional<SymbolModel>& model = differences_[k];
  if (!model) model.emplace(1U << std::min(k, modeledBits));
  std::uint32_t place = in.symbol(*model);
  if (k > modeledBits) place = place << (k - modeledBits) | in.bits(k - modeledBits);
  return place >> (k - 1) != 0 ? place + 1 : place - ((1U << k) - 1);
}

} // namespace espalier
