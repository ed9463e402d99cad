#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton_delta.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

// Edits of features: what is typed is taken as it is, or refused by an Error of one sentence.
// `base` is the MTG that the skeleton is a view of, none for one that was made here; it states the
// types of features. pre, of all: nodes are contained, and some node carries entities.

/// Features added by hand, which `base` does not declare, in the order of nodes. Their values carry
/// their types (FeatureValue::type), so that an undo takes the feature back with its last value,
/// and a file that is written declares them.
/// Time O(nodes).
[[nodiscard]] std::vector<MtgFeature> addedFeatures(const Skeleton& skeleton, const Mtg* base);

/// Features that can be typed for an entity: those of `base`, then those of `added`, and ones that
/// the entity has beside them, as text; without the name in the file, and without position and
/// radius: those of nodes have fields of their own, units have some only if a file says so.
[[nodiscard]] std::vector<MtgFeature> typedFeatures(const Entity& entity, bool isNode,
                                                    const Mtg* base,
                                                    const std::vector<MtgFeature>& added = {});

/// The same for its values at a later date: position and radius too, where it has them then.
/// pre: date <= entity.later.size(); that is a date to come
[[nodiscard]] std::vector<MtgFeature> typedFeaturesLater(const Entity& entity, std::size_t date,
                                                         const Mtg* base,
                                                         const std::vector<MtgFeature>& added = {});

/// What is typed of a feature: where it goes, and the text.
struct TypedFeature {
  MtgFeature feature;
  std::string text;
  std::optional<std::size_t> date = {}; // place in Entity::later; its size adds a date
};

/// Changes the value of a feature; an empty text takes it away. A later date goes with its last
/// value.
/// @throws Error if it is not of the type of the feature (typedValue)
void setFeature(SkeletonEditor& editor, NodeId id, int scale, const TypedFeature& typed,
                const Mtg* base);

/// @throws Error if a feature of this name cannot be added: it is no name (typedFeatureName), or
/// known already
void requireNewFeature(const Skeleton& skeleton, const std::string& name, const Mtg* base);

/// Gives an entity a value of a feature that is new to the plant. All entities can have one then.
/// @throws Error as requireNewFeature, if the type is not of those that can be typed
/// (featureTypes), or the value is none of it
void addFeature(SkeletonEditor& editor, NodeId id, int scale, const TypedFeature& typed,
                const Mtg* base);

/// Gives a node itself a value of a feature, known to the plant or not; an empty text takes it
/// away. A skeleton without entities gets them first (ensureEntities).
/// @throws Error as addFeature, or as setFeature
void setNodeFeature(SkeletonEditor& editor, NodeId id, const TypedFeature& typed, const Mtg* base);

/// The nodes that have a value of a feature themselves, in order of their ids. Time O(nodes).
[[nodiscard]] std::vector<NodeId> nodesWithFeature(const Skeleton& skeleton,
                                                   const std::string& feature);

} // namespace espalier
