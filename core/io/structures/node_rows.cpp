#include "core/io/structures/node_rows.h"

#include "core/base/coordinates.h"
#include "core/base/text.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace espalier {
namespace {

using Where = std::function<FilePlace(const NodeRow&)>;

/// Rows that are attached to each row, roots under the number of rows.
std::vector<std::vector<std::size_t>> childrenOf(const std::vector<NodeRow>& rows,
                                                 const Where& where) {
  std::unordered_map<std::string_view, std::size_t> index; // rows by id
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!index.emplace(rows[i].id, i).second)
      throw ShownError(
          {espalier::Shown::tr("the id %1 occurs twice"), {inQuotes(rows[i].id)}, where(rows[i])});
  std::vector<std::vector<std::size_t>> children(rows.size() + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto parent = index.find(rows[i].parent);
    if (!rows[i].parent.empty() && parent == index.end())
      throw ShownError({espalier::Shown::tr("the parent %1 is not in the list"),
                        {inQuotes(rows[i].parent)},
                        where(rows[i])});
    children[rows[i].parent.empty() ? rows.size() : parent->second].push_back(i);
  }
  return children;
}

} // namespace

Skeleton skeletonOfRows(const std::vector<NodeRow>& rows, const Where& where) {
  std::vector<std::vector<std::size_t>> children = childrenOf(rows, where);
  Skeleton result;
  std::vector<std::optional<NodeId>> ids(rows.size() + 1); // the last: parent of the roots
  std::vector<std::size_t> order = {rows.size()};
  for (std::size_t next = 0; next < order.size(); ++next) {
    std::vector<std::size_t>& below = children[order[next]];
    // So none is put in before others that are there already: that takes long where many are.
    // (Not std::ranges::stable_partition: Clang 14 cannot compile that of GCC 12's library.)
    std::stable_partition(below.begin(), below.end(),
                          [&](std::size_t i) { return rows[i].node.edge == EdgeType::successor; });
    for (const std::size_t child : below) {
      Node node = rows[child].node;
      if (!isInRange(node.position, node.radius)) throw outOfRange(where(rows[child]));
      node.parent = ids[order[next]];
      if (!node.parent) node.edge = EdgeType::successor; // without meaning for a root
      ids[child] = result.add(node);
      order.push_back(child);
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!ids[i])
      throw ShownError(
          {espalier::Shown::tr("the node is among its own ancestors: correct its parent"),
           {},
           where(rows[i])});
  return result;
}

ShownMessage noteOnAxes(const std::string& file) {
  return {espalier::Shown::tr("has no edge types: the child that carries most continues each axis"),
          {},
          FilePlace{file}};
}

} // namespace espalier
