#include "core/mtg/mtg_lines.h"

#include "core/base/text.h"
#include "core/mtg/mtg_source.h"
#include "core/mtg/mtg_values.h"

#include <cmath>

namespace espalier {
namespace {

std::string lineOf(std::size_t column, const std::string& code,
                   const std::vector<std::string>& values, const std::string& alias, const Mtg& mtg,
                   const MtgLayout& layout) {
  std::vector<const std::string*> fields(std::max(layout.width, column + 1));
  fields[column] = &code;
  for (std::size_t i = 0; i < values.size(); ++i)
    fields[layout.columns[i]] = &values[i];
  for (std::size_t i = 0; i < mtg.features.size() && !alias.empty(); ++i)
    if (isAliasFeature(mtg.features[i])) fields[layout.columns[i]] = &alias;
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += '\t';
    if (fields[i] != nullptr) line += *fields[i];
  }
  return line + '\n';
}

} // namespace

std::string mtgLabel(const MtgVertex& vertex) {
  return vertex.symbol + (vertex.index ? vertex.index->text() : "");
}

std::string mtgLines(const MtgRow& row, const Mtg& mtg, const MtgLayout& layout) {
  const MtgVertex& vertex = mtg.vertices[indexOf(row.vertex)];
  const std::string code = (row.continues ? "^" : "") + std::string(1, row.edge) + mtgLabel(vertex);
  std::string lines = lineOf(row.column, code, vertex.values, vertex.alias, mtg, layout);
  for (const std::vector<std::string>& values : vertex.later)
    lines += lineOf(row.column, "*", values, {}, mtg, layout);
  return lines;
}

std::string mtgCellText(const std::string& value, const MtgFeature& feature) {
  if (!isNumberFeature(feature) || value.find_first_of("eE+") == std::string::npos) return value;
  const auto number = isMissingMtgValue(value) ? std::nullopt : numberIn(value);
  return number && std::isfinite(*number) ? plainDecimal(*number) : value;
}

bool survivesMtg(const std::string& text) {
  if (text.find_first_of("\t\n\r") != std::string::npos || trimmed(text) != text) return false;
  return text.find_first_of("#;") == std::string::npos ||
         mtgSource('\t' + text).text == '\t' + text;
}

} // namespace espalier
