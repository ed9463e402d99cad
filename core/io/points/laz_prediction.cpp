#include "core/io/points/laz_prediction.h"

#include <string_view>

namespace espalier {
namespace {

/// Byte 0 (low) or 1 (high) of a word.
int byteOfWord(std::uint16_t word, std::size_t half) {
  return word >> (8 * half) & 0xff;
}

void setByte(std::uint16_t& word, std::size_t half, std::uint32_t value) {
  word = static_cast<std::uint16_t>((word & (half == 0 ? 0xff00 : 0x00ff)) | (value & 0xff)
                                                                                 << (8 * half));
}

} // namespace

void StreamedMedian::add(std::int32_t number) {
  if (dropsLargest_) {
    dropsLargest_ = number < value();
    std::size_t at = 4;
    for (; at > 0 && number < sorted_[at - 1]; --at)
      sorted_[at] = sorted_[at - 1];
    sorted_[at] = number;
  } else {
    dropsLargest_ = number <= value();
    std::size_t at = 0;
    for (; at < 4 && sorted_[at + 1] < number; ++at)
      sorted_[at] = sorted_[at + 1];
    sorted_[at] = number;
  }
}

std::size_t returnContext(std::uint32_t returns, std::uint32_t number) {
  constexpr std::array<std::array<std::uint8_t, 8>, 8> contexts = {{
      {15, 14, 13, 12, 11, 10, 9, 8},
      {14, 0, 1, 3, 6, 10, 10, 9},
      {13, 1, 2, 4, 7, 11, 11, 10},
      {12, 3, 4, 5, 8, 12, 12, 11},
      {11, 6, 7, 8, 9, 13, 13, 12},
      {10, 10, 11, 12, 13, 14, 14, 13},
      {9, 10, 11, 12, 13, 14, 15, 14},
      {8, 9, 10, 11, 12, 13, 14, 15},
  }};
  return contexts[returns][number];
}

std::size_t layeredReturnContext(std::uint32_t returns, std::uint32_t number) {
  constexpr std::array<std::string_view, 16> contexts = {
      "0123453445555555", "1013333333333333", "2124444444433333", "3345444444444444",
      "4344544444444444", "5344454444444444", "3344445444444444", "4344444544444444",
      "4344444454444444", "5344444445444444", "5344444444544444", "5334444444455444",
      "5334444444455544", "5334444444445554", "5334444444444555", "5334444444444455"};
  return static_cast<std::size_t>(contexts[returns][number] - '0');
}

LazColor ColorDecoder::next(RangeDecoder& in, const LazColor& last) {
  constexpr std::uint32_t isNoGray = 1 << 6; // bits below it: which bytes changed
  const std::uint32_t changes = in.symbol(changes_);
  LazColor color = last;
  const auto read = [&](std::size_t channel, std::size_t half, int expected) {
    const std::size_t byte = 2 * channel + half;
    if ((changes >> byte & 1) == 0) return;
    setByte(color[channel], half,
            static_cast<std::uint32_t>(std::clamp(expected, 0, 255)) + in.symbol(bytes_[byte]));
  };
  const auto change = [&](std::size_t channel, std::size_t half) {
    return byteOfWord(color[channel], half) - byteOfWord(last[channel], half);
  };
  for (const std::size_t half : {0U, 1U})
    read(0, half, byteOfWord(last[0], half));
  if ((changes & isNoGray) == 0) return {color[0], color[0], color[0]};
  for (const std::size_t half : {0U, 1U}) {
    read(1, half, byteOfWord(last[1], half) + change(0, half));
    read(2, half, byteOfWord(last[2], half) + (change(0, half) + change(1, half)) / 2);
  }
  return color;
}

} // namespace espalier
