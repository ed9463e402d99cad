#include "core/io/structures/internode_table.h"

#include "core/base/text.h"
#include "core/evaluate/traits/internodes.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr double degreesPerRadian = 180 / std::numbers::pi;

constexpr const char* headLine =
    "# Internodes, exported by Espalier. p is a node, q its parent, o the parent of q.\n"
    "# Angles are in degrees, lengths in the unit of the coordinates.\n"
    "# length: of the internode, |p - q|\n"
    "# inclination: of the internode from straight up, acos((p - q).z / |p - q|)\n"
    "# turn: from the internode before, acos((p - q).(q - o) / (|p - q| |q - o|))\n"
    "# absolute: of a branch around its axis, atan2(d.(t x u), d.u) from 0 to 360, d = p - q\n"
    "#   t: direction of the axis at q, from the node before q to the one after it\n"
    "#   u: across t; at the first node of the axis the direction of x (of y if the axis goes\n"
    "#   along x), carried from node to node by the least rotation\n"
    "# relative_ccw: absolute less that of the branch before on the axis, modulo 360;\n"
    "#   counterclockwise as seen from the apex\n"
    "# relative_cw: 360 - relative_ccw\n"
    "# node_length: along the axis, from where the branch before is attached to q\n"
    "node,parent,edge,x,y,z,radius,length,inclination,turn,absolute,relative_ccw,relative_cw,"
    "node_length\n";

std::string cell(std::optional<double> value, double factor = 1) {
  return ',' + (value ? plainDecimal(factor * *value) : std::string());
}

std::optional<double> clockwise(std::optional<double> angle) {
  if (!angle || *angle == 0) return angle;
  return 2 * std::numbers::pi - *angle;
}

} // namespace

void writeInternodeTable(std::ostream& out, const Skeleton& skeleton) {
  out << headLine;
  const std::vector<Internode> table = internodes(skeleton);
  std::vector<std::size_t> numbers(skeleton.idEnd());
  std::size_t last = 0;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    const Internode& entry = table[indexOf(id)];
    numbers[indexOf(id)] = ++last;
    std::string line = std::to_string(last) + ',';
    if (node.parent) line += std::to_string(numbers[indexOf(*node.parent)]);
    line += ',';
    line += node.parent ? static_cast<char>(node.edge) : '/';
    for (const double coordinate : node.position)
      line += cell(coordinate);
    line += cell(node.radius > 0 ? std::optional(node.radius) : std::nullopt);
    line += cell(node.parent ? std::optional(entry.length) : std::nullopt);
    for (const auto& angle : {entry.inclination, entry.turn, entry.azimuth, entry.divergence,
                              clockwise(entry.divergence)})
      line += cell(angle, degreesPerRadian);
    out << line << cell(entry.spacing) << '\n';
  }
}

} // namespace espalier
