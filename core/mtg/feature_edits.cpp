#include "core/mtg/feature_edits.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/mtg/entity_edits.h"
#include "core/mtg/mtg_geometry.h"
#include "core/mtg/mtg_values.h"
#include "core/mtg/typed_values.h"
#include "core/mtg/unit_scales.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace espalier {
namespace {

bool hasValue(const Entity& entity, const std::string& feature) {
  return std::ranges::find(entity.values, feature, &FeatureValue::feature) != entity.values.end();
}

std::size_t placeOf(const std::string& feature, const Mtg* base) {
  if (base == nullptr) return 0;
  return std::size_t(std::ranges::find(base->features, feature, &MtgFeature::name) -
                     base->features.begin());
}

bool isDeclared(const std::string& feature, const Mtg* base) {
  return base != nullptr && placeOf(feature, base) < base->features.size();
}

bool isNamed(const std::vector<MtgFeature>& features, const std::string& name) {
  return std::ranges::find(features, name, &MtgFeature::name) != features.end();
}

void setValue(std::vector<FeatureValue>& values, const FeatureValue& wanted, const Mtg* base) {
  const auto found = std::ranges::find(values, wanted.feature, &FeatureValue::feature);
  if (found != values.end()) {
    if (wanted.text.empty())
      values.erase(found);
    else
      *found = wanted;
    return;
  }
  if (wanted.text.empty()) return;
  const std::size_t place = placeOf(wanted.feature, base); // values stand in the order of features
  const auto after = std::ranges::find_if(
      values, [&](const FeatureValue& each) { return placeOf(each.feature, base) > place; });
  values.insert(after, wanted);
}

} // namespace

std::vector<MtgFeature> addedFeatures(const Skeleton& skeleton, const Mtg* base) {
  std::vector<MtgFeature> added;
  std::set<std::string> seen;
  const auto look = [&](const std::vector<FeatureValue>& values) {
    for (const FeatureValue& value : values)
      if (!value.type.empty() && seen.insert(value.feature).second &&
          !isDeclared(value.feature, base))
        added.push_back({value.feature, value.type});
  };
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities) {
      look(entity.values);
      for (const std::vector<FeatureValue>& values : entity.later)
        look(values);
    }
  return added;
}

std::vector<MtgFeature> typedFeatures(const Entity& entity, bool isNode, const Mtg* base,
                                      const std::vector<MtgFeature>& added) {
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
  result.insert(result.end(), added.begin(), added.end());
  for (const FeatureValue& value : entity.values)
    if (!isDeclared(value.feature, base) && !isNamed(result, value.feature))
      result.push_back({value.feature, value.type.empty() ? "ALPHA" : value.type});
  return result;
}

std::vector<MtgFeature> typedFeaturesLater(const Entity& entity, std::size_t date, const Mtg* base,
                                           const std::vector<MtgFeature>& added) {
  assert(date <= entity.later.size());
  Entity then;
  if (date < entity.later.size()) then.values = entity.later[date];
  return typedFeatures(then, false, base, added);
}

void setFeature(SkeletonEditor& editor, NodeId id, int scale, const TypedFeature& typed,
                const Mtg* base) {
  const std::string& name = typed.feature.name;
  const FeatureValue value{name, typedValue(typed.feature, typed.text),
                           isDeclared(name, base) ? std::string() : typed.feature.type};
  changeEntity(editor, id, scale, [&](Entity& entity) {
    if (!typed.date) return setValue(entity.values, value, base);
    assert(*typed.date <= entity.later.size());
    if (*typed.date == entity.later.size()) entity.later.emplace_back();
    setValue(entity.later[*typed.date], value, base);
    if (entity.later[*typed.date].empty())
      entity.later.erase(entity.later.begin() + static_cast<std::ptrdiff_t>(*typed.date));
  });
}

void requireNewFeature(const Skeleton& skeleton, const std::string& name, const Mtg* base) {
  const std::string typed = typedFeatureName(name);
  if (isDeclared(typed, base) || isNamed(addedFeatures(skeleton, base), typed))
    throw ShownError({Shown::tr("the plant has a feature %1 already: type its value there, or "
                                "choose another name"),
                      {typed}});
}

void addFeature(SkeletonEditor& editor, NodeId id, int scale, const TypedFeature& typed,
                const Mtg* base) {
  requireNewFeature(editor.skeleton(), typed.feature.name, base);
  TypedFeature added = typed;
  added.feature.name = typedFeatureName(typed.feature.name);
  if (std::ranges::find(featureTypes(), added.feature.type) == featureTypes().end())
    throw ShownError({Shown::tr("%1 is no type of a feature: choose one of the list"),
                      {inQuotes(added.feature.type)}});
  if (trimmed(added.text).empty())
    throw ShownError(
        {Shown::tr("the feature %1 has no value yet: type one"), {added.feature.name}});
  setFeature(editor, id, scale, added, base);
}

void setNodeFeature(SkeletonEditor& editor, NodeId id, const TypedFeature& typed, const Mtg* base) {
  ensureEntities(editor, base);
  const int scale = nodeScale(editor.skeleton());
  const std::string& name = typed.feature.name;
  if (isDeclared(name, base) || isNamed(addedFeatures(editor.skeleton(), base), name))
    setFeature(editor, id, scale, typed, base);
  else if (!typed.text.empty())
    addFeature(editor, id, scale, typed, base);
}

std::vector<NodeId> nodesWithFeature(const Skeleton& skeleton, const std::string& feature) {
  const int scale = nodeScale(skeleton);
  std::vector<NodeId> nodes = skeleton.ids();
  std::erase_if(nodes, [&](NodeId id) {
    const std::vector<Entity>& entities = skeleton[id].entities;
    return entities.empty() || entities.back().scale != scale ||
           !hasValue(entities.back(), feature);
  });
  return nodes;
}

} // namespace espalier
