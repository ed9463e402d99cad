#include "core/base/random.h"
#include "core/skeleton/skeleton_delta.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace espalier {
namespace {

/// Some change of any kind that an editor can make.
void editAtRandom(SkeletonEditor& editor, Random& random) {
  const std::vector<NodeId> ids = editor.skeleton().ids();
  const NodeId id = ids[random.below(ids.size())];
  const NodeId other = ids[random.below(ids.size())];
  switch (random.below(8)) {
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
    editor.add({.position = random.direction(), .parent = id});
    break;
  case 4:
    editor.makeRoot(id);
    break;
  case 5:
    if (editor.skeleton().children(id).empty()) editor.erase(id);
    break;
  case 6:
    editor.setEntities(id,
                       {{.scale = 2, .symbol = "N", .index = static_cast<int>(random.below(5))}});
    break;
  default:
    if (!editor.skeleton().isAncestor(id, other)) editor.reparent(id, other, EdgeType::successor);
  }
}

TEST(SkeletonDelta, AndItsInverseAreExactForAnyEdit) {
  Random random(1);
  Skeleton plant = test::randomPlant(60, 2);
  for (int round = 0; round < 500; ++round) {
    const Skeleton before = plant;
    SkeletonEditor editor(plant);
    for (std::size_t step = 0; step < 1 + random.below(12); ++step)
      editAtRandom(editor, random);
    const SkeletonDelta delta = editor.commit();
    const Skeleton after = plant;
    delta.inverse().apply(plant);
    ASSERT_EQ(plant, before) << "round " << round;
    delta.apply(plant);
    ASSERT_EQ(plant, after) << "round " << round;
    if (plant.size() < 20) plant = test::randomPlant(60, 2);
  }
}

TEST(SkeletonDelta, MergesWithTheNextOne) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    Skeleton plant = test::randomPlant(30, 4);
    const Skeleton start = plant;
    SkeletonDelta merged;
    for (int edit = 0; edit < 4; ++edit) {
      SkeletonEditor editor(plant);
      for (int step = 0; step < 3; ++step)
        editAtRandom(editor, random);
      merged = merged.then(editor.commit());
    }
    const Skeleton end = plant;
    merged.inverse().apply(plant);
    ASSERT_EQ(plant, start) << "round " << round;
    merged.apply(plant);
    ASSERT_EQ(plant, end) << "round " << round;
  }
}

TEST(SkeletonDelta, OfAnEditThatChangedNothingIsEmpty) {
  Skeleton plant = test::stick(3);
  SkeletonEditor editor(plant);
  editor.setPosition(NodeId{1}, {5, 5, 5});
  editor.setPosition(NodeId{1}, {0, 0, 1});
  editor.erase(editor.add({.parent = NodeId{2}}));
  EXPECT_TRUE(editor.commit().isEmpty());
}

TEST(SkeletonDelta, CostsAsMuchAsTheEdit) {
  Skeleton plant = test::randomPlant(1000, 5);
  SkeletonEditor editor(plant);
  editor.setRadius(NodeId{500}, 1);
  EXPECT_EQ(editor.commit().changes.size(), 1U);
}

TEST(SkeletonEditor, TakesBackAnEditThatThrows) {
  Skeleton plant = test::fork(3);
  const auto failingEdit = [&plant] {
    SkeletonEditor editor(plant);
    editor.setPosition(NodeId{0}, {9, 9, 9});
    editor.add({.parent = NodeId{2}});
    editor.reparent(NodeId{3}, NodeId{2}, EdgeType::successor);
    throw std::runtime_error("in the middle");
  };
  EXPECT_THROW(failingEdit(), std::runtime_error);
  EXPECT_EQ(plant, test::fork(3));
}

} // namespace
} // namespace espalier
