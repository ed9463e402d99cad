#include "tests/core/io/points/range_encoder.h"

#include "core/io/points/integer_decoder.h"
#include "core/io/points/range_decoder.h"

#include <algorithm>
#include <bit>

namespace espalier::test {

void RangeEncoder::narrow(std::uint32_t start, std::uint32_t length) {
  const std::uint32_t before = base_;
  base_ += start;
  if (base_ < before) { // carry into what is written
    std::size_t at = bytes_.size() - 1;
    for (; static_cast<std::uint8_t>(bytes_[at]) == 0xff; --at)
      bytes_[at] = 0;
    ++bytes_[at];
  }
  length_ = length;
  while (length_ < RangeDecoder::smallestLength) {
    bytes_ += static_cast<char>(base_ >> 24);
    base_ <<= 8;
    length_ <<= 8;
  }
}

void RangeEncoder::bit(BitModel& model, bool value) {
  const std::uint32_t zeros = model.zeroShare() * (length_ >> BitModel::shareBits);
  if (value)
    narrow(zeros, length_ - zeros);
  else
    narrow(0, zeros);
  model.learn(value);
}

void RangeEncoder::symbol(SymbolModel& model, std::uint32_t value) {
  const std::uint32_t unit = length_ >> SymbolModel::shareBits;
  const std::uint32_t start = model.start(value) * unit;
  const bool isLast = value + 1 == model.size();
  narrow(start, (isLast ? length_ : model.start(value + 1) * unit) - start);
  model.learn(value);
}

void RangeEncoder::bits(std::uint32_t count, std::uint32_t value) {
  if (count > 19) {
    bits(16, value & 0xffff);
    bits(count - 16, value >> 16);
    return;
  }
  const std::uint32_t unit = length_ >> count;
  narrow(value * unit, unit);
}

std::string RangeEncoder::finish() && {
  constexpr std::uint32_t least = RangeDecoder::smallestLength;
  const bool isWide = length_ > 2 * least;
  narrow(isWide ? least : least / 2, isWide ? least >> 1 : least >> 9);
  return bytes_ + std::string(isWide ? 3 : 2, '\0');
}

IntegerEncoder::IntegerEncoder(std::uint32_t bits, std::size_t contexts)
    : bits_(bits), sizes_(contexts, bits + 1), differences_(bits + 1) {}

void IntegerEncoder::next(RangeEncoder& out, std::int32_t prediction, std::int32_t value,
                          std::size_t context) {
  const std::uint32_t unused = 32 - bits_; // a shift there and back extends the sign
  const std::int32_t difference =
      static_cast<std::int32_t>(
          (static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(prediction)) << unused) >>
      unused;
  const auto pattern = static_cast<std::uint32_t>(difference);
  const std::uint32_t k =
      static_cast<std::uint32_t>(std::bit_width(difference <= 0 ? 0U - pattern : pattern - 1));
  differenceBits_ = k;
  out.symbol(sizes_[context], k);
  if (k == 0) out.bit(zeroOrOne_, difference == 1);
  if (k == 0 || k == 32) return;
  const std::uint32_t place = difference < 0 ? pattern + ((1U << k) - 1) : pattern - 1;
  std::optional<SymbolModel>& model = differences_[k];
  if (!model) model.emplace(1U << std::min(k, IntegerDecoder::modeledBits));
  if (k <= IntegerDecoder::modeledBits) {
    out.symbol(*model, place);
    return;
  }
  const std::uint32_t plain = k - IntegerDecoder::modeledBits;
  out.symbol(*model, place >> plain);
  out.bits(plain, place & ((1U << plain) - 1));
}

} // namespace espalier::test
