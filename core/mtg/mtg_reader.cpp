#include "core/mtg/mtg_reader.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mtg/mtg_sections.h"
#include "core/mtg/mtg_topology.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

/// Which columns hold which features.
struct Columns {
  std::vector<std::optional<std::size_t>> features; // by column: place in Mtg::features
  std::size_t firstFeature = std::numeric_limits<std::size_t>::max();
};

std::size_t featureNamed(std::string_view name, Mtg& mtg) {
  const auto found = std::ranges::find(mtg.features, name, &MtgFeature::name);
  if (found != mtg.features.end()) return static_cast<std::size_t>(found - mtg.features.begin());
  mtg.features.push_back({std::string(name), "ALPHA"});
  return mtg.features.size() - 1;
}

/// The columns as told by the first line of the section MTG.
Columns readColumns(LineReader& lines, Mtg& mtg, const std::string& file) {
  while (const auto line = lines.next()) {
    const std::vector<std::string_view> names = mtgFields(*line);
    if (std::ranges::all_of(names, [](std::string_view name) { return name.empty(); })) continue;
    if (names.front() != "ENTITY-CODE" && names.front() != "TOPO")
      throw Error(place(file, lines.number()) +
                  "expected the line of columns, ENTITY-CODE ..., found " + inQuotes(*line));
    Columns columns;
    columns.features.resize(names.size());
    for (std::size_t i = 1; i < names.size(); ++i)
      if (!names[i].empty()) {
        columns.features[i] = featureNamed(names[i], mtg);
        columns.firstFeature = std::min(columns.firstFeature, i);
      }
    return columns;
  }
  throw Error(file + ": ends before the columns of its section MTG: it is cut short");
}

/// The column of the code in a line; none for a line without any.
std::optional<std::size_t> codeColumn(const std::vector<std::string_view>& fields,
                                      const Columns& columns, const std::string& where) {
  const std::size_t end = std::min(fields.size(), columns.firstFeature);
  std::optional<std::size_t> column;
  for (std::size_t i = 0; i < end; ++i) {
    if (fields[i].empty()) continue;
    if (column)
      throw Error(where + "two codes stand in one line, " + inQuotes(fields[*column]) + " and " +
                  inQuotes(fields[i]));
    column = i;
  }
  const auto isFilled = [](std::string_view field) { return !field.empty(); };
  if (!column && std::ranges::any_of(fields, isFilled))
    throw Error(where + "values stand without a code before them");
  return column;
}

void checkValue(std::string_view value, const MtgFeature& feature, const std::string& where) {
  if ((feature.type != "REAL" && feature.type != "INT") || isMissingMtgValue(value)) return;
  if (!numberIn(value))
    throw Error(where + feature.name + " is " + inQuotes(value) + ", expected a number");
}

/// Reads the values of a line.
/// @return how many stand in columns without a name
std::size_t readValues(const std::vector<std::string_view>& fields, const Columns& columns,
                       const Mtg& mtg, const std::string& where, std::vector<std::string>& values) {
  std::size_t nameless = 0;
  for (std::size_t i = columns.firstFeature; i < fields.size(); ++i) {
    if (fields[i].empty()) continue;
    const auto feature = i < columns.features.size() ? columns.features[i] : std::nullopt;
    if (!feature) {
      ++nameless;
      continue;
    }
    checkValue(fields[i], mtg.features[*feature], where);
    values.resize(std::max(values.size(), *feature + 1));
    values[*feature] = fields[i];
  }
  return nameless;
}

} // namespace

bool isMtg(std::string_view beginning) {
  LineReader lines(beginning);
  while (const auto line = lines.next()) {
    const std::string_view text = trimmed(*line);
    if (text.empty() || text.starts_with('#')) continue;
    return text.starts_with("CODE") && trimmed(text.substr(4)).starts_with(':');
  }
  return false;
}

Imported<Mtg> readMtg(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  if (trimmed(bytes).empty()) throw Error(file + ": is empty");
  LineReader lines(bytes);
  Imported<Mtg> result{readMtgSections(lines, file), {}};
  Mtg& mtg = result.value;
  const Columns columns = readColumns(lines, mtg, file);
  MtgTopology topology(mtg);
  std::size_t nameless = 0;
  while (const auto line = lines.next()) {
    const std::vector<std::string_view> fields = mtgFields(*line);
    const std::string where = place(file, lines.number());
    const auto column = codeColumn(fields, columns, where);
    if (!column) continue;
    if (fields[*column].starts_with('*'))
      throw Error(where + "a vertex described at several dates (*) cannot be read: keep one date");
    const VertexId vertex = topology.add(fields[*column], *column, where);
    nameless += readValues(fields, columns, mtg, where, mtg.vertices[indexOf(vertex)].values);
  }
  if (mtg.vertices.empty()) throw Error(file + ": holds no vertices");
  if (nameless > 0)
    result.notes.push_back(file + ": " + std::to_string(nameless) +
                           " values stand in columns without a name and are left out");
  return result;
}

} // namespace espalier
