// What holds after any edit by hand, whatever was edited before.
#include "tests/support/plants.h"
#include "tests/support/random_edits.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace espalier {
namespace {

constexpr int steps = 10'000;

int successors(const Skeleton& plant, NodeId id) {
  int count = 0;
  for (const NodeId child : plant.children(id))
    if (plant[child].edge == EdgeType::successor) ++count;
  return count;
}

/// By id; 0 where there is no node.
std::vector<int> successorCounts(const Skeleton& plant) {
  std::vector<int> counts(plant.idEnd(), 0);
  for (const NodeId id : plant.ids())
    counts[indexOf(id)] = successors(plant, id);
  return counts;
}

/// The unit of each scale that each node is part of, by its index.
std::map<std::pair<NodeId, int>, std::string> unitsOfAll(const Skeleton& plant) {
  std::map<std::pair<NodeId, int>, std::string> units;
  for (const NodeId id : plant.ids()) {
    const Node& node = plant[id];
    for (const int scale : {1, 2}) {
      if (!node.parent) continue;
      const auto below = units.find({*node.parent, scale});
      if (below != units.end()) units[{id, scale}] = below->second;
    }
    for (std::size_t i = 0; i + 1 < node.entities.size(); ++i)
      units[{id, node.entities[i].scale}] = node.entities[i].index->text();
  }
  return units;
}

void expectForest(const Skeleton& plant) {
  std::set<NodeId> seen;
  for (const NodeId id : plant.ids()) {
    const std::optional<NodeId>& parent = plant[id].parent;
    ASSERT_TRUE(!parent || seen.contains(*parent)) << "of node " << indexOf(id);
    seen.insert(id);
  }
  ASSERT_EQ(seen.size(), plant.size()) << "a cycle or a lost node";
}

void expectLegalEntities(const Skeleton& plant) {
  for (const NodeId id : plant.ids()) {
    const std::vector<Entity>& entities = plant[id].entities;
    if (entities.empty()) continue;
    ASSERT_EQ(entities.back().scale, 3) << "its own comes last, node " << indexOf(id);
    for (std::size_t i = 1; i < entities.size(); ++i)
      ASSERT_LT(entities[i - 1].scale, entities[i].scale) << "node " << indexOf(id);
  }
}

void expectSameUnits(const Skeleton& before, const Skeleton& after) {
  const auto now = unitsOfAll(after);
  for (const auto& [place, unit] : unitsOfAll(before)) {
    if (!after.contains(place.first)) continue;
    const auto at = now.find(place);
    ASSERT_NE(at, now.end()) << "node " << indexOf(place.first) << " left its unit";
    ASSERT_EQ(at->second, unit) << "node " << indexOf(place.first);
  }
}

/// Makes an edit, and checks what holds after any.
SkeletonDelta checkedEdit(Skeleton& plant, Random& random, std::map<std::string, int>& made) {
  const Skeleton before = plant;
  const std::vector<int> counts = successorCounts(plant);
  SkeletonEditor editor(plant);
  const test::HandEdit edit = test::editByHandAtRandom(editor, random);
  const SkeletonDelta delta = editor.commit();
  SCOPED_TRACE(edit.name);
  EXPECT_TRUE(!edit.isRefused || delta.isEmpty()) << "refused after something had changed";
  if (!delta.isEmpty()) ++made[edit.name];
  expectForest(plant);
  expectLegalEntities(plant);
  for (const NodeId id : plant.ids()) {
    const int found = indexOf(id) < counts.size() ? counts[indexOf(id)] : 0;
    EXPECT_LE(successors(plant, id), found + 1) << "node " << indexOf(id);
  }
  if (edit.keepsUnits) expectSameUnits(before, plant);
  return delta;
}

/// Edits that are undone and redone all together, again and again.
void editUndoAndRedo(Skeleton plant, std::uint64_t seed, std::map<std::string, int>& made) {
  Random random(seed);
  Skeleton start = plant;
  std::vector<SkeletonDelta> history;
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    history.push_back(checkedEdit(plant, random, made));
    if (history.size() < 250) continue;
    const Skeleton end = plant;
    for (auto at = history.rbegin(); at != history.rend(); ++at)
      at->inverse().apply(plant);
    ASSERT_EQ(plant, start) << "undone";
    for (const SkeletonDelta& delta : history)
      delta.apply(plant);
    ASSERT_EQ(plant, end) << "redone";
    history.clear();
    start = plant;
  }
}

TEST(EditsByHand, KeepAForestAndUnitsAndAreTakenBackExactly) {
  std::map<std::string, int> made;
  editUndoAndRedo(test::fork(4), 7, made);
  EXPECT_GE(made.size(), 22U) << "each kind of edit was made";
  for (const auto& [name, count] : made)
    EXPECT_GE(count, name == "add a root" || name == "cut back" ? 1 : 20) << name;
}

TEST(EditsByHand, KeepAForestThatHadSeveralSuccessors) {
  std::map<std::string, int> made;
  editUndoAndRedo(test::randomPlant(60, 3), 8, made);
}

TEST(EditsByHand, LeaveOneSuccessorWhereThereWasOne) {
  Random random(9);
  Skeleton plant = test::fork(4);
  for (int step = 0; step < steps; ++step) {
    SkeletonEditor editor(plant);
    const std::string name = test::editByHandAtRandom(editor, random).name;
    (void)editor.commit();
    for (const NodeId id : plant.ids())
      ASSERT_LE(successors(plant, id), 1) << name << " at step " << step;
  }
}

} // namespace
} // namespace espalier
