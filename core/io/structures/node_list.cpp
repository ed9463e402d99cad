#include "core/io/structures/node_list.h"

#include "core/base/text.h"
#include "core/io/structures/node_rows.h"

#include <cmath>
#include <ostream>
#include <vector>

namespace espalier {
namespace {

constexpr std::string_view columnNames = "vid parentid edgetype XX YY ZZ Radius";

bool isMissing(std::string_view field) {
  return field.empty() || field == "None" || field == "-1";
}

NodeRow rowOf(std::string_view line, std::size_t number, const std::string& file) {
  const FilePlace where{file, number};
  std::vector<std::string_view> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find('\t', start), line.size());
    fields.push_back(trimmed(line.substr(start, end - start)));
    start = end + 1;
  }
  if (fields.size() < 6)
    throw ShownError({espalier::Shown::tr("expected 7 fields parted by tabs (%1), found %2"),
                      {std::string(columnNames), std::to_string(fields.size())},
                      where});
  NodeRow row{.id = std::string(fields[0]), .place = number};
  if (row.id.empty()) throw ShownError({espalier::Shown::tr("the node has no id"), {}, where});
  if (!isMissing(fields[1])) row.parent = fields[1];
  if (fields[2] == "+") row.node.edge = EdgeType::branching;
  row.node.position = {finiteNumber(fields[3], "XX", where), finiteNumber(fields[4], "YY", where),
                       finiteNumber(fields[5], "ZZ", where)};
  if (fields.size() > 6 && !isMissing(fields[6]))
    row.node.radius = finiteNumber(fields[6], "Radius", where);
  if (row.node.radius < 0)
    throw ShownError({espalier::Shown::tr("the radius is negative"), {}, where});
  return row;
}

std::vector<NodeRow> rowsOf(std::string_view text, const std::string& file) {
  std::vector<NodeRow> rows;
  bool hasCount = false;
  LineReader lines(text);
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (content.empty() || content.starts_with('#') || content.starts_with("vid")) continue;
    const bool isCount = content.find_first_not_of("0123456789") == std::string_view::npos;
    if (isCount && !hasCount && rows.empty())
      hasCount = true;
    else
      rows.push_back(rowOf(*line, lines.number(), file));
  }
  if (rows.empty()) throw ShownError({espalier::Shown::tr("holds no nodes"), {}, FilePlace{file}});
  return rows;
}

} // namespace

bool isNodeList(std::string_view beginning) {
  LineReader lines(beginning);
  while (const auto line = lines.next()) {
    const std::size_t name = line->find("vid");
    if (name != std::string_view::npos && line->find("parentid") != std::string_view::npos)
      return true;
    if (!line->starts_with('#')) return false;
  }
  return false;
}

Imported<Skeleton> readNodeList(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  return {skeletonOfRows(rowsOf(bytes, file),
                         [&](const NodeRow& row) {
                           return FilePlace{file, row.place};
                         }),
          {}};
}

void writeNodeList(std::ostream& out, const Skeleton& skeleton) {
  out << "# exported by Espalier\n# " << columnNames << '\n' << skeleton.size() << '\n';
  std::vector<std::size_t> numbers(skeleton.idEnd());
  std::size_t last = 0;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    numbers[indexOf(id)] = ++last;
    std::string line = std::to_string(last) + '\t';
    if (node.parent) line += std::to_string(numbers[indexOf(*node.parent)]);
    line += '\t';
    line += node.parent ? static_cast<char>(node.edge) : '/';
    for (const double coordinate : node.position)
      line += '\t' + plainDecimal(coordinate);
    line += '\t' + (node.radius > 0 ? plainDecimal(node.radius) : std::string());
    out << line << '\n';
  }
}

} // namespace espalier
