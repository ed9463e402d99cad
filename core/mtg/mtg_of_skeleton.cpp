#include "core/mtg/mtg_of_skeleton.h"

#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/unit_scales.h"

#include <algorithm>
#include <map>

namespace espalier {
namespace {

Skeleton withUnits(const Skeleton& skeleton, MtgStyle style) {
  Skeleton result = skeleton;
  const bool hasAxes = style == MtgStyle::plantAxisNode;
  const Entity node{.scale = hasAxes ? 3 : 2, .symbol = "N", .index = std::nullopt};
  int plants = 0;
  std::map<NodeId, int> axes; // by root
  std::vector<NodeId> roots(skeleton.idEnd());
  for (const NodeId id : skeleton.ids()) {
    const auto parent = skeleton[id].parent;
    roots[indexOf(id)] = parent ? roots[indexOf(*parent)] : id;
    std::vector<Entity> entities;
    if (!parent) entities.push_back({.scale = 1, .symbol = "P", .index = ++plants});
    if (hasAxes && (!parent || skeleton[id].edge == EdgeType::branching))
      entities.push_back({.scale = 2, .symbol = "A", .index = ++axes[roots[indexOf(id)]]});
    entities.push_back(node);
    result.setEntities(id, std::move(entities));
  }
  return result;
}

/// An MTG of these classes without any vertex.
Mtg frameOf(const Skeleton& skeleton) {
  std::map<int, std::vector<std::string>> symbols;
  for (const NodeId id : skeleton.ids())
    for (const Entity& entity : skeleton[id].entities) {
      std::vector<std::string>& known = symbols[entity.scale];
      if (std::ranges::find(known, entity.symbol) == known.end()) known.push_back(entity.symbol);
    }
  if (symbols.empty()) symbols = {{1, {"P"}}, {2, {"N"}}};
  Mtg mtg;
  mtg.classes.push_back({.symbol = "$", .scale = 0, .definition = "IMPLICIT"});
  for (const auto& [scale, classes] : symbols)
    for (const std::string& symbol : classes)
      mtg.classes.push_back({.symbol = symbol, .scale = scale});
  if (symbols.size() > 1) symbols.erase(symbols.begin()); // plants are not linked
  for (const auto& [scale, classes] : symbols)
    for (const std::string& symbol : classes)
      for (const char* edge : {"<", "+"})
        mtg.rules.push_back({symbol, symbol, edge, "?"});
  for (const char* feature : {"XX", "YY", "ZZ", "radius"})
    mtg.features.push_back({feature, "REAL"});
  return mtg;
}

} // namespace

bool hasScales(const Structure& structure) {
  if (structure.skeleton.isEmpty()) return isWithoutPositions(structure);
  return structure.frame || hasEntities(structure.skeleton);
}

bool isWithoutPositions(const Structure& structure) {
  return structure.frame && structure.skeleton.isEmpty() &&
         !hasPositions(structure.frame->mtg, "MTG");
}

Mtg mtgOf(const Skeleton& skeleton, MtgStyle style) {
  const Skeleton plant = hasEntities(skeleton) ? skeleton : withUnits(skeleton, style);
  const Mtg frame = frameOf(plant);
  MtgView view;
  view.scale = frame.classes.back().scale;
  return withEdits(frame, view, plant);
}

} // namespace espalier
