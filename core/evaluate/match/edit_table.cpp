#include "core/evaluate/match/edit_table.h"

#include "core/base/text.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace espalier {
namespace {

using Row = std::vector<std::string>;
using NodeParts = std::vector<std::vector<NodeId>>;

/// Nodes and place of some parts of one plant: four cells.
Row cellsOf(const std::vector<std::size_t>& which, const NodeParts& parts,
            const Skeleton& skeleton) {
  Row four(4);
  for (const std::size_t part : which)
    for (const NodeId id : parts[part])
      four[0] += (four[0].empty() ? "" : " ") + std::to_string(indexOf(id));
  if (which.empty()) return four;
  const Eigen::Vector3d top = skeleton[parts[which.back()].back()].position;
  for (int axis = 0; axis < 3; ++axis)
    four[static_cast<std::size_t>(axis) + 1] = plainDecimal(top[axis]);
  return four;
}

std::string kindOf(const EditMatch& match) {
  if (match.first.size() > 1) return "merged";
  return match.second.size() > 1 ? "split" : "matched";
}

/// The parts that no match has.
std::vector<std::size_t> left(std::size_t count, const std::vector<EditMatch>& matches,
                              std::vector<std::size_t> EditMatch::*side) {
  std::vector<bool> isMatched(count);
  for (const EditMatch& match : matches)
    for (const std::size_t part : match.*side)
      isMatched[part] = true;
  std::vector<std::size_t> parts(count);
  std::iota(parts.begin(), parts.end(), std::size_t{0});
  std::erase_if(parts, [&](std::size_t part) { return isMatched[part]; });
  return parts;
}

} // namespace

std::vector<Row> editTable(const EditComparison& edit, const Skeleton& result,
                           const Skeleton& reference) {
  std::vector<Row> rows = {{"edit", "result", "result_x", "result_y", "result_z", "reference",
                            "reference_x", "reference_y", "reference_z", "cost"}};
  const auto add = [&](const std::string& kind, const std::vector<std::size_t>& first,
                       const std::vector<std::size_t>& second, const std::string& cost) {
    Row row = {kind};
    for (const Row& cells :
         {cellsOf(first, edit.result, result), cellsOf(second, edit.reference, reference)})
      row.insert(row.end(), cells.begin(), cells.end());
    row.push_back(cost);
    rows.push_back(std::move(row));
  };
  const std::vector<EditMatch>& matches = edit.distance.matches;
  for (const EditMatch& match : matches)
    add(kindOf(match), match.first, match.second, plainDecimal(match.cost));
  for (const std::size_t part : left(edit.result.size(), matches, &EditMatch::first))
    add("removed", {part}, {}, "");
  for (const std::size_t part : left(edit.reference.size(), matches, &EditMatch::second))
    add("inserted", {}, {part}, "");
  return rows;
}

} // namespace espalier
