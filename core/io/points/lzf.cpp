#include "core/io/points/lzf.h"

#include <liblzf/lzf.h>
#include <limits>

namespace espalier {

std::optional<std::string> unpackedLzf(std::string_view packed, std::size_t size) {
  constexpr std::size_t longestCopy = 264; // from 3 bytes
  constexpr std::size_t most = std::numeric_limits<unsigned>::max();
  if (size / longestCopy > packed.size() || size > most || packed.size() > most)
    return std::nullopt;
  std::string bytes(size, '\0');
  if (packed.empty()) return size == 0 ? std::optional(bytes) : std::nullopt; // liblzf needs a byte
  const unsigned unpacked = lzf_decompress(packed.data(), static_cast<unsigned>(packed.size()),
                                           bytes.data(), static_cast<unsigned>(size));
  if (unpacked == 0 || unpacked != size) return std::nullopt; // 0: the data is damaged
  return bytes;
}

} // namespace espalier
