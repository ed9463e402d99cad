#pragma once

#include "core/skeleton/label_index.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// A value of a feature of an MTG, as it is written. Never evaluated.
struct FeatureValue {
  std::string feature;
  std::string text;      // not empty
  std::string type = {}; // of a feature added by hand, as "REAL"; empty: the file declares it

  bool operator==(const FeatureValue&) const = default;
};

/// What an MTG says of a vertex beyond its place in the plant.
///
/// The node that an entity of a coarser scale starts at carries it: every node belongs to those
/// that start at it, and for the other scales to those its parent belongs to. So a new node joins
/// the units it grows in, and marking a node begins a unit there. A node that carries any entity
/// carries its own as the last. A unit in several separate parts starts at each of them, with its
/// values at the first.
struct Entity {
  int scale = 1;                         // larger is finer; the node's own entity has the finest
  std::string symbol;                    // its class, as "U"
  std::optional<LabelIndex> index;       // as the 3 of "U3"
  std::string alias = {};                // its name in the file, if it has one
  std::vector<FeatureValue> values = {}; // but for position and radius
  std::vector<std::vector<FeatureValue>> later = {}; // at later dates, in order

  bool operator==(const Entity&) const = default;
};

} // namespace espalier
