#include "core/mtg/mtg_comments.h"

#include "core/base/text.h"
#include "core/mtg/mtg_lines.h"

#include <algorithm>

namespace espalier {
namespace {

/// Without the signs that part it from what is read.
std::string_view withoutSigns(std::string_view comment) {
  comment = trimmed(comment);
  if (comment.starts_with("(#")) comment.remove_prefix(2);
  if (comment.ends_with("#)")) comment.remove_suffix(2);
  while (!comment.empty() && (comment.front() == '#' || comment.front() == ';'))
    comment.remove_prefix(1);
  return trimmed(comment);
}

/// "at N12: " or "before N12: ", for what stands at `at`; nothing above the vertices and behind the
/// last.
std::string placeOf(std::size_t at, const ParsedMtg& file) {
  const auto line = std::ranges::lower_bound(file.lines, at, {}, &MtgLine::end);
  if (at < file.start || line == file.lines.end()) return "";
  const std::string label = mtgLabel(file.mtg.vertices[indexOf(line->last)]);
  return (line->start <= at ? "at " : "before ") + label + ": ";
}

} // namespace

std::string mtgCommentLines(const ParsedMtg& file, std::size_t from, std::size_t to) {
  const auto& [original, text, isLatin1, notes] = file.source;
  std::string lines;
  for (std::size_t start = text.find(' ', from); start < std::min(text.size(), to);) {
    const std::size_t end = std::min(text.find_first_not_of(' ', start), text.size());
    // Comments are blank there, and no line end is in a blank.
    const std::string_view whole = std::string_view(original).substr(start, end - start);
    const std::string_view comment = withoutSigns(whole);
    if (!comment.empty()) lines += "# " + placeOf(start, file) + std::string(comment) + '\n';
    start = text.find(' ', end);
  }
  return lines;
}

} // namespace espalier
