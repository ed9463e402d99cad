#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/skeleton_delta.h"
#include "tests/support/plants.h"
#include "tests/support/random_edits.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace espalier {
namespace {

using test::editAtRandom;

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

TEST(SkeletonEditor, SaysThatARadiusIsSetByHand) {
  Skeleton plant = test::stick(3);
  const RadiusOrigin measured{RadiusSource::measured, 0.5F, 2};
  plant.setRadius(NodeId{1}, 0.2, measured);
  SkeletonEditor editor(plant);
  editor.setRadius(NodeId{1}, 0.3);
  EXPECT_EQ(plant[NodeId{1}].origin.source, RadiusSource::byHand);
  editor.commit().inverse().apply(plant);
  EXPECT_EQ(plant[NodeId{1}].origin, measured);
  const NodeId between = splitEdge(editor, NodeId{1}, 0.5);
  EXPECT_EQ(plant[between].origin, measured);
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

// What is beyond any plant could be saved, but not read again.
TEST(SkeletonEditor, LetsNoNodeBeyondAnyPlant) {
  const Skeleton before = test::stick(3);
  Skeleton plant = before;
  for (const double far : {1.1e12, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
    SkeletonEditor editor(plant);
    EXPECT_THROW(editor.setPosition(NodeId{1}, {0, 0, far}), Error) << far;
    EXPECT_THROW((void)editor.add({.position = {far, 0, 0}}), Error) << far;
    EXPECT_TRUE(editor.commit().isEmpty());
  }
  SkeletonEditor editor(plant);
  EXPECT_THROW(editor.setRadius(NodeId{1}, 1e13), Error);
  EXPECT_TRUE(editor.commit().isEmpty());
  EXPECT_EQ(plant, before);
}

} // namespace
} // namespace espalier
