#include "core/io/plantgl/pickle_text.h"

#include <array>
#include <charconv>
#include <string_view>

namespace espalier {
namespace {

struct Opcode {
  std::uint8_t code;
  std::string_view name;
};

constexpr auto opcodes = std::to_array<Opcode>({{'(', "MARK"},
                                                {'.', "STOP"},
                                                {'0', "POP"},
                                                {'1', "POP_MARK"},
                                                {'2', "DUP"},
                                                {'F', "FLOAT"},
                                                {'I', "INT"},
                                                {'J', "BININT"},
                                                {'K', "BININT1"},
                                                {'L', "LONG"},
                                                {'M', "BININT2"},
                                                {'N', "NONE"},
                                                {'P', "PERSID"},
                                                {'Q', "BINPERSID"},
                                                {'R', "REDUCE"},
                                                {'S', "STRING"},
                                                {'T', "BINSTRING"},
                                                {'U', "SHORT_BINSTRING"},
                                                {'V', "UNICODE"},
                                                {'X', "BINUNICODE"},
                                                {'a', "APPEND"},
                                                {'b', "BUILD"},
                                                {'c', "GLOBAL"},
                                                {'d', "DICT"},
                                                {'}', "EMPTY_DICT"},
                                                {'e', "APPENDS"},
                                                {'g', "GET"},
                                                {'h', "BINGET"},
                                                {'i', "INST"},
                                                {'j', "LONG_BINGET"},
                                                {'l', "LIST"},
                                                {']', "EMPTY_LIST"},
                                                {'o', "OBJ"},
                                                {'p', "PUT"},
                                                {'q', "BINPUT"},
                                                {'r', "LONG_BINPUT"},
                                                {'s', "SETITEM"},
                                                {'t', "TUPLE"},
                                                {')', "EMPTY_TUPLE"},
                                                {'u', "SETITEMS"},
                                                {'G', "BINFLOAT"},
                                                {'B', "BINBYTES"},
                                                {'C', "SHORT_BINBYTES"},
                                                {0x80, "PROTO"},
                                                {0x81, "NEWOBJ"},
                                                {0x82, "EXT1"},
                                                {0x83, "EXT2"},
                                                {0x84, "EXT4"},
                                                {0x85, "TUPLE1"},
                                                {0x86, "TUPLE2"},
                                                {0x87, "TUPLE3"},
                                                {0x88, "NEWTRUE"},
                                                {0x89, "NEWFALSE"},
                                                {0x8a, "LONG1"},
                                                {0x8b, "LONG4"},
                                                {0x8c, "SHORT_BINUNICODE"},
                                                {0x8d, "BINUNICODE8"},
                                                {0x8e, "BINBYTES8"},
                                                {0x8f, "EMPTY_SET"},
                                                {0x90, "ADDITEMS"},
                                                {0x91, "FROZENSET"},
                                                {0x92, "NEWOBJ_EX"},
                                                {0x93, "STACK_GLOBAL"},
                                                {0x94, "MEMOIZE"},
                                                {0x95, "FRAME"},
                                                {0x96, "BYTEARRAY8"},
                                                {0x97, "NEXT_BUFFER"},
                                                {0x98, "READONLY_BUFFER"}});

void appendUtf8(std::string& text, std::uint32_t code) {
  const auto append = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return append(code);
  if (code < 0x800) {
    append(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      append(0xe0 | code >> 12);
    } else {
      append(0xf0 | (code >> 18 & 7));
      append(0x80 | (code >> 12 & 0x3f));
    }
    append(0x80 | (code >> 6 & 0x3f));
  }
  append(0x80 | (code & 0x3f));
}

/// The number that these hexadecimal digits are; none if not all are.
std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
  std::uint32_t value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.empty() || result.ec != std::errc() || result.ptr != digits.data() + digits.size())
    return std::nullopt;
  return value;
}

/// What stands behind a backslash, which is taken off `rest`; none if Python has no such escape.
std::optional<char> escaped(std::string_view& rest) {
  if (rest.empty()) return std::nullopt;
  const char c = rest.front();
  rest.remove_prefix(1);
  switch (c) {
  case 'n':
    return '\n';
  case 'r':
    return '\r';
  case 't':
    return '\t';
  case '\\':
  case '\'':
  case '"':
    return c;
  case 'x': {
    if (rest.size() < 2) return std::nullopt;
    const auto value = hexadecimal(rest.substr(0, 2));
    rest.remove_prefix(2);
    return value ? std::optional(static_cast<char>(*value)) : std::nullopt;
  }
  default:
    return std::nullopt;
  }
}

} // namespace

std::string nameOfPickleOpcode(std::uint8_t opcode) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "0x";
  text += digits[opcode >> 4];
  text += digits[opcode & 15];
  for (const Opcode& known : opcodes)
    if (known.code == opcode) text += " " + std::string(known.name);
  return text;
}

std::optional<std::int64_t> integerInPickle(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.ends_with('L')) line.remove_suffix(1);
  std::int64_t value = 0;
  const auto result = std::from_chars(line.data(), line.data() + line.size(), value);
  if (line.empty() || result.ec != std::errc() || result.ptr != line.data() + line.size())
    return std::nullopt;
  return value;
}

std::optional<std::string> textOfQuoted(std::string_view literal) {
  if (literal.ends_with('\r')) literal.remove_suffix(1);
  if (literal.size() < 2 || literal.front() != literal.back() ||
      (literal.front() != '\'' && literal.front() != '"'))
    return std::nullopt;
  std::string_view rest = literal.substr(1, literal.size() - 2);
  std::string text;
  while (!rest.empty()) {
    const char c = rest.front();
    rest.remove_prefix(1);
    if (c != '\\') {
      text += c;
      continue;
    }
    const auto meant = escaped(rest);
    if (!meant) return std::nullopt;
    text += *meant;
  }
  return text;
}

std::string textOfRawUnicode(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool isEscape = line[i] == '\\' && i + 1 < line.size();
    const std::size_t digits = !isEscape ? 0 : line[i + 1] == 'u' ? 4 : line[i + 1] == 'U' ? 8 : 0;
    const auto code = digits > 0 && i + 2 + digits <= line.size()
                          ? hexadecimal(line.substr(i + 2, digits))
                          : std::nullopt;
    appendUtf8(text, code ? *code : static_cast<std::uint8_t>(line[i]));
    if (code) i += 1 + digits;
  }
  return text;
}

} // namespace espalier
