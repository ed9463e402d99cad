#include "core/mtg/mtg_units.h"

#include <algorithm>
#include <set>
#include <utility>

namespace espalier {

UnitTable::UnitTable(const Skeleton& skeleton, std::vector<int> scales, int nodeScale)
    : scales_(std::move(scales)), table_(skeleton.idEnd() * scales_.size(), 0) {
  const std::size_t width = scales_.size();
  for (const NodeId id : skeleton.ids()) { // parents first
    const Node& node = skeleton[id];
    const auto row = table_.begin() + static_cast<std::ptrdiff_t>(indexOf(id) * width);
    if (node.parent)
      std::copy_n(table_.begin() + static_cast<std::ptrdiff_t>(indexOf(*node.parent) * width),
                  width, row);
    for (std::size_t i = 0; i < node.entities.size(); ++i) {
      if (node.entities[i].scale >= nodeScale) continue;
      const auto found = std::ranges::lower_bound(scales_, node.entities[i].scale);
      if (found == scales_.end() || *found != node.entities[i].scale) continue;
      const auto scale = found - scales_.begin();
      units_.push_back({id, i, static_cast<std::size_t>(scale)});
      row[scale] = static_cast<std::uint32_t>(units_.size());
    }
  }
}

std::optional<std::size_t> UnitTable::at(NodeId id, std::size_t scale) const {
  const std::uint32_t entry = table_[indexOf(id) * scales_.size() + scale];
  return entry == 0 ? std::nullopt : std::optional<std::size_t>(entry - 1);
}

std::optional<std::size_t> UnitTable::below(const Skeleton& skeleton, NodeId id,
                                            std::size_t scale) const {
  const auto parent = skeleton[id].parent;
  return parent ? at(*parent, scale) : std::nullopt;
}

std::vector<int> unitScales(const Skeleton& skeleton, int nodeScale) {
  std::set<int> scales;
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities)
      if (entity.scale < nodeScale) scales.insert(entity.scale);
  return {scales.begin(), scales.end()};
}

} // namespace espalier
