#include "core/mtg/unit_scales.h"

#include "core/base/shown_message.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_units.h"
#include "core/mtg/typed_values.h"
#include "core/mtg/unit_starts.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace espalier {
namespace {

/// All nodes, axis after axis, from the base of each to its tip.
std::vector<NodeId> alongAxes(const Skeleton& skeleton) {
  std::vector<NodeId> order;
  std::vector<NodeId> bases = skeleton.roots();
  std::ranges::reverse(bases);
  while (!bases.empty()) {
    std::optional<NodeId> at = bases.back();
    bases.pop_back();
    const auto firstBranch = static_cast<std::ptrdiff_t>(bases.size());
    while (at) {
      order.push_back(*at);
      std::optional<NodeId> next;
      for (const NodeId child : skeleton.children(*at))
        if (!next && skeleton[child].edge == EdgeType::successor)
          next = child;
        else
          bases.push_back(child);
      at = next;
    }
    std::reverse(bases.begin() + firstBranch, bases.end());
  }
  return order;
}

void requireFree(const std::string& symbol, const Skeleton& skeleton, const Mtg* base) {
  bool isTaken = base != nullptr &&
                 std::ranges::find(base->classes, symbol, &MtgClass::symbol) != base->classes.end();
  for (const NodeId id : skeleton.ids())
    isTaken = isTaken || std::ranges::find(skeleton[id].entities, symbol, &Entity::symbol) !=
                             skeleton[id].entities.end();
  if (isTaken)
    throw ShownError(
        {espalier::Shown::tr("the plant has a class %1 already: choose another symbol"), {symbol}});
}

void moveScales(SkeletonEditor& editor, int from) {
  for (const NodeId id : editor.skeleton().ids()) {
    std::vector<Entity> entities = editor.skeleton()[id].entities;
    for (Entity& entity : entities)
      if (entity.scale >= from) ++entity.scale;
    if (!entities.empty()) editor.setEntities(id, std::move(entities));
  }
}

/// The units of a scale that begin at `starts`, numbered within each coarser one.
std::vector<std::pair<NodeId, Entity>>
numbered(const Skeleton& skeleton, const std::vector<NodeId>& starts, const Entity& unit) {
  const UnitTable coarser(skeleton, unitScales(skeleton, unit.scale), unit.scale);
  std::map<std::optional<std::size_t>, int> last; // index, by coarser unit
  std::vector<std::pair<NodeId, Entity>> result;
  for (const NodeId id : starts) {
    std::optional<std::size_t> complex;
    for (std::size_t i = coarser.scales().size(); i-- > 0 && !complex;)
      complex = coarser.at(id, i);
    result.emplace_back(id, unit);
    result.back().second.index = ++last[complex];
  }
  return result;
}

/// A unit of each scale, as they begin at the first root; without any node, of the classes.
std::vector<Entity> firstUnits(const Mtg& base) {
  const Skeleton view = openedView(base).skeleton;
  std::map<int, Entity> units;
  const auto add = [&](int scale, const std::string& symbol) {
    if (scale > 0) units.emplace(scale, Entity{.scale = scale, .symbol = symbol});
  };
  if (!view.isEmpty())
    for (const Entity& entity : view[view.roots().front()].entities)
      add(entity.scale, entity.symbol);
  else
    for (const MtgClass& each : base.classes)
      add(each.scale, each.symbol);
  std::vector<Entity> result;
  for (auto& [scale, unit] : units)
    result.push_back(std::move(unit));
  return result;
}

} // namespace

bool hasEntities(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids(); // roots, which begin units, come first
  return std::ranges::any_of(ids, [&](NodeId id) { return !skeleton[id].entities.empty(); });
}

void ensureEntities(SkeletonEditor& editor, const Mtg* base) {
  if (hasEntities(editor.skeleton())) return;
  std::vector<Entity> units = {{.scale = 1, .symbol = "P"}, {.scale = 2, .symbol = "N"}};
  if (base != nullptr) {
    units = firstUnits(*base);
  }
  int plants = 0;
  for (const NodeId root : editor.skeleton().roots()) {
    ++plants;
    if (units.size() > 1) units.front().index = plants;
    editor.setEntities(root, units);
  }
}

void toggleMarks(SkeletonEditor& editor, const std::vector<NodeId>& nodes) {
  const bool areMarked =
      std::ranges::all_of(nodes, [&](NodeId id) { return editor.skeleton()[id].isMarked; });
  for (const NodeId id : nodes)
    editor.setMarked(id, !areMarked);
}

void clearMarks(SkeletonEditor& editor) {
  for (const NodeId id : markedNodes(editor.skeleton()))
    editor.setMarked(id, false);
}

std::vector<NodeId> markedNodes(const Skeleton& skeleton) {
  std::vector<NodeId> marked = skeleton.ids();
  std::erase_if(marked, [&](NodeId id) { return !skeleton[id].isMarked; });
  return marked;
}

int nodeScale(const Skeleton& skeleton) {
  int scale = 0;
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].entities.empty()) scale = std::max(scale, skeleton[id].entities.back().scale);
  return scale == 0 ? 2 : scale;
}

std::vector<int> scalesOf(const Skeleton& skeleton) {
  if (!hasEntities(skeleton)) return {1, 2};
  const int own = nodeScale(skeleton);
  std::vector<int> scales = unitScales(skeleton, own);
  scales.push_back(own);
  return scales;
}

std::vector<NodeId> startsOfNewUnits(const Skeleton& skeleton, int finer) {
  std::vector<NodeId> starts = alongAxes(skeleton);
  std::erase_if(starts, [&](NodeId id) {
    const Node& node = skeleton[id];
    return node.parent && !node.isMarked &&
           (node.entities.empty() || node.entities.front().scale >= finer);
  });
  return starts;
}

std::size_t commitMarks(SkeletonEditor& editor, const NewScale& scale, const Mtg* base) {
  const std::string symbol = typedSymbol(scale.symbol);
  if (markedNodes(editor.skeleton()).empty())
    throw ShownError({espalier::Shown::tr("no node is marked: mark first where units begin")});
  ensureEntities(editor, base);
  requireFree(symbol, editor.skeleton(), base);
  const std::vector<int> scales = scalesOf(editor.skeleton());
  if (scales.size() >= mostScales)
    throw ShownError({espalier::Shown::tr("the plant has %1 scales: there can be no more"),
                      {std::to_string(mostScales)}});
  const int finer = scale.finer.value_or(scales.back());
  assert(std::ranges::binary_search(scales, finer));
  const std::vector<NodeId> starts = startsOfNewUnits(editor.skeleton(), finer);
  moveScales(editor, finer);
  startUnits(editor, numbered(editor.skeleton(), starts, {.scale = finer, .symbol = symbol}));
  clearMarks(editor);
  return starts.size();
}

} // namespace espalier
