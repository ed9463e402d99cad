#include "core/io/points/xyz_layout.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/points/point_collector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t sampledLines = 1000;

/// The lines that the layout is derived from.
struct Sample {
  std::vector<std::string_view> data;
  std::vector<std::string_view> comments; // before the data
  std::string_view header;                // of names, without being a comment
  std::size_t headerLine = 0;
  std::optional<std::uint64_t> count;
};

bool startsWithNumber(std::string_view line) {
  const std::string_view word = line.substr(0, line.find_first_of(" \t,;"));
  return numberIn(word).has_value();
}

Sample sampleOf(std::string_view text) {
  Sample sample;
  LineReader lines(text);
  while (sample.data.size() < sampledLines) {
    const auto next = lines.next();
    if (!next) break;
    const std::string_view line = trimmed(*next);
    if (isComment(line)) {
      if (sample.data.empty() && !line.empty()) sample.comments.push_back(line);
    } else if (sample.data.empty() && sample.header.empty() && !startsWithNumber(line)) {
      sample.header = line;
      sample.headerLine = lines.number();
    } else if (line.find_first_not_of("0123456789") == std::string_view::npos) {
      // The number of points of a PTS file, or of its next scan.
      if (sample.data.empty() && numberIn(line))
        sample.count = static_cast<std::uint64_t>(std::min(*numberIn(line), 1e18));
    } else {
      sample.data.push_back(line);
    }
  }
  return sample;
}

/// Whether blanks part the fields and commas are decimal signs: "1,5 2,25 3".
bool areDecimalCommas(std::string_view line) {
  if (line.find('.') != std::string_view::npos) return false;
  int words = 0;
  std::string_view rest = line;
  for (auto word = nextWord(rest); !word.empty(); word = nextWord(rest), ++words)
    if (word.ends_with(',') || word.starts_with(',') || std::ranges::count(word, ',') > 1)
      return false;
  return words >= 3;
}

void findSeparator(const Sample& sample, XyzLayout& layout) {
  const std::string_view line = sample.data.front();
  const auto contains = [&](char c) { return line.find(c) != std::string_view::npos; };
  if (contains(';'))
    layout.separator = ';';
  else if (contains(',') && !areDecimalCommas(line))
    layout.separator = ',';
  if (layout.separator != ',')
    layout.hasDecimalComma = std::ranges::any_of(sample.data, [](std::string_view other) {
      return other.find(',') != std::string_view::npos && other.find('.') == std::string_view::npos;
    });
}

std::vector<std::string_view> fieldsOf(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  while (!trimmed(line).empty())
    fields.push_back(nextField(line, separator));
  return fields;
}

/// A name as headers write it, without quotes, marks of a comment and unit: "//X", "\"y\"", "Z[m]".
std::string_view plainName(std::string_view name) {
  name = name.substr(0, name.find_first_of("(["));
  const std::size_t first = name.find_first_not_of("/#%! \"'");
  if (first == std::string_view::npos) return {};
  return name.substr(first, name.find_last_not_of(" \"'") - first + 1);
}

/// Columns by a line of names, if it names x, y and z and as many columns as there are.
std::vector<PointField> namedColumns(std::string_view header, char separator, std::size_t count) {
  header = header.substr(std::min(header.find_first_not_of("/#%! \t"), header.size()));
  std::vector<PointField> columns;
  std::array<bool, PointValues().size()> taken{};
  for (const std::string_view name : fieldsOf(header, separator)) {
    const PointField field = pointFieldNamed(plainName(name));
    const bool isTaken = std::exchange(taken[indexOf(field)], true);
    columns.push_back(isTaken || field == PointField::packedColor ? PointField::none : field);
  }
  const auto has = [&](PointField field) { return taken[indexOf(field)]; };
  const bool isHeader = has(PointField::x) && has(PointField::y) && has(PointField::z);
  if (!isHeader || columns.size() != count) return {};
  return columns;
}

/// Whether three columns from `first` on hold colors: whole numbers from 0 to 255, not all 0 or 1.
bool areColors(const std::vector<std::vector<double>>& rows, std::size_t first) {
  bool anyAboveOne = false;
  for (const std::vector<double>& row : rows) {
    if (row.size() < first + 3) return false;
    for (std::size_t i = first; i < first + 3; ++i) {
      if (!(row[i] >= 0 && row[i] <= 255 && row[i] == std::floor(row[i]))) return false;
      anyAboveOne = anyAboveOne || row[i] > 1;
    }
  }
  return anyAboveOne;
}

/// Columns by their number and what they hold.
std::vector<PointField> guessedColumns(const std::vector<std::vector<double>>& rows, bool isPts,
                                       ColumnDoubt& doubt) {
  using enum PointField;
  const std::vector<double>& first = rows.front();
  const std::size_t count = first.size();
  std::vector<PointField> columns = {x, y, z};
  const auto append = [&](std::initializer_list<PointField> more) {
    columns.insert(columns.end(), more);
  };
  const bool colorsFirst = areColors(rows, 3);
  const bool colorsBehind = areColors(rows, 4);
  if (colorsBehind && (isPts || !colorsFirst)) {
    append({intensity, red, green, blue});
  } else if (colorsFirst) {
    append({red, green, blue});
    if (count == 7) append({intensity});
  } else if (count == 4 || count == 5) {
    append({intensity});
  }
  if (count > columns.size()) doubt = ColumnDoubt::withoutName;
  if (colorsFirst && colorsBehind && !isPts) doubt = ColumnDoubt::twoPlaces;
  if (std::any_of(first.begin(), first.begin() + std::ptrdiff_t(std::min<std::size_t>(count, 3)),
                  [](double value) { return std::isnan(value); }))
    doubt = ColumnDoubt::notNumbers;
  columns.resize(std::max<std::size_t>(count, 3), none);
  return columns;
}

