#include "core/io/qsm/qsm_columns.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

using enum QsmField;

struct Name {
  std::string_view name;
  QsmField field;
};

constexpr auto names = std::to_array<Name>({{"radius", radius},
                                            {"length", length},
                                            {"startx", startX},
                                            {"starty", startY},
                                            {"startz", startZ},
                                            {"axisx", axisX},
                                            {"axisy", axisY},
                                            {"axisz", axisZ},
                                            {"endx", endX},
                                            {"endy", endY},
                                            {"endz", endZ},
                                            {"startradius", startRadius},
                                            {"parent", parent},
                                            {"extension", extension},
                                            {"branch", branch},
                                            {"branchorder", order}});

/// "BranchOrder", "branch_order" and "branch order (1)" are one name.
std::string keyOf(std::string_view name) {
  name = name.substr(0, name.find('('));
  std::string key;
  for (const char c : lowerCase(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) key += c;
  return key;
}

/// The first of the three columns for which a name alone stands.
std::optional<QsmField> vectorNamed(const std::string& key) {
  if (key == "start" || key == "startpoint") return startX;
  if (key == "axis" || key == "axisdirection") return axisX;
  return std::nullopt;
}

char separatorOf(std::string_view line) {
  for (const char c : {'\t', ',', ';'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

QsmColumns columnsNamed(std::string_view header) {
  QsmColumns columns{.separator = separatorOf(header), .hasHeader = true};
  for (const std::string_view name : qsmFields(header, columns.separator)) {
    const std::string key = keyOf(name);
    const auto* found = std::ranges::find(names, key, &Name::name);
    if (const auto vector = vectorNamed(key)) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        columns.places[static_cast<std::size_t>(*vector) + axis] = columns.count++;
      continue;
    }
    if (found != names.end() && !columns[found->field])
      columns.places[static_cast<std::size_t>(found->field)] = columns.count;
    else if (!key.empty() && key != "positioninbranch")
      columns.leftOut.emplace_back(name);
    ++columns.count;
  }
  return columns;
}

/// The columns of TreeQSM without names, by their number.
std::optional<QsmColumns> columnsOfTreeQsm(std::size_t count, char separator) {
  if (count != 14 && count != 15 && count != 17) return std::nullopt;
  QsmColumns columns{.separator = separator, .count = count};
  for (const QsmField field : {radius, length, startX, startY, startZ, axisX, axisY, axisZ})
    columns.places[static_cast<std::size_t>(field)] = static_cast<std::size_t>(field);
  std::size_t next = 8;
  for (const QsmField field : {parent, extension, branch, order})
    columns.places[static_cast<std::size_t>(field)] = next++;
  columns.leftOut = count == 17 ? std::vector<std::string>{"mad", "SurfCov", "added", "UnmodRadius"}
                                : std::vector<std::string>{"added"};
  if (count == 15) columns.leftOut.emplace_back("UnmodRadius");
  return columns;
}

/// Whether a line without names can be a cylinder of TreeQSM: its axis is of length 1, and the
/// columns behind are whole numbers.
bool canBeCylinder(const std::vector<std::string_view>& fields) {
  std::vector<double> values;
  for (const std::string_view field : fields) {
    const auto value = numberIn(field);
    if (!value || !std::isfinite(*value)) return false;
    values.push_back(*value);
  }
  const double axisLength = std::hypot(values[5], values[6], values[7]);
  const auto isCount = [](double x) { return x >= 0 && x == std::floor(x); };
  return values[0] >= 0 && values[1] >= 0 && std::abs(axisLength - 1) < 0.01 &&
         std::all_of(values.begin() + 8, values.begin() + 13, isCount);
}

/// Whether they say where cylinders are, how thick, and which is attached to which.
bool areEnough(const QsmColumns& columns) {
  const bool hasStart = columns[startX] && columns[startY] && columns[startZ];
  const bool hasAxis = columns[length] && columns[axisX] && columns[axisY] && columns[axisZ];
  const bool hasEnd = columns[endX] && columns[endY] && columns[endZ];
  return columns[radius] && columns[parent] && hasStart && (hasAxis || hasEnd);
}

} // namespace

std::optional<QsmColumns> qsmColumnsIn(std::string_view beginning) {
  LineReader lines(beginning);
  const auto first = lines.next();
  if (!first || trimmed(*first).empty()) return std::nullopt;
  QsmColumns named = columnsNamed(*first);
  if (areEnough(named)) return named;
  const char separator = separatorOf(*first);
  std::optional<QsmColumns> columns;
  LineReader rows(beginning);
  while (const auto line = rows.next()) {
    const bool isCut = rows.offset() == beginning.size() && rows.number() > 1; // it may go on
    if (isCut || trimmed(*line).empty()) break;
    const std::vector<std::string_view> fields = qsmFields(*line, separator);
    columns = columnsOfTreeQsm(fields.size(), separator);
    if (!columns || !canBeCylinder(fields)) return std::nullopt;
  }
  return columns;
}

std::vector<std::string_view> qsmFields(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  if (separator == ' ') {
    while (true) {
      const std::string_view word = nextWord(line);
      if (word.empty()) return fields;
      fields.push_back(word);
    }
  }
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(separator, start), line.size());
    std::string_view field = trimmed(line.substr(start, end - start));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
      field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    start = end + 1;
  }
  return fields;
}

} // namespace espalier
