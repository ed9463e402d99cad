#include "core/mtg/unit_edits.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mtg/mtg_geometry.h"
#include "core/mtg/mtg_scale_shift.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_units.h"
#include "core/mtg/mtg_values.h"
#include "core/mtg/typed_values.h"
#include "core/mtg/unit_scales.h"
#include "core/mtg/unit_starts.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <optional>
#include <set>

namespace espalier {
namespace {

std::string nameOf(const Entity& entity) {
  return entity.symbol + (entity.index ? std::to_string(*entity.index) : "");
}

/// Changes the entity of a scale at a node, which gets its own if it carries none.
void changeEntity(SkeletonEditor& editor, NodeId id, int scale,
                  const std::function<void(Entity&)>& change) {
  std::vector<Entity> entities = editor.skeleton()[id].entities;
  if (entities.empty()) entities.push_back(ownEntity(editor.skeleton(), id));
  const auto at = std::ranges::find(entities, scale, &Entity::scale);
  if (at == entities.end())
    throw Error("nothing of scale " + std::to_string(scale) + " begins at node " +
                std::to_string(indexOf(id)) + ": choose the node it begins at");
  change(*at);
  editor.setEntities(id, std::move(entities));
}

bool hasValue(const Entity& entity, const std::string& feature) {
  return std::ranges::find(entity.values, feature, &FeatureValue::feature) != entity.values.end();
}

std::size_t placeOf(const std::string& feature, const Mtg* base) {
  if (base == nullptr) return 0;
  return std::size_t(std::ranges::find(base->features, feature, &MtgFeature::name) -
                     base->features.begin());
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
  const int scale = viewOf(*base, "the MTG that was opened").value.scale;
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
  int highest = 0;
  for (const UnitTable::Unit& unit : table.units()) {
    if (unit.scale != place) continue;
    const Entity& entity = entityOf(unit);
    if (result.symbol.empty()) result.symbol = entity.symbol;
    if (entity.symbol == result.symbol && entity.index &&
        complexAt(table, unit.start, place) == complexAt(table, id, place))
      highest = std::max(highest, *entity.index);
  }
  if (hasIndex && highest < std::numeric_limits<int>::max()) result.index = highest + 1;
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
  for (const auto& each : found)
    result.push_back(each.second);
  return result;
}

Entity ownEntity(const Skeleton& skeleton, NodeId id) {
  const std::vector<Entity>& entities = skeleton[id].entities;
  return entities.empty() ? ownEntities(skeleton)[indexOf(id)] : entities.back();
}

std::vector<MtgFeature> typedFeatures(const Entity& entity, bool isNode, const Mtg* base) {
  std::vector<MtgFeature> result;
  if (base != nullptr) {
    const MtgGeometry geometry(*base);
    std::vector<std::size_t> without;
    for (const auto& feature : {geometry.position[0], geometry.position[1], geometry.position[2],
                                geometry.radius, geometry.diameter})
      if (feature && (isNode || !hasValue(entity, base->features[*feature].name)))
        without.push_back(*feature);
    for (std::size_t i = 0; i < base->features.size(); ++i)
      if (!isAliasFeature(base->features[i]) && std::ranges::find(without, i) == without.end())
        result.push_back(base->features[i]);
  }
  for (const FeatureValue& value : entity.values)
    if (placeOf(value.feature, base) == (base != nullptr ? base->features.size() : 0))
      result.push_back({value.feature, "ALPHA"});
  return result;
}

void beginUnit(SkeletonEditor& editor, NodeId id, int scale) {
  const std::vector<Entity>& entities = editor.skeleton()[id].entities;
  const auto found = std::ranges::find(entities, scale, &Entity::scale);
  if (found != entities.end())
    throw Error(nameOf(*found) + " begins at node " + std::to_string(indexOf(id)) +
                " already: choose a node further on");
  startUnits(editor, {{id, nextUnit(editor.skeleton(), id, scale)}});
}

void endUnit(SkeletonEditor& editor, NodeId id, int scale) {
  std::vector<Entity> entities = editor.skeleton()[id].entities;
  const auto found = std::ranges::find(entities, scale, &Entity::scale);
  const std::string node = "node " + std::to_string(indexOf(id));
  if (found == entities.end() || found + 1 == entities.end())
    throw Error("no unit of scale " + std::to_string(scale) + " begins at " + node +
                ": choose the node it begins at");
  if (!editor.skeleton()[id].parent)
    throw Error(node + " is a root, where its units begin: choose a node above it");
  if (found != entities.begin())
    throw Error(nameOf(entities.front()) + " begins at " + node +
                " too, and units do not reach beyond it: join that one first");
  entities.erase(found);
  editor.setEntities(id, std::move(entities));
}

void setClass(SkeletonEditor& editor, NodeId id, int scale, const std::string& symbol,
              const Mtg* base) {
  const std::string typed = typedSymbol(symbol);
  const auto known = scaleOfClass(typed, editor.skeleton(), base);
  if (known && *known != scale)
    throw Error("the class " + typed + " is of scale " + std::to_string(*known) +
                ", this is of scale " + std::to_string(scale) + ": choose another symbol");
  changeEntity(editor, id, scale, [&](Entity& entity) { entity.symbol = typed; });
}

void setIndex(SkeletonEditor& editor, NodeId id, int scale, const std::string& index) {
  const std::string_view text = trimmed(index);
  std::optional<int> typed;
  if (!text.empty()) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 0)
      throw Error(inQuotes(text) + " is no index: type a whole number, such as 3, or nothing");
    typed = number;
  }
  changeEntity(editor, id, scale, [&](Entity& entity) { entity.index = typed; });
}

void setFeature(SkeletonEditor& editor, NodeId id, int scale, const MtgFeature& feature,
                const std::string& text, const Mtg* base) {
  const std::string value = typedValue(feature, text);
  changeEntity(editor, id, scale, [&](Entity& entity) {
    std::erase_if(entity.values,
                  [&](const FeatureValue& each) { return each.feature == feature.name; });
    if (value.empty()) return;
    const std::size_t place = placeOf(feature.name, base); // values stand in the order of features
    const auto after = std::ranges::find_if(entity.values, [&](const FeatureValue& each) {
      return placeOf(each.feature, base) > place;
    });
    entity.values.insert(after, {feature.name, value});
  });
}

} // namespace espalier
