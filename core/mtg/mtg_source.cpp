#include "core/mtg/mtg_source.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace espalier {
namespace {

bool isContinuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The bytes of the UTF-8 character that begins `text`; 0 if none does.
std::size_t lengthOfCharacter(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length == 0 || first > 0xF4 || text.size() < length) return 0;
  if (!std::ranges::all_of(text.substr(1, length - 1), isContinuation)) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool isValid = (first != 0xE0 || second >= 0xA0) && (first != 0xED || second < 0xA0) &&
                       (first != 0xF0 || second >= 0x90) && (first != 0xF4 || second < 0x90);
  return isValid ? length : 0;
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = lengthOfCharacter(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string fromLatin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0U | (byte >> 6U));
      text += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return text;
}

/// Whether a comment up to the next tab begins at `at`.
bool beginsComment(std::string_view text, std::size_t at) {
  if (text[at] == '#') return true;
  return text[at] == ';' &&
         (at == 0 || text[at - 1] == '\t' || text[at - 1] == '\n' || text[at - 1] == ' ');
}

bool beginsField(std::string_view text, std::size_t at) {
  return at == 0 || text[at - 1] == '\t' || text[at - 1] == '\n';
}

/// Puts blanks for all but line ends in a part of `text`.
void blank(std::string& text, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i)
    if (text[i] != '\n' && text[i] != '\r') text[i] = ' ';
}

/// What the comments of a text held that its author should know of.
struct Comments {
  bool isOpen = false;   // (# is never closed
  std::size_t codes = 0; // lines that begin with # but hold a code behind a tab
};

/// Whether the rest of a line holds a code in a later column.
bool holdsCode(std::string_view line) {
  for (std::size_t tab = line.find('\t'); tab + 1 < line.size(); tab = line.find('\t', tab + 1)) {
    if (tab == std::string_view::npos) return false;
    if (std::string_view("/<+^*").find(line[tab + 1]) != std::string_view::npos) return true;
  }
  return false;
}

Comments blankComments(std::string& text) {
  Comments comments;
  bool& isOpen = comments.isOpen;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.compare(at, 2, "(#") == 0) {
      const std::size_t end = isOpen ? std::string::npos : text.find("#)", at + 2);
      isOpen = end == std::string::npos;
      if (!isOpen) {
        blank(text, at, end + 2);
        at = end + 1;
        continue;
      }
      text[at] = ' '; // to the next tab, as # alone
      ++at;
    }
    if (!beginsComment(text, at)) continue;
    const bool isQuoted = at > 0 && text[at - 1] == '"' && beginsField(text, at - 1);
    if (isQuoted) text[at - 1] = ' '; // Excel quotes a cell that holds a comma
    const std::size_t first = isQuoted ? at - 1 : at;
    const bool isLine = text[at] == '#' && (first == 0 || text[first - 1] == '\n');
    const std::size_t end = std::min(text.find_first_of(isLine ? "\n" : "\t\n", at), text.size());
    if (isLine && holdsCode(std::string_view(text).substr(at, end - at))) ++comments.codes;
    blank(text, at, end);
    at = end - 1;
  }
  return comments;
}

} // namespace

MtgSource mtgSource(std::string bytes) {
  MtgSource source;
  source.isLatin1 = !isUtf8(bytes);
  source.original = source.isLatin1 ? fromLatin1(bytes) : std::move(bytes);
  source.text = source.original;
  if (source.isLatin1)
    source.notes.push_back({espalier::Shown::tr("is no UTF-8 and is read as Latin-1")});
  if (source.text.find('\n') == std::string::npos) std::ranges::replace(source.text, '\r', '\n');
  const std::size_t end = source.text.find_last_not_of('\x1A');
  blank(source.text, end == std::string::npos ? 0 : end + 1, source.text.size()); // the end, in DOS
  const Comments comments = blankComments(source.text);
  if (comments.codes > 0)
    source.notes.push_back(
        {comments.codes == 1
             ? espalier::Shown::tr("1 line begins with # and holds a code: it is passed over whole")
             : espalier::Shown::tr(
                   "%1 lines begin with # and hold codes: they are passed over whole"),
         {std::to_string(comments.codes)}});
  if (comments.isOpen)
    source.notes.push_back({espalier::Shown::tr(
        "a comment (# is not closed with #); it is taken to end at the next tab or line end")});
  return source;
}

bool fitsLatin1(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0xC4; });
}

std::string toLatin1(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80 || i + 1 == text.size()) {
      bytes += text[i];
    } else {
      const auto next = static_cast<unsigned char>(text[++i]);
      bytes += static_cast<char>(((byte & 0x03U) << 6U) | (next & 0x3FU));
    }
  }
  return bytes;
}

} // namespace espalier
