#include "core/base/printable.h"

#include <cstdint>

namespace espalier {
namespace {

std::uint32_t byteAt(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

/// How long a sign is that begins with this byte; 0: none does.
std::size_t lengthBehind(std::uint32_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

/// The number of a sign in Unicode. pre: its bytes are there
std::uint32_t codeOf(std::string_view sign) {
  if (sign.size() == 1) return byteAt(sign, 0);
  std::uint32_t code = byteAt(sign, 0) & (0xffU >> (sign.size() + 1));
  for (std::size_t i = 1; i < sign.size(); ++i)
    code = code << 6 | (byteAt(sign, i) & 0x3f);
  return code;
}

/// Whether a sign moves the cursor, breaks the line or turns the direction of the text.
bool steers(std::uint32_t code) {
  const bool isControl = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool breaks = code == 0x2028 || code == 0x2029;
  const bool turns = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return isControl || breaks || turns;
}

/// How many bytes of the front of `text` are one sign in UTF-8; 0 if they are none.
std::size_t utf8Sign(std::string_view text) {
  if (text.empty()) return 0;
  const std::size_t length = lengthBehind(byteAt(text, 0));
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byteAt(text, i) & 0xc0) != 0x80) return 0;
  const std::uint32_t code = codeOf(text.substr(0, length));
  const bool isTooLong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool isHalf = code >= 0xd800 && code < 0xe000; // of a pair in UTF-16
  return isTooLong || isHalf || code > 0x10ffff ? 0 : length;
}

} // namespace

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8Sign(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8Sign(text);
    if (length == 0 || steers(codeOf(text.substr(0, length))))
      result += '?';
    else
      result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

} // namespace espalier
