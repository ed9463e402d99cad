#include "core/mtg/mtg_root_units.h"

#include "core/mtg/unit_starts.h"

#include <algorithm>
#include <map>
#include <optional>

namespace espalier {
namespace {

/// The first unit of each scale that nodes carry and the view does not have.
std::map<int, Entity> unitsMadeByHand(const MtgView& view, const Skeleton& edited, int own) {
  std::set<int> known;
  for (const NodeId id : view.skeleton.ids())
    for (const Entity& entity : view.skeleton[id].entities)
      known.insert(entity.scale);
  std::map<int, Entity> first;
  for (const NodeId id : edited.ids()) // roots come first
    for (const Entity& entity : edited[id].entities)
      if (entity.scale < own && !known.contains(entity.scale)) first.emplace(entity.scale, entity);
  return first;
}

std::vector<Entity> wantedUnits(const MtgView& view, const Skeleton& edited) {
  std::vector<Entity> wanted;
  if (!view.skeleton.isEmpty()) wanted = view.skeleton[view.skeleton.roots().front()].entities;
  for (const auto& [scale, unit] : unitsMadeByHand(view, edited, view.scale))
    wanted.insert(std::ranges::lower_bound(wanted, scale, {}, &Entity::scale), unit);
  return wanted;
}

} // namespace

RootUnits withRootUnits(const MtgView& view, const Skeleton& edited) {
  RootUnits result{edited, {}};
  const std::vector<Entity> wanted = wantedUnits(view, edited);
  if (wanted.empty()) return result;
  std::optional<std::vector<Entity>> own; // of the nodes themselves, looked for if one lacks it
  for (const NodeId root : edited.roots()) {
    std::vector<Entity> entities = edited[root].entities;
    if (entities.empty()) {
      if (!own) own = ownEntities(edited);
      entities.push_back({.scale = view.scale, .symbol = (*own)[indexOf(root)].symbol});
      if (wanted.back().scale == view.scale) entities.back().symbol = wanted.back().symbol;
    }
    for (const Entity& each : wanted) {
      const auto at = std::ranges::lower_bound(entities, each.scale, {}, &Entity::scale);
      if (at != entities.end() && at->scale == each.scale) continue;
      entities.insert(at, {.scale = each.scale, .symbol = each.symbol});
      if (each.index) result.toNumber.insert({root, each.scale});
    }
    if (entities != edited[root].entities) result.skeleton.setEntities(root, std::move(entities));
  }
  return result;
}

} // namespace espalier
