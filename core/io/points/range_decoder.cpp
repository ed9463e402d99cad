#include "core/io/points/range_decoder.h"

namespace espalier {

RangeDecoder::RangeDecoder(std::string_view bytes) : rest_(bytes) {
  constexpr std::size_t startBytes = 4;
  if (bytes.size() < startBytes) throw DamagedStream{};
  for (std::size_t i = 0; i < startBytes; ++i)
    value_ = value_ << 8 | static_cast<std::uint8_t>(bytes[i]);
  rest_.remove_prefix(startBytes);
  if (value_ >= length_) throw DamagedStream{};
}

bool RangeDecoder::bit(BitModel& model) {
  const std::uint32_t zeros = model.zeroShare() * (length_ >> BitModel::shareBits);
  const bool result = value_ >= zeros;
  if (result) {
    value_ -= zeros;
    length_ -= zeros;
  } else {
    length_ = zeros;
  }
  renormalize();
  model.learn(result);
  return result;
}

std::uint32_t RangeDecoder::symbol(SymbolModel& model) {
  const std::uint32_t unit = length_ >> SymbolModel::shareBits;
  const std::uint32_t result = model.symbolAt(value_ / unit);
  const std::uint32_t start = model.start(result) * unit;
  const bool isLast = result + 1 == model.size(); // has what division leaves over
  const std::uint32_t end = isLast ? length_ : model.start(result + 1) * unit;
  value_ -= start;
  length_ = end - start;
  renormalize();
  model.learn(result);
  return result;
}

std::uint32_t RangeDecoder::bits(std::uint32_t count) {
  if (count <= 19) return fewBits(count);
  const std::uint32_t low = fewBits(16);
  return fewBits(count - 16) << 16 | low;
}

std::uint32_t RangeDecoder::fewBits(std::uint32_t count) {
  length_ >>= count;
  const std::uint32_t result = value_ / length_;
  if (result >> count != 0) throw DamagedStream{};
  value_ -= result * length_;
  renormalize();
  return result;
}

void RangeDecoder::renormalize() {
  while (length_ < smallestLength) {
    if (rest_.empty()) throw DamagedStream{};
    value_ = value_ << 8 | static_cast<std::uint8_t>(rest_.front());
    length_ <<= 8;
    rest_.remove_prefix(1);
  }
}

} // namespace espalier
