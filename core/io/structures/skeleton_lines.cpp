#include "core/io/structures/skeleton_lines.h"

#include "core/base/text.h"

#include <ostream>
#include <string>
#include <vector>

namespace espalier {
namespace {

std::string coordinatesOf(const Node& node) {
  return plainDecimal(node.position.x()) + ' ' + plainDecimal(node.position.y()) + ' ' +
         plainDecimal(node.position.z());
}

/// Numbers of the nodes in the order of ids, by id, from `first`.
std::vector<std::size_t> numbersOf(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                                   std::size_t first) {
  std::vector<std::size_t> numbers(skeleton.idEnd());
  for (const NodeId id : ids)
    numbers[indexOf(id)] = first++;
  return numbers;
}

} // namespace

void writeObjLines(std::ostream& out, const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<std::size_t> numbers = numbersOf(skeleton, ids, 1);
  out << "# exported by Espalier\n";
  for (const NodeId id : ids)
    out << "v " << coordinatesOf(skeleton[id]) << '\n';
  for (const NodeId id : ids)
    if (const auto parent = skeleton[id].parent)
      out << "l " << numbers[indexOf(*parent)] << ' ' << numbers[indexOf(id)] << '\n';
}

void writePlyLines(std::ostream& out, const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<std::size_t> numbers = numbersOf(skeleton, ids, 0);
  out << "ply\nformat ascii 1.0\ncomment exported by Espalier\nelement vertex " << ids.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty double radius\n"
         "element edge "
      << ids.size() - skeleton.roots().size()
      << "\nproperty int vertex1\nproperty int vertex2\nproperty uchar branching\nend_header\n";
  for (const NodeId id : ids)
    out << coordinatesOf(skeleton[id]) << ' ' << plainDecimal(skeleton[id].radius) << '\n';
  for (const NodeId id : ids) {
    const Node& node = skeleton[id];
    if (!node.parent) continue;
    out << numbers[indexOf(*node.parent)] << ' ' << numbers[indexOf(id)] << ' '
        << (node.edge == EdgeType::branching ? 1 : 0) << '\n';
  }
}

} // namespace espalier