/// Whether a third of the fields of any line are numbers: in a letter, none has as many.
bool mayBePoints(const Sample& sample, const XyzLayout& layout) {
  return std::ranges::any_of(sample.data, [&](std::string_view line) {
    const std::vector<std::string_view> fields = fieldsOf(line, layout.separator);
    const auto isNumber = [&](std::string_view field) {
      return numberInField(field, layout.hasDecimalComma).has_value();
    };
    return 3 * std::ranges::count_if(fields, isNumber) >= std::ssize(fields);
  });
}

std::vector<std::vector<double>> numbersOf(const Sample& sample, const XyzLayout& layout) {
  std::vector<std::vector<double>> rows;
  for (const std::string_view line : sample.data) {
    std::vector<double>& row = rows.emplace_back();
    for (const std::string_view field : fieldsOf(line, layout.separator))
      row.push_back(numberInField(field, layout.hasDecimalComma).value_or(NAN));
  }
  return rows;
}

/// Whole lines from the beginning of a text: 1000 and more, or all of it.
std::string headOf(ByteSource& source) {
  for (std::uint64_t size = std::uint64_t{1} << 20;; size *= 8) {
    std::string head = source.read(0, size);
    if (size >= source.size()) return head;
    head.resize(head.rfind('\n') + 1); // 0: there is none
    if (sampleOf(head).data.size() >= sampledLines) return head;
  }
}

void findColumns(const Sample& sample, std::size_t count, bool isPts, XyzLayout& layout) {
  std::vector<std::string_view> lines = {sample.header};
  lines.insert(lines.end(), sample.comments.begin(), sample.comments.end());
  for (const std::string_view line : lines) {
    layout.columns = namedColumns(line, layout.separator, count);
    if (layout.columns.empty()) continue;
    layout.names = line;
    return;
  }
  layout.columns = guessedColumns(numbersOf(sample, layout), isPts, layout.doubt);
  if (layout.doubt == ColumnDoubt::notNumbers ||
      fieldsOf(sample.header, layout.separator).size() != count)
    return;
  layout.doubt = ColumnDoubt::otherNames;
  layout.names = sample.header;
}

/// Whether a line that was taken for a title is the first point, whose columns a user has named.
bool isFirstPoint(std::string_view line, const XyzLayout& layout) {
  if (line.empty()) return false;
  for (const PointField field : layout.columns) {
    const std::string_view text = nextField(line, layout.separator);
    if (field != PointField::none && !numberInField(text, layout.hasDecimalComma)) return false;
  }
  return true;
}

void requireText(std::string_view head, const std::string& file) {
  if (head.find('\0') != std::string_view::npos)
    throw ShownError({Shown::tr("is no plain text, though its name says so: export it as text, or "
                                "give it the extension of its format"),
                      {},
                      FilePlace{file}});
}

void requireNumberOfColumns(std::size_t named, std::size_t count, const std::string& file) {
  if (named != count)
    throw ShownError({named == 1 ? Shown::tr("1 column is named, but its first line of points has "
                                             "%2: name each, with - for those to leave out")
                                 : Shown::tr("%1 columns are named, but its first line of points "
                                             "has %2: name each, with - for those to leave out"),
                      {std::to_string(named), std::to_string(count)},
                      FilePlace{file}});
}

} // namespace

bool isComment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.starts_with("//") ||
         std::string_view("#%!;").find(text.front()) != std::string_view::npos;
}

std::string_view nextField(std::string_view& rest, char separator) {
  if (separator == ' ') return nextWord(rest);
  const std::size_t end = rest.find(separator);
  const std::string_view field = trimmed(rest.substr(0, end));
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return field;
}

std::optional<double> numberInField(std::string_view field, bool hasDecimalComma) {
  const std::size_t comma = hasDecimalComma ? field.find(',') : std::string_view::npos;
  if (comma == std::string_view::npos) return numberIn(field);
  std::array<char, 64> buffer{};
  if (field.size() > buffer.size()) return std::nullopt;
  std::ranges::copy(field, buffer.begin());
  buffer[comma] = '.';
  return numberIn({buffer.data(), field.size()});
}

XyzLayout xyzLayoutOf(ByteSource& source, const std::string& file,
                      const std::vector<PointField>& columns) {
  const std::string head = headOf(source);
  requireText(head, file);
  const Sample sample = sampleOf(head);
  XyzLayout layout;
  layout.headerLine = sample.headerLine;
  layout.count = sample.count;
  if (sample.data.empty()) return layout;
  findSeparator(sample, layout);
  if (columns.empty() && !mayBePoints(sample, layout)) return layout;
  const std::size_t count = fieldsOf(sample.data.front(), layout.separator).size();
  if (!columns.empty()) requireNumberOfColumns(columns.size(), count, file);
  if (columns.empty()) {
    findColumns(sample, count, lowerCase(file).ends_with(".pts"), layout);
  } else {
    layout.columns = columns;
    if (isFirstPoint(sample.header, layout)) layout.headerLine = 0;
  }
  const auto last =
      std::ranges::find_if(layout.columns.rbegin(), layout.columns.rend(),
                           [](PointField field) { return field != PointField::none; });
  layout.needed = static_cast<std::size_t>(layout.columns.rend() - last);
  return layout;
}

} // namespace espalier
