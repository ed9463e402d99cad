#include "tests/support/random_edits.h"

#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/tree_edits.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace espalier::test {
namespace {

/// What an edit by hand is given.
struct Drawn {
  SkeletonEditor& editor;
  Random& random;
  NodeId id{};
  NodeId other{};

  [[nodiscard]] const Skeleton& plant() const { return editor.skeleton(); }
  [[nodiscard]] std::vector<NodeId> path() const { return pathBetween(plant(), id, other); }
  /// Some nodes around `id`.
  [[nodiscard]] std::vector<NodeId> patch() const {
    std::vector<NodeId> nodes = {id};
    for (std::size_t rings = random.below(3); rings > 0; --rings)
      nodes = grown(plant(), nodes);
    return nodes;
  }
};

struct Kind {
  const char* name;
  std::function<void(const Drawn&)> make;
  bool keepsUnits = true;
};

/// Lets a unit that no other node is part of start at a node.
void startUnit(const Drawn& drawn) {
  std::vector<Entity> entities = drawn.plant()[drawn.id].entities;
  if (entities.empty()) entities.push_back({.scale = 3, .symbol = "E"});
  const Entity unit{.scale = 1 + static_cast<int>(drawn.random.below(2)),
                    .symbol = "U",
                    .index = static_cast<int>(drawn.random.below(1'000'000'000)),
                    .values = {{"Color", "green"}}};
  const auto at = std::ranges::lower_bound(entities, unit.scale, {}, &Entity::scale);
  if (at->scale == unit.scale) return;
  entities.insert(at, unit);
  drawn.editor.setEntities(drawn.id, entities);
}

std::vector<Kind> ofOneNode() {
  return {
      {"move", [](const Drawn& d) { moveNode(d.editor, d.id, d.random.direction()); }},
      {"add child", [](const Drawn& d) { addChild(d.editor, d.id, d.random.direction()); }},
      {"split edge", [](const Drawn& d) { splitEdge(d.editor, d.id, d.random.uniform()); }},
      {"remove", [](const Drawn& d) { removeNode(d.editor, d.id); }},
      {"remove subtree",
       [](const Drawn& d) {
         if (downstream(d.plant(), {d.id}).size() < 5) removeSubtree(d.editor, d.id);
       }},
      {"reparent", [](const Drawn& d) { reparentNode(d.editor, d.id, d.other); }, false},
      {"axial", [](const Drawn& d) { setEdgeType(d.editor, d.id, EdgeType::successor); }},
      {"branching", [](const Drawn& d) { setEdgeType(d.editor, d.id, EdgeType::branching); }},
      {"mark", [](const Drawn& d) { d.editor.setMarked(d.id, !d.plant()[d.id].isMarked); }},
      {"start unit", startUnit, false},
  };
}

std::vector<Kind> ofTreesAndPaths() {
  return {
      {"swap successor", [](const Drawn& d) { swapSuccessor(d.editor, d.id); }},
      {"cut off", [](const Drawn& d) { cutOff(d.editor, d.id); }},
      {"join", [](const Drawn& d) { joinTree(d.editor, d.id, d.other); }, false},
      {"join nearest",
       [](const Drawn& d) { joinTree(d.editor, d.id, nearestInOtherTree(d.plant(), d.id)); },
       false},
      {"re-root", [](const Drawn& d) { reroot(d.editor, d.id); }},
      {"reverse path",
       [](const Drawn& d) {
         const std::vector<NodeId> up = upstream(d.plant(), {d.id});
         reversePath(d.editor, up[d.random.below(up.size())], d.id);
       }},
      {"merge", [](const Drawn& d) { mergeNodes(d.editor, d.patch()); }},
      {"straighten", [](const Drawn& d) { straighten(d.editor, d.path()); }},
      {"interpolate radii", [](const Drawn& d) { interpolateRadii(d.editor, d.path()); }},
      {"thin out", [](const Drawn& d) { thinOut(d.editor, d.path()); }},
      {"smooth", [](const Drawn& d) { smooth(d.editor, d.patch(), d.random.uniform(0.1, 2)); }},
      {"resample", [](const Drawn& d) { resample(d.editor, d.patch(), d.random.uniform(0.2, 2)); }},
  };
}

/// A child may be added more often than the other edits take nodes away.
std::vector<Kind> allKinds() {
  std::vector<Kind> kinds = ofOneNode();
  for (Kind& kind : ofTreesAndPaths())
    kinds.push_back(std::move(kind));
  for (int i = 0; i < 4; ++i)
    kinds.push_back(kinds[1]);
  return kinds;
}

} // namespace

HandEdit editByHandAtRandom(SkeletonEditor& editor, Random& random) {
  static const std::vector<Kind> kinds = allKinds();
  const std::vector<NodeId> ids = editor.skeleton().ids();
  if (ids.size() < 5) {
    editor.add({.position = random.direction(), .radius = 0.1});
    return {.name = "add a root"};
  }
  const Drawn drawn{editor, random, ids[random.below(ids.size())], ids[random.below(ids.size())]};
  if (ids.size() > 150) {
    removeSubtree(editor, drawn.id);
    return {.name = "cut back"};
  }
  const Kind& kind = kinds[random.below(kinds.size())];
  try {
    kind.make(drawn);
  } catch (const Error&) {
    return {.name = kind.name, .isRefused = true};
  }
  return {.name = kind.name, .keepsUnits = kind.keepsUnits};
}

void editAtRandom(SkeletonEditor& editor, Random& random) {
  const std::vector<NodeId> ids = editor.skeleton().ids();
  if (ids.size() < 5) {
    editor.add({.position = random.direction(), .radius = 0.1});
    return;
  }
  const NodeId id = ids[random.below(ids.size())];
  const NodeId other = ids[random.below(ids.size())];
  switch (random.below(13)) {
  case 0:
    editor.setPosition(id, random.direction());
    break;
  case 1:
    editor.setRadius(id, random.uniform());
    break;
  case 2:
    editor.setEdge(id, EdgeType::branching);
    break;
  case 3:
    editor.add({.position = random.direction(), .parent = id, .edge = EdgeType::branching});
    break;
  case 4:
    editor.makeRoot(id);
    break;
  case 5:
    if (editor.skeleton().children(id).empty()) editor.erase(id);
    break;
  case 6:
    editor.setEntities(id, {{.scale = 3,
                             .symbol = "U",
                             .index = static_cast<int>(random.below(5)),
                             .values = {{"Date", "1"}}}});
    break;
  case 7:
    editor.setMarked(id, !editor.skeleton()[id].isMarked);
    break;
  case 8:
    editor.setReview(id, {static_cast<ReviewState>(random.below(3)), "seen", "Anna"});
    break;
  case 9:
  case 10:
  case 11:
    editByHandAtRandom(editor, random);
    break;
  default:
    if (!editor.skeleton().isAncestor(id, other)) editor.reparent(id, other, EdgeType::successor);
  }
}

} // namespace espalier::test
