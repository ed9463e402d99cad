#include "core/base/text.h"

#include "core/base/error.h"
#include "core/base/printable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>

namespace espalier {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

/// What a number too small or too large for a double rounds to.
double rounded(std::string_view text) {
  const double magnitude = [&] {
    const std::size_t exponent = text.find_first_of("eE");
    const bool isSmall = exponent == std::string_view::npos
                             ? text.find('.') < 3 // "0." or "-0.": any other would be large
                             : text.substr(exponent + 1).starts_with('-');
    return isSmall ? 0.0 : std::numeric_limits<double>::infinity();
  }();
  return text.starts_with('-') ? -magnitude : magnitude;
}

} // namespace

std::optional<double> numberIn(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? rounded(text) : value;
}

double finiteNumber(std::string_view field, std::string_view name, const FilePlace& where) {
  const auto number = numberIn(field);
  if (!number || !std::isfinite(*number))
    throw ShownError({Shown::tr("expected a number as %1, found %2"),
                      {std::string(name), inQuotes(field)},
                      where});
  return *number;
}

std::string plainDecimal(double value) {
  std::array<char, 1100> buffer{}; // the smallest double has 1074 places
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  return {buffer.data(), result.ptr};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view nextWord(std::string_view& rest) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  std::size_t start = 0;
  while (start < rest.size() && isBlank(rest[start]))
    ++start;
  std::size_t end = start;
  while (end < rest.size() && !isBlank(rest[end]))
    ++end;
  const std::string_view word = rest.substr(start, end - start);
  rest.remove_prefix(end);
  return word;
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t longest = 40; // bytes, but for the rest of a sign
  std::size_t end = std::min(longest, text.size());
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80 &&
         end < longest + 3)
    ++end;
  return "'" + printable(text.substr(0, end)) + (text.size() > end ? "...'" : "'");
}

std::string readAll(std::istream& in, const Progress& progress) {
  constexpr std::size_t block = std::size_t{1} << 24;
  const std::istream::pos_type start = in.tellg();
  std::size_t expected = 0; // a pipe does not know
  if (start != std::istream::pos_type(-1) && in.seekg(0, std::ios::end)) {
    expected = static_cast<std::size_t>(in.tellg() - start);
    in.seekg(start);
  }
  in.clear();
  std::string bytes;
  bytes.reserve(expected + 1);
  for (std::size_t size = 0; in; size += static_cast<std::size_t>(in.gcount())) {
    const std::size_t left = expected > size ? expected - size : 1; // 1: to meet the end
    bytes.resize(size + (expected > 0 ? std::min(left, block) : block));
    in.read(bytes.data() + size, static_cast<std::streamsize>(bytes.size() - size));
    bytes.resize(size + static_cast<std::size_t>(in.gcount()));
    if (expected > 0)
      progress.update(
          std::min(1.0, static_cast<double>(bytes.size()) / static_cast<double>(expected)));
    else
      progress.check();
  }
  return bytes;
}

LineReader::LineReader(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) offset_ = 3;
}

std::optional<std::string_view> LineReader::next() {
  if (offset_ >= text_.size()) return std::nullopt;
  const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
  std::string_view line = text_.substr(offset_, end - offset_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  offset_ = std::min(end + 1, text_.size());
  ++number_;
  return line;
}

} // namespace espalier
