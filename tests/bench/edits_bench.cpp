// Times each edit by hand, and each choice by structure, in a plant of 20 000 nodes. With the delta
// and without the redraw; the edit is taken back between the rounds, which does not count.
#include "core/simulate/plant_grower.h"
#include "core/skeleton/duplicates.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/tree_edits.h"
#include "ui/document/selection.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>

namespace espalier {
namespace {

const Skeleton& plant() {
  static const Skeleton skeleton = // which has about 20 000 nodes
      growPlant({.segments = 3'000}, 1);
  return skeleton;
}

NodeId root() {
  static const NodeId found = plant().roots().front();
  return found;
}

/// The node that is farthest from its root, in edges.
NodeId deepest() {
  static const NodeId found = plant().ids().back();
  return found;
}

/// A node that carries about half of the plant.
NodeId middle() {
  static const NodeId found = [] {
    NodeId best = root();
    for (const NodeId id : upstream(plant(), {deepest()}))
      if (downstream(plant(), {id}).size() <= 11'000) best = id;
    return best;
  }();
  return found;
}

const std::vector<NodeId>& all() {
  static const std::vector<NodeId> nodes = plant().ids();
  return nodes;
}

const std::vector<NodeId>& path() {
  static const std::vector<NodeId> nodes = pathBetween(plant(), root(), deepest());
  return nodes;
}

const std::vector<NodeId>& half() {
  static const std::vector<NodeId> nodes = downstream(plant(), {middle()});
  return nodes;
}

void time(benchmark::State& state, const std::function<void(SkeletonEditor&)>& change) {
  Skeleton skeleton = plant();
  (void)path(), (void)all(), (void)middle(); // made before the clock starts
  for (auto _ : state) {
    SkeletonEditor editor(skeleton);
    change(editor);
    const SkeletonDelta delta = editor.commit();
    state.PauseTiming();
    delta.inverse().apply(skeleton);
    state.ResumeTiming();
  }
}

using Choose = std::function<std::vector<NodeId>()>;

/// What is chosen is selected, too.
void timeChoice(benchmark::State& state, const Choose& choose) {
  (void)half();
  Selection selection;
  std::size_t chosen = 0;
  for (auto _ : state) {
    selection.set({});
    selection.set(choose());
    chosen = selection.nodes().size();
  }
  state.counters["nodes"] = static_cast<double>(chosen);
}

void addEdits() {
  using Change = std::function<void(SkeletonEditor&)>;
  const std::vector<std::pair<const char*, Change>> edits = {
      {"moveNode",
       [](SkeletonEditor& e) {
         moveNode(e, deepest(), {1, 2, 3});
       }},
      {"moveAllNodes",
       [](SkeletonEditor& e) {
         moveAll(e, {1, 2, 3});
       }},
      {"addChild",
       [](SkeletonEditor& e) {
         addChild(e, deepest(), {1, 2, 3});
       }},
      {"splitEdge", [](SkeletonEditor& e) { splitEdge(e, deepest(), 0.5); }},
      {"removeNode", [](SkeletonEditor& e) { removeNode(e, middle()); }},
      {"removeHalfThePlant", [](SkeletonEditor& e) { removeSubtree(e, middle()); }},
      {"reparentNode", [](SkeletonEditor& e) { reparentNode(e, deepest(), root()); }},
      {"swapSuccessor",
       [](SkeletonEditor& e) { swapSuccessor(e, *e.skeleton()[middle()].parent); }},
      {"cutOffHalfThePlant", [](SkeletonEditor& e) { cutOff(e, middle()); }},
      {"rerootAtATip", [](SkeletonEditor& e) { reroot(e, deepest()); }},
      {"cutAndJoin",
       [](SkeletonEditor& e) {
         cutOff(e, middle());
         joinTree(e, middle(), nearestInOtherTree(e.skeleton(), middle()));
       }},
      {"mergeAPath", [](SkeletonEditor& e) { mergeNodes(e, path()); }},
      {"straightenAPath", [](SkeletonEditor& e) { straighten(e, path()); }},
      {"interpolateRadiiOfAPath", [](SkeletonEditor& e) { interpolateRadii(e, path()); }},
      {"thinOutAPath", [](SkeletonEditor& e) { thinOut(e, path()); }},
      {"smoothAll", [](SkeletonEditor& e) { smooth(e, all(), meanEdgeLength(e.skeleton())); }},
      {"resampleAllToHalf",
       [](SkeletonEditor& e) { resample(e, all(), 2 * meanEdgeLength(e.skeleton())); }},
  };
  for (const auto& [name, change] : edits)
    benchmark::RegisterBenchmark(name, time, change)->Unit(benchmark::kMillisecond);
}

void addChoices() {
  const std::vector<std::pair<const char*, Choose>> choices = {
      {"selectDownstream", [] { return downstream(plant(), {middle()}); }},
      {"selectToRoot", [] { return upstream(plant(), {deepest()}); }},
      {"selectAxis", [] { return axesThrough(plant(), {middle()}); }},
      {"selectOrder", [] { return ofSameOrder(plant(), {middle()}); }},
      {"selectTree", [] { return treesOf(plant(), {middle()}); }},
      {"selectInverted", [] { return inverted(plant(), half()); }},
      {"selectSimilarRadius", [] { return ofSimilarRadius(plant(), {middle()}, 0.2); }},
      {"selectPath", [] { return pathBetween(plant(), root(), deepest()); }},
      {"growSelection", [] { return grown(plant(), half()); }},
      {"shrinkSelection", [] { return shrunk(plant(), half()); }},
      {"selectDuplicatedNodes",
       [] { return duplicatedNodes(plant(), duplicateTolerance(plant())); }},
      {"selectDuplicatedBranches",
       [] { return duplicatedBranches(plant(), 2 * duplicateTolerance(plant())); }},
  };
  for (const auto& [name, choose] : choices)
    benchmark::RegisterBenchmark(name, timeChoice, choose)->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool areAdded = [] {
  addEdits();
  addChoices();
  return true;
}();

} // namespace
} // namespace espalier
