#include "core/mtg/unit_starts.h"

#include "core/mtg/mtg_units.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

void insert(std::vector<Entity>& entities, const Entity& unit) {
  entities.insert(std::ranges::lower_bound(entities, unit.scale, {}, &Entity::scale), unit);
}

bool hasScale(const std::vector<Entity>& entities, int scale) {
  return std::ranges::find(entities, scale, &Entity::scale) != entities.end();
}

} // namespace

std::vector<Entity> ownEntities(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  const auto carrier =
      std::ranges::find_if(ids, [&](NodeId id) { return !skeleton[id].entities.empty(); });
  Entity first{.scale = 2, .symbol = "N"};
  if (carrier != ids.end())
    first = {.scale = skeleton[*carrier].entities.back().scale,
             .symbol = skeleton[*carrier].entities.back().symbol};
  std::vector<Entity> result(skeleton.idEnd(), first);
  for (const NodeId id : ids) { // parents first
    const Node& node = skeleton[id];
    if (!node.entities.empty()) {
      result[indexOf(id)] = node.entities.back();
    } else if (node.parent) {
      const Entity& parent = result[indexOf(*node.parent)];
      result[indexOf(id)] = {.scale = parent.scale, .symbol = parent.symbol};
    }
  }
  return result;
}

void startUnits(SkeletonEditor& editor, const std::vector<std::pair<NodeId, Entity>>& starts) {
  const std::vector<Entity> own = ownEntities(editor.skeleton());
  int nodeScale = 0;
  for (const NodeId id : editor.skeleton().ids())
    nodeScale = std::max(nodeScale, own[indexOf(id)].scale);
  const UnitTable table(editor.skeleton(), unitScales(editor.skeleton(), nodeScale), nodeScale);
  std::vector<std::pair<NodeId, std::vector<Entity>>> changed;
  for (const auto& [id, unit] : starts) {
    std::vector<Entity> entities = editor.skeleton()[id].entities;
    if (entities.empty()) entities.push_back(own[indexOf(id)]);
    insert(entities, unit);
    for (std::size_t i = 0; i < table.scales().size(); ++i) {
      const auto goesOn = table.at(id, i);
      if (table.scales()[i] <= unit.scale || !goesOn || hasScale(entities, table.scales()[i]))
        continue;
      const UnitTable::Unit& cut = table.units()[*goesOn];
      insert(entities, {.scale = table.scales()[i],
                        .symbol = editor.skeleton()[cut.start].entities[cut.entity].symbol});
    }
    changed.emplace_back(id, std::move(entities));
  }
  for (auto& [id, entities] : changed)
    editor.setEntities(id, std::move(entities));
}

} // namespace espalier
