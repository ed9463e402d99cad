#include "core/io/lzf.h"

#include <cstdint>

namespace espalier {

// A control byte below 32 is followed by that many bytes, and one more, to be taken as they are.
// Any other is a copy of bytes already unpacked: its upper 3 bits are the length less 2, where 7
// adds a byte to it; its lower 5 bits and the byte after are how far back to begin, less 1.
std::optional<std::string> unpackedLzf(std::string_view packed, std::size_t size) {
  constexpr std::size_t longestCopy = 264; // from 3 bytes
  if (size / longestCopy > packed.size()) return std::nullopt;
  std::string bytes;
  bytes.reserve(size);
  std::size_t at = 0;
  const auto next = [&]() -> std::size_t { return static_cast<std::uint8_t>(packed[at++]); };
  while (at < packed.size()) {
    const std::size_t control = next();
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > packed.size() - at || length > size - bytes.size()) return std::nullopt;
      bytes.append(packed.substr(at, length));
      at += length;
      continue;
    }
    std::size_t length = (control >> 5) + 2;
    const std::size_t more = length == 9 ? 2 : 1;
    if (packed.size() - at < more) return std::nullopt;
    if (length == 9) length += next();
    const std::size_t distance = ((control & 31) << 8) + next() + 1;
    if (distance > bytes.size() || length > size - bytes.size()) return std::nullopt;
    for (std::size_t i = 0; i < length; ++i)
      bytes.push_back(bytes[bytes.size() - distance]);
  }
  if (bytes.size() != size) return std::nullopt;
  return bytes;
}

} // namespace espalier
