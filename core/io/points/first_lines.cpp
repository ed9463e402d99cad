#include "core/io/points/first_lines.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

constexpr std::uint64_t mostShown = 64 * 1024; // bytes

bool isWholeNumber(std::string_view line) {
  return line.find_first_not_of("0123456789") == std::string_view::npos;
}

TextLine partedLine(std::string_view line, std::size_t number, const XyzLayout& layout) {
  TextLine parted{.number = number, .kind = TextLine::Kind::points, .fields = {}};
  if (isComment(line))
    parted.kind = TextLine::Kind::comment;
  else if (number == layout.headerLine)
    parted.kind = TextLine::Kind::title;
  else if (isWholeNumber(line))
    parted.kind = TextLine::Kind::count;
  const bool isOne = parted.kind == TextLine::Kind::comment || parted.kind == TextLine::Kind::count;
  if (isOne) parted.fields.emplace_back(line);
  for (std::string_view rest = line; !isOne && !trimmed(rest).empty();)
    parted.fields.emplace_back(nextField(rest, layout.separator));
  return parted;
}

} // namespace

FirstLines firstLinesOf(ByteSource& source, const std::string& file, std::size_t most) {
  const XyzLayout layout = xyzLayoutOf(source, file);
  if (layout.columns.empty())
    throw ShownError(
        {Shown::tr("holds no points, a line each of at least 3 numbers"), {}, FilePlace{file}});
  FirstLines first{.lines = {},
                   .columns = layout.columns,
                   .doubt = layout.doubt,
                   .names = layout.names,
                   .hasDecimalComma = layout.hasDecimalComma};
  const std::string head = source.read(0, std::min(mostShown, source.size()));
  LineReader lines(head);
  while (first.lines.size() < most) {
    const auto next = lines.next();
    if (!next || (lines.offset() >= head.size() && head.size() < source.size())) break; // cut off
    const std::string_view line = trimmed(*next);
    if (!line.empty()) first.lines.push_back(partedLine(line, lines.number(), layout));
  }
  const auto point = std::ranges::find(first.lines, TextLine::Kind::points, &TextLine::kind);
  if (point != first.lines.end() && point->fields.size() < 3)
    throw ShownError(
        {point->fields.size() == 1
             ? Shown::tr("has 1 column, and a point has x, y and z: export it again with all three")
             : Shown::tr(
                   "has %1 columns, and a point has x, y and z: export it again with all three"),
         {std::to_string(point->fields.size())},
         FilePlace{file}});
  return first;
}

bool isPoint(const TextLine& line, const std::vector<PointField>& columns, bool hasDecimalComma) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == PointField::none) continue;
    if (i >= line.fields.size() || !numberInField(line.fields[i], hasDecimalComma)) return false;
  }
  return true;
}

} // namespace espalier
