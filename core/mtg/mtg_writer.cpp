#include "core/mtg/mtg_writer.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/mtg/mtg_parser.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_sections.h"
#include "core/mtg/mtg_values.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

namespace espalier {
namespace {

std::string joined(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields)
    line += (&field == &fields.front() ? "" : "\t") + field;
  return line + '\n';
}

void checkText(const std::string& text, const char* refusal) {
  if (!survivesMtg(text)) throw ShownError({refusal, {inQuotes(text)}});
}

void checkValue(const std::string& value, const MtgVertex& vertex) {
  if (survivesMtg(value)) return;
  throw ShownError({espalier::Shown::tr("the value of %1 %2 cannot stand in an MTG text: take out "
                                        "tabs, line ends, comment signs (# or ;) and blanks around "
                                        "it"),
                    {mtgLabel(vertex), inQuotes(value)}});
}

std::vector<std::string> cellsOf(const std::vector<std::string>& values, const Mtg& mtg) {
  std::vector<std::string> cells(std::min(values.size(), mtg.features.size()));
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i] = mtgCellText(values[i], mtg.features[i]);
  while (!cells.empty() && cells.back().empty())
    cells.pop_back();
  return cells;
}

std::string sectionsOf(const Mtg& mtg) {
  std::string text = "CODE :\tFORM-A\n\nCLASSES :\n"
                     "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n";
  for (const MtgClass& each : mtg.classes)
    text += joined({each.symbol, std::to_string(each.scale), each.decomposition, each.indexation,
                    each.definition});
  text += "\nDESCRIPTION :\nLEFT\tRIGHT\tRELTYPE\tMAX\n";
  for (const MtgRule& each : mtg.rules)
    text += joined({each.left, each.right, each.edge, each.most});
  text += "\nFEATURES :\nNAME\tTYPE\n";
  for (const MtgFeature& each : mtg.features)
    text += each.file.empty() ? joined({each.name, each.type})
                              : joined({each.name, each.type, each.file});
  return text;
}

/// The line of columns. OpenAlea seeks the first feature in it, so it must not be found before.
std::string columnsOf(const Mtg& mtg, std::size_t columns) {
  std::string line = "ENTITY-CODE";
  if (!mtg.features.empty() && line.find(mtg.features.front().name) != std::string::npos)
    line = "TOPO";
  line.append(columns, '\t');
  std::vector<std::string> names;
  for (const MtgFeature& feature : mtg.features)
    names.push_back(feature.name);
  return line + joined(names);
}

void checkTexts(const Mtg& mtg) {
  for (const MtgFeature& feature : mtg.features)
    for (const std::string& text : {feature.name, feature.type, feature.file})
      checkText(text, espalier::Shown::tr("the feature %1 cannot stand in an MTG text: take out "
                                          "tabs, line ends, comment signs (# or ;) and blanks "
                                          "around it"));
  for (const MtgVertex& vertex : mtg.vertices) {
    checkText(vertex.alias, espalier::Shown::tr("the alias %1 cannot stand in an MTG text: take "
                                                "out tabs, line ends, comment signs (# or ;) and "
                                                "blanks around it"));
    for (const std::string& value : vertex.values)
      checkValue(value, vertex);
    for (const auto& values : vertex.later)
      for (const std::string& value : values)
        checkValue(value, vertex);
  }
}

/// The class of each vertex must be listed: another program knows its scale from there alone.
void checkClasses(const Mtg& mtg) {
  std::set<std::pair<std::string_view, int>> known;
  for (const MtgClass& each : mtg.classes) {
    checkText(each.symbol, espalier::Shown::tr("the class %1 cannot stand in an MTG text: take out "
                                               "tabs, line ends, comment signs (# or ;) and "
                                               "blanks around it"));
    known.insert({each.symbol, each.scale});
  }
  for (const MtgVertex& vertex : mtg.vertices)
    if (!known.contains({vertex.symbol, vertex.scale}))
      throw ShownError({espalier::Shown::tr("the vertex %1 is of scale %2, but no class of this "
                                            "symbol and scale is listed: rename its class"),
                        {mtgLabel(vertex), std::to_string(vertex.scale)}});
}

