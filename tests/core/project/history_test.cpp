#include "core/project/history.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

SkeletonDelta::Change changed(const Skeleton& plant, NodeId id, Node after) {
  return {id, plant[id], std::move(after)};
}

bool fits(const SkeletonDelta& delta, Skeleton plant) {
  return tryToApply(delta, plant);
}

/// Radii 1, 2, 3 ... one after another, at the given times.
History radiiAt(const std::vector<std::int64_t>& times) {
  History history{.skeleton = test::stick(3)};
  for (const std::int64_t time : times) {
    SkeletonEditor editor(history.skeleton);
    editor.setRadius(NodeId{1}, static_cast<double>(++history.position));
    history.steps.push_back({.text = "Radius", .time = time, .delta = editor.commit()});
  }
  return history;
}

TEST(History, GivesTheSkeletonAtEachPosition) {
  const History history = radiiAt({0, 0, 0});
  for (std::size_t position = 1; position <= 3; ++position)
    EXPECT_EQ(skeletonAt(history, position)[NodeId{1}].radius, static_cast<double>(position));
  EXPECT_EQ(skeletonAt(history, 0), test::stick(3));
}

TEST(History, KnowsTheEndOfEachDayButTheLast) {
  const auto dayOf = [](std::int64_t time) { return time / 100; };
  const auto ends = [&](const std::vector<std::int64_t>& times) {
    return endsOfDays(radiiAt(times).steps, dayOf);
  };
  using Ends = std::vector<std::size_t>;
  EXPECT_EQ(ends({}), Ends());
  EXPECT_EQ(ends({110, 120}), Ends()) << "its end is the state now";
  EXPECT_EQ(ends({110, 120, 310, 500}), (Ends{2, 3}));
  EXPECT_EQ(ends({110, 210, 120, 310}), (Ends{3, 2})) << "a clock was set back";
}

TEST(Fits, HoldsForWhatAnEditorMade) {
  Skeleton plant = test::fork(3);
  const Skeleton before = plant;
  SkeletonEditor editor(plant);
  const NodeId added = editor.add({.parent = test::forkTop});
  editor.reparent(NodeId{2}, added, EdgeType::branching);
  const SkeletonDelta delta = editor.commit();
  EXPECT_TRUE(fits(delta, before));
  EXPECT_TRUE(fits(delta.inverse(), plant));
}

TEST(Fits, FailsIfANodeIsNotAsItWas) {
  const Skeleton plant = test::stick(3);
  SkeletonDelta delta;
  delta.changes = {changed(plant, NodeId{1}, plant[NodeId{1}])};
  delta.changes[0].before->radius = 7;
  EXPECT_FALSE(fits(delta, plant));
  delta.changes = {{NodeId{9}, plant[NodeId{1}], plant[NodeId{1}]}};
  EXPECT_FALSE(fits(delta, plant)) << "it is not there at all";
  delta.changes = {{NodeId{1}, std::nullopt, plant[NodeId{1}]}};
  EXPECT_FALSE(fits(delta, plant)) << "it is there already";
}

TEST(Fits, FailsIfLinksWouldGoAround) {
  const Skeleton plant = test::stick(3);
  Node first = plant[NodeId{0}];
  first.parent = NodeId{2};
  SkeletonDelta delta;
  delta.changes = {changed(plant, NodeId{0}, first)};
  EXPECT_FALSE(fits(delta, plant));
  Node own = plant[NodeId{2}];
  own.parent = NodeId{2};
  delta.changes = {changed(plant, NodeId{2}, own)};
  EXPECT_FALSE(fits(delta, plant));
}

TEST(Fits, FailsIfANodeWouldLoseItsParent) {
  const Skeleton plant = test::stick(3);
  SkeletonDelta delta;
  delta.changes = {{NodeId{1}, plant[NodeId{1}], std::nullopt}};
  EXPECT_FALSE(fits(delta, plant)) << "node 2 is attached to it";
  Node lost = plant[NodeId{2}];
  lost.parent = NodeId{8};
  delta.changes = {changed(plant, NodeId{2}, lost)};
  EXPECT_FALSE(fits(delta, plant)) << "there is no node 8";
}

TEST(Fits, FailsIfANodeIsNamedTwiceOrTooFarOff) {
  const Skeleton plant = test::stick(3);
  SkeletonDelta delta;
  delta.changes = {changed(plant, NodeId{2}, plant[NodeId{2}]),
                   changed(plant, NodeId{2}, plant[NodeId{2}])};
  EXPECT_FALSE(fits(delta, plant));
  delta.changes = {{NodeId{0xFFFFFFFF}, std::nullopt, Node{}}};
  EXPECT_FALSE(fits(delta, plant));
}

TEST(TryToApply, LeavesAPlantThatItDoesNotFit) {
  Skeleton plant = test::stick(3);
  SkeletonDelta delta;
  delta.changes = {{NodeId{2}, plant[NodeId{2}], std::nullopt}, {NodeId{1}, std::nullopt, Node{}}};
  EXPECT_FALSE(tryToApply(delta, plant));
  EXPECT_EQ(plant, test::stick(3));
}

TEST(TryToApply, AddsNodesUnderIdsOfTheirOwn) {
  Skeleton plant = test::stick(2);
  SkeletonDelta delta;
  delta.changes = {{NodeId{40}, std::nullopt, Node{.radius = 0.5, .parent = NodeId{1}}}};
  ASSERT_TRUE(tryToApply(delta, plant));
  EXPECT_EQ(plant.size(), 3U);
  EXPECT_EQ(plant[NodeId{40}].radius, 0.5);
}

TEST(EnvelopeAfter, IsThatOfTheLastStepDoneThatChangedIt) {
  History history;
  EXPECT_EQ(envelopeAfter(history), std::nullopt) << "no step changed it";
  history.steps.push_back({.text = "Move"});
  history.steps.push_back({.text = "Ball", .envelope = EnvelopeChange{"cone", "ball"}});
  history.steps.push_back({.text = "Move"});
  EXPECT_EQ(envelopeAfter(history), "cone") << "before the first that is undone";
  history.position = 3;
  EXPECT_EQ(envelopeAfter(history), "ball");
  history.steps.push_back({.text = "None", .envelope = EnvelopeChange{"ball", ""}});
  EXPECT_EQ(envelopeAfter(history), "ball");
  history.position = 4;
  EXPECT_EQ(envelopeAfter(history), "");
}

} // namespace
} // namespace espalier
