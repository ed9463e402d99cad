#include "core/mtg/unit_edits.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/mtg/entity_edits.h"
#include "core/mtg/mtg_scale_shift.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_units.h"
#include "core/mtg/typed_values.h"
#include "core/mtg/unit_scales.h"
#include "core/mtg/unit_starts.h"

#include <algorithm>
#include <optional>
#include <set>

namespace espalier {
namespace {

std::string nameOf(const Entity& entity) {
  return entity.symbol + (entity.index ? entity.index->text() : "");
}

/// The scale of a class, none if it is new here.
std::optional<int> scaleOfClass(const std::string& symbol, const Skeleton& skeleton,
                                const Mtg* base) {
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities)
      if (entity.symbol == symbol) return entity.scale;
  if (base == nullptr) return std::nullopt;
  const auto found = std::ranges::find(base->classes, symbol, &MtgClass::symbol);
  if (found == base->classes.end()) return std::nullopt;
  const int scale = openedView(*base).scale;
  return ScaleShift(*base, scale, skeleton)(found->scale);
}

std::optional<std::size_t> complexAt(const UnitTable& table, NodeId id, std::size_t scale) {
  while (scale-- > 0)
    if (const auto unit = table.at(id, scale)) return unit;
  return std::nullopt;
}

/// A unit that begins at `id`, like the one that goes on there.
Entity nextUnit(const Skeleton& skeleton, NodeId id, int scale) {
  const int own = nodeScale(skeleton);
  const UnitTable table(skeleton, unitScales(skeleton, own), own);
  const auto place = std::size_t(std::ranges::find(table.scales(), scale) - table.scales().begin());
  const auto entityOf = [&](const UnitTable::Unit& unit) -> const Entity& {
    return skeleton[unit.start].entities[unit.entity];
  };
  Entity result{.scale = scale};
  bool hasIndex = false;
  if (const auto unit = table.at(id, place)) {
    result.symbol = entityOf(table.units()[*unit]).symbol;
    hasIndex = entityOf(table.units()[*unit]).index.has_value();
  }
  IndicesInUse inUse;
  for (const UnitTable::Unit& unit : table.units()) {
    if (unit.scale != place) continue;
    const Entity& entity = entityOf(unit);
    if (result.symbol.empty()) result.symbol = entity.symbol;
    if (entity.symbol == result.symbol && entity.index &&
        complexAt(table, unit.start, place) == complexAt(table, id, place))
      inUse.take(*entity.index);
  }
  if (hasIndex) result.index = inUse.next();
  return result;
}

} // namespace

std::vector<UnitPlace> unitsOf(const Skeleton& skeleton, NodeId id) {
  std::set<int> seen;
  std::vector<std::pair<int, UnitPlace>> found;
  for (std::optional<NodeId> at = id; at; at = skeleton[*at].parent) {
    const std::vector<Entity>& entities = skeleton[*at].entities;
    for (std::size_t i = 0; i + 1 < entities.size(); ++i)
      if (seen.insert(entities[i].scale).second) found.push_back({entities[i].scale, {*at, i}});
  }
  std::ranges::sort(found, {}, [](const auto& each) { return each.first; });
  std::vector<UnitPlace> result;
  result.reserve(found.size());
  for (const auto& each : found)
    result.push_back(each.second);
  return result;
}

Entity ownEntity(const Skeleton& skeleton, NodeId id) {
  const std::vector<Entity>& entities = skeleton[id].entities;
  return entities.empty() ? ownEntities(skeleton)[indexOf(id)] : entities.back();
}

Entity entityAt(const Skeleton& skeleton, NodeId id, int scale) {
  const std::vector<Entity>& entities = skeleton[id].entities;
  const auto at = std::ranges::find(entities, scale, &Entity::scale);
  return at == entities.end() ? ownEntity(skeleton, id) : *at;
}

void beginUnit(SkeletonEditor& editor, NodeId id, int scale) {
  const std::vector<Entity>& entities = editor.skeleton()[id].entities;
  const auto found = std::ranges::find(entities, scale, &Entity::scale);
  if (found != entities.end())
    throw ShownError({Shown::tr("%1 begins at node %2 already: choose a node further on"),
                      {nameOf(*found), std::to_string(indexOf(id))}});
  startUnits(editor, {{id, nextUnit(editor.skeleton(), id, scale)}});
}

void endUnit(SkeletonEditor& editor, NodeId id, int scale) {
  std::vector<Entity> entities = editor.skeleton()[id].entities;
  const auto found = std::ranges::find(entities, scale, &Entity::scale);
  if (found == entities.end() || found + 1 == entities.end())
    throw ShownError(
        {Shown::tr("no unit of scale %1 begins at node %2: choose the node it begins at"),
         {std::to_string(scale), std::to_string(indexOf(id))}});
  if (!editor.skeleton()[id].parent)
    throw ShownError({Shown::tr("node %1 is a root, where its units begin: choose a node above it"),
                      {std::to_string(indexOf(id))}});
  if (found != entities.begin())
    throw ShownError(
        {Shown::tr(
             "%1 begins at node %2 too, and units do not reach beyond it: join that one first"),
         {nameOf(entities.front()), std::to_string(indexOf(id))}});
  entities.erase(found);
  editor.setEntities(id, std::move(entities));
}

void setClass(SkeletonEditor& editor, NodeId id, int scale, const std::string& symbol,
              const Mtg* base) {
  const std::string typed = typedSymbol(symbol);
  const auto known = scaleOfClass(typed, editor.skeleton(), base);
  if (known && *known != scale)
    throw ShownError(
        {Shown::tr("the class %1 is of scale %2, this is of scale %3: choose another symbol"),
         {typed, std::to_string(*known), std::to_string(scale)}});
  changeEntity(editor, id, scale, [&](Entity& entity) { entity.symbol = typed; });
}

void setIndex(SkeletonEditor& editor, NodeId id, int scale, const std::string& index) {
  const std::string_view text = trimmed(index);
  const std::optional<LabelIndex> typed = LabelIndex::in(text);
  if (!typed && !text.empty())
    throw ShownError({Shown::tr("%1 is no index: type a whole number, such as 3, two parted by a "
                                "dot, such as 16.1, or nothing"),
                      {inQuotes(text)}});
  changeEntity(editor, id, scale, [&](Entity& entity) { entity.index = typed; });
}

void setAlias(SkeletonEditor& editor, NodeId id, int scale, const std::string& alias) {
  const std::string typed = typedAlias(alias);
  const Entity own = entityAt(editor.skeleton(), id, scale);
  const auto isSameUnit = [&](const Entity& each) { // which carries its name at each of its parts
    return each.scale == own.scale && each.symbol == own.symbol && each.index == own.index &&
           each.alias == own.alias;
  };
  for (const NodeId node : editor.skeleton().ids())
    for (const Entity& each : editor.skeleton()[node].entities)
      if (!typed.empty() && each.alias == typed && !isSameUnit(each))
        throw ShownError({Shown::tr("%1 is the alias of %2 at node %3 already: choose another one"),
                          {inQuotes(typed), nameOf(each), std::to_string(indexOf(node))}});
  changeEntity(editor, id, scale, [&](Entity& entity) { entity.alias = typed; });
}

} // namespace espalier
