#include "core/skeleton/keep_units.h"

#include <algorithm>
#include <map>
#include <utility>

namespace espalier {
namespace {

/// A unit, and where it starts.
struct Start {
  NodeId node;
  Entity unit;
};

/// What a unit in several parts says at all but the first.
Entity nameAlone(Entity unit) {
  unit.values.clear();
  unit.later.clear();
  return unit;
}

/// The units of a node that do not start at it, one of each scale. Time O(depth).
std::vector<Start> inheritedUnits(const Skeleton& skeleton, NodeId id) {
  std::vector<int> seen;
  std::vector<Start> result;
  for (std::optional<NodeId> at = id; at; at = skeleton[*at].parent) {
    const std::vector<Entity>& entities = skeleton[*at].entities;
    for (std::size_t i = 0; i + 1 < entities.size(); ++i) { // the last is its own
      if (std::ranges::find(seen, entities[i].scale) != seen.end()) continue;
      seen.push_back(entities[i].scale);
      if (*at != id) result.push_back({*at, entities[i]});
    }
  }
  return result;
}

/// Lets a coarser unit start at `id` too, unless one of its scale does.
/// @param own  the entity of a node that it started at, whose class `id` gets if it has none
/// @return whether it starts there now
bool startUnit(SkeletonEditor& editor, NodeId id, const Entity& unit, const Entity& own) {
  std::vector<Entity> entities = editor.skeleton()[id].entities;
  if (entities.empty()) entities.push_back({.scale = own.scale, .symbol = own.symbol});
  const auto at = std::ranges::lower_bound(entities, unit.scale, {}, &Entity::scale);
  if (at != entities.end() && at->scale == unit.scale) return false;
  entities.insert(at, unit);
  editor.setEntities(id, std::move(entities));
  return true;
}

bool isPartOf(const Entity& part, const Entity& unit) {
  return part.scale == unit.scale && part.symbol == unit.symbol && part.index &&
         part.index == unit.index && part == nameAlone(part);
}

/// Puts the units of a node of a path where `moved` says; its own entity stays.
void setUnits(SkeletonEditor& editor, NodeId id, std::vector<Entity> units, const Entity* own) {
  const std::vector<Entity>& before = editor.skeleton()[id].entities;
  if (before.empty() && units.empty()) return;
  std::ranges::sort(units, {}, &Entity::scale);
  if (!before.empty())
    units.push_back(before.back());
  else
    units.push_back({.scale = own->scale, .symbol = own->symbol});
  if (units != before) editor.setEntities(id, std::move(units));
}

} // namespace

void passOnUnits(SkeletonEditor& editor, const std::vector<Entity>& entities,
                 const std::vector<NodeId>& children) {
  for (std::size_t i = 0; i + 1 < entities.size(); ++i) {
    Entity unit = entities[i];
    std::optional<NodeId> first; // that starts it
    for (const NodeId child : children) {
      if (first && editor.skeleton()[child].parent == first) continue; // part of it by that
      if (!startUnit(editor, child, unit, entities.back())) continue;
      if (!first) first = child;
      unit = nameAlone(unit); // its further parts carry its name alone
    }
  }
}

void attachInItsUnits(SkeletonEditor& editor, NodeId id, std::optional<NodeId> parent,
                      EdgeType edge) {
  const std::vector<Start> before = inheritedUnits(editor.skeleton(), id);
  if (parent)
    editor.reparent(id, *parent, edge);
  else
    editor.makeRoot(id);
  const std::vector<Start> after = inheritedUnits(editor.skeleton(), id);
  for (const Start& start : before) {
    const bool goesOn = std::ranges::any_of(after, [&](const Start& other) {
      return other.node == start.node && other.unit.scale == start.unit.scale;
    });
    if (!goesOn)
      startUnit(editor, id, nameAlone(start.unit), editor.skeleton()[start.node].entities.back());
  }
}

void joinUnitParts(SkeletonEditor& editor, NodeId id) {
  std::vector<Entity> entities = editor.skeleton()[id].entities;
  if (!editor.skeleton()[id].parent || entities.size() < 2) return;
  const NodeId parent = *editor.skeleton()[id].parent;
  std::vector<Entity> ofParent = editor.skeleton()[parent].entities;
  if (!ofParent.empty()) ofParent.pop_back(); // its own
  for (const Start& start : inheritedUnits(editor.skeleton(), parent))
    ofParent.push_back(start.unit);
  const Entity own = entities.back();
  entities.pop_back();
  const auto isPart = [&](const Entity& part) {
    return std::ranges::any_of(ofParent, [&](const Entity& unit) { return isPartOf(part, unit); });
  };
  // Within a coarser unit of its own, a finer one of the same name is another.
  entities.erase(entities.begin(), std::ranges::find_if_not(entities, isPart));
  entities.push_back(own);
  if (entities != editor.skeleton()[id].entities) editor.setEntities(id, std::move(entities));
}

void reverseUnits(SkeletonEditor& editor, const std::vector<NodeId>& path) {
  const Skeleton& skeleton = editor.skeleton();
  // What is part of a unit on the path is a stretch of it: the unit starts at its other end then.
  std::map<int, std::size_t> ends; // by scale: of the stretch that goes on upward
  std::vector<std::vector<Entity>> units(path.size());
  std::vector<const Entity*> own(path.size(), nullptr); // of a node that a unit comes from
  const auto move = [&](const Entity& unit, const Entity& ofNode) {
    const auto [end, isLast] = ends.emplace(unit.scale, path.size() - 1);
    units[end->second].push_back(unit);
    own[end->second] = &ofNode;
  };
  for (std::size_t i = path.size(); i-- > 0;) {
    const std::vector<Entity>& entities = skeleton[path[i]].entities;
    for (std::size_t k = 0; k + 1 < entities.size(); ++k) {
      move(entities[k], entities.back());
      if (i > 0) ends[entities[k].scale] = i - 1;
    }
  }
  for (const Start& start : inheritedUnits(skeleton, path.front())) {
    const auto end = ends.find(start.unit.scale);
    if (end != ends.end()) // else the whole path is part of it, and stays so
      move(nameAlone(start.unit), skeleton[start.node].entities.back());
  }
  std::vector<Entity> classes; // of new own entities: setting some would leave pointers behind
  classes.reserve(own.size());
  for (const Entity* each : own)
    classes.push_back(each ? *each : Entity{});
  for (std::size_t i = 0; i < path.size(); ++i)
    setUnits(editor, path[i], std::move(units[i]), &classes[i]);
}

} // namespace espalier
