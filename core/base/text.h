#pragma once

#include "core/base/progress.h"
#include "core/base/shown_message.h"

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// The number that `text` is, all of it: "12", "+1.5", "-3e-4", "nan", "inf". The decimal sign is a
/// point whatever the locale. None for anything else, an empty text too.
[[nodiscard]] std::optional<double> numberIn(std::string_view text);

/// The number that a field is.
/// @param name   of the field, @param where  it is, for the message
/// @throws ShownError if it is no number, or not finite
[[nodiscard]] double finiteNumber(std::string_view field, std::string_view name,
                                  const FilePlace& where);

/// The shortest decimal that reads back as the same double, never with an exponent.
/// pre: value is finite
[[nodiscard]] std::string plainDecimal(double value);

/// `text` without blanks, tabs and line ends around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Takes the next word off the front of `rest`; empty when there is none. Words are parted by
/// blanks and tabs.
[[nodiscard]] std::string_view nextWord(std::string_view& rest);

[[nodiscard]] constexpr bool isLetter(char c) { // A to Z, a to z
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// `text` with the letters A to Z made small.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// `text` in quotes for a message: on one line, printable, and not too long.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// All bytes from here to the end of the stream.
[[nodiscard]] std::string readAll(std::istream& in, const Progress& progress = {});

/// A text, line by line, without a copy. Lines end with "\n" or "\r\n"; a byte order mark of UTF-8
/// is passed over.
class LineReader {
public:
  explicit LineReader(std::string_view text); // `text` must outlive the reader

  /// The next line without its end; none after the last.
  [[nodiscard]] std::optional<std::string_view> next();

  [[nodiscard]] std::size_t number() const { return number_; } // of the line last read, from 1
  [[nodiscard]] std::size_t offset() const { return offset_; } // bytes read so far

private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
};

} // namespace espalier
