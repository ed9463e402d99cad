#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace espalier {

/// "0x80 PROTO", for messages: the name of an opcode of pickles as pickletools has it, or its
/// number alone.
[[nodiscard]] std::string nameOfPickleOpcode(std::uint8_t opcode);

/// The integer that a line of a pickle of protocol 0 is, with or without an "L" behind it. None for
/// anything else, and beyond 64 bits.
[[nodiscard]] std::optional<std::int64_t> integerInPickle(std::string_view line);

/// The text that a literal of Python stands for, in single or double quotes, with \\ \' \" \n \r
/// \t and \xNN. None if it is none.
[[nodiscard]] std::optional<std::string> textOfQuoted(std::string_view literal);

/// UTF-8 of a line in Python's "raw-unicode-escape": Latin-1, and \uNNNN or \UNNNNNNNN.
[[nodiscard]] std::string textOfRawUnicode(std::string_view line);

} // namespace espalier
