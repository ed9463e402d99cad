#include "core/mtg/mtg_writer.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace espalier {
namespace {

constexpr std::size_t mostColumns = 64;

struct Row {
  NodeId id{};
  std::size_t column = 0;
  bool continues = false; // the column, on the node written last in it
};

/// The child that continues the column of its parent.
std::optional<NodeId> continuation(const Skeleton& skeleton, NodeId id, std::size_t column) {
  const std::vector<NodeId>& children = skeleton.children(id);
  if (children.empty()) return std::nullopt;
  if (skeleton[children.front()].edge == EdgeType::successor) return children.front();
  if (column + 1 < mostColumns) return std::nullopt;
  return children.back();
}

/// All nodes from `root` on, each after its parent and directly after what branches off before it.
std::vector<Row> rowsOf(const Skeleton& skeleton, NodeId root) {
  std::vector<Row> rows;
  std::vector<Row> stack = {{root, 0, true}};
  while (!stack.empty()) {
    const Row row = stack.back();
    stack.pop_back();
    rows.push_back(row);
    const auto next = continuation(skeleton, row.id, row.column);
    if (next) stack.push_back({*next, row.column, true}); // comes last: the others are on top of it
    std::vector<NodeId> children = skeleton.children(row.id);
    std::ranges::reverse(children); // the last one put on the stack is the first to be written
    for (const NodeId child : children)
      if (child != next) stack.push_back({child, row.column + 1, false});
  }
  return rows;
}

void checkFinite(const Skeleton& skeleton) {
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].position.allFinite() || !std::isfinite(skeleton[id].radius))
      throw Error("node " + std::to_string(indexOf(id)) +
                  " has a position or radius that is not finite: correct it before saving");
}

void writeHeader(std::ostream& out, std::size_t columns) {
  out << "CODE :\tFORM-A\n\n"
         "CLASSES :\n"
         "SYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
         "$\t0\tFREE\tFREE\tIMPLICIT\n"
         "P\t1\tFREE\tFREE\tEXPLICIT\n"
         "N\t2\tFREE\tFREE\tEXPLICIT\n\n"
         "DESCRIPTION :\n"
         "LEFT\tRIGHT\tRELTYPE\tMAX\n"
         "N\tN\t<\t?\n"
         "N\tN\t+\t?\n\n"
         "FEATURES :\n"
         "NAME\tTYPE\n"
         "XX\tREAL\n"
         "YY\tREAL\n"
         "ZZ\tREAL\n"
         "radius\tREAL\n\n"
         "MTG :\n"
         "ENTITY-CODE"
      << std::string(columns, '\t') << "XX\tYY\tZZ\tradius\n";
}

std::string lineOf(const Row& row, const Node& node, std::size_t columns) {
  std::string line(row.column, '\t');
  if (row.continues) line += '^';
  line += node.parent ? static_cast<char>(node.edge) : '/';
  line += 'N';
  line.append(columns - row.column, '\t');
  for (const double coordinate : node.position)
    line += plainDecimal(coordinate) + '\t';
  if (node.radius > 0) line += plainDecimal(node.radius);
  return line + '\n';
}

} // namespace

void writeMtg(std::ostream& out, const Skeleton& skeleton) {
  checkFinite(skeleton);
  std::vector<std::vector<Row>> plants;
  std::size_t columns = 1;
  for (const NodeId root : skeleton.roots()) {
    plants.push_back(rowsOf(skeleton, root));
    for (const Row& row : plants.back())
      columns = std::max(columns, row.column + 1);
  }
  writeHeader(out, columns);
  for (std::size_t i = 0; i < plants.size(); ++i) {
    out << "/P" << i + 1 << std::string(columns + 3, '\t') << '\n';
    for (const Row& row : plants[i])
      out << lineOf(row, skeleton[row.id], columns);
  }
}

} // namespace espalier