Mtg inOrderOf(const MtgRows& rows, const Mtg& mtg) {
  std::vector<VertexId> place(mtg.vertices.size());
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    place[indexOf(rows.rows[i].vertex)] = VertexId{static_cast<std::uint32_t>(i)};
  Mtg result{mtg.classes, mtg.rules, mtg.features, {}};
  result.vertices.reserve(mtg.vertices.size());
  for (const MtgRow& row : rows.rows) {
    MtgVertex vertex = mtg.vertices[indexOf(row.vertex)];
    for (std::optional<VertexId>* link : {&vertex.parent, &vertex.complex})
      if (*link) *link = place[indexOf(**link)];
    result.vertices.push_back(std::move(vertex));
  }
  return result;
}

/// Some plants look like others in text: A12 may be of class A or of class A1. Better no file than
/// one of another plant.
void checkReadsBack(const std::string& text, const Mtg& expected) {
  if (expected.vertices.empty()) return; // a plant to be drawn; readers want one vertex at least
  const ParsedMtg back = parseMtg(text, "MTG");
  const auto [read, meant] = std::ranges::mismatch(back.mtg.vertices, expected.vertices);
  if (read == back.mtg.vertices.end() && meant == expected.vertices.end()) return;
  if (meant == expected.vertices.end())
    throw ShownError({espalier::Shown::tr("more vertices would be read from MTG text than the "
                                          "plant has: give each class a symbol that is not the "
                                          "beginning of another one")});
  throw ShownError(
      {espalier::Shown::tr("the vertex %1 would be read from MTG text as another: give its class a "
                           "symbol that is not the beginning of another one"),
       {mtgLabel(*meant)}});
}

} // namespace

void writeMtg(std::ostream& out, const Mtg& mtg) {
  const Mtg whole = mtgNormalized(mtg);
  checkClasses(whole);
  checkTexts(whole);
  const MtgRows rows = mtgRows(whole);
  std::string text = rows.isAmbiguous ? std::string(previousColumnMark) + '\n' : "";
  text += sectionsOf(whole) + "\nMTG :\n" + columnsOf(whole, rows.columns);
  MtgLayout layout{.width = rows.columns + whole.features.size()};
  for (std::size_t i = 0; i < whole.features.size(); ++i)
    layout.columns.push_back(rows.columns + i);
  for (const MtgRow& row : rows.rows)
    text += mtgLines(row, whole, layout);
  checkReadsBack(text, inOrderOf(rows, whole));
  out << text;
}

Mtg mtgNormalized(Mtg mtg) {
  const auto hasAlias = [](const MtgVertex& vertex) { return !vertex.alias.empty(); };
  if (std::ranges::any_of(mtg.vertices, hasAlias) &&
      std::ranges::none_of(mtg.features, isAliasFeature)) {
    mtg.features.insert(mtg.features.begin(), {"Alias", "STRING"});
    for (MtgVertex& vertex : mtg.vertices) {
      if (!vertex.values.empty()) vertex.values.insert(vertex.values.begin(), "");
      for (auto& values : vertex.later)
        values.insert(values.begin(), "");
    }
  }
  for (MtgVertex& vertex : mtg.vertices) {
    vertex.values = cellsOf(vertex.values, mtg);
    for (auto& values : vertex.later)
      values = cellsOf(values, mtg);
    if (!vertex.parent) vertex.edge = EdgeType::successor; // it has no meaning there
  }
  return mtg;
}

Mtg mtgAsWritten(const Mtg& mtg) {
  const Mtg whole = mtgNormalized(mtg);
  return inOrderOf(mtgRows(whole), whole);
}

void writeMtg(std::ostream& out, const Skeleton& skeleton) {
  writeMtg(out, mtgOf(skeleton));
}

} // namespace espalier
