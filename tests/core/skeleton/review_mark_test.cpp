#include "core/skeleton/edits.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr NodeId shoot{2}; // of the fork: continues the axis of forkTop

ReviewState stateOf(const Skeleton& plant, NodeId id) {
  return plant[id].review.state;
}

/// The fork with all of its nodes reviewed.
Skeleton reviewedFork() {
  Skeleton plant = test::fork(3);
  for (const NodeId id : plant.ids())
    plant.setReview(id, {ReviewState::reviewed, "looks right", "Anna"});
  return plant;
}

SkeletonDelta marked(Skeleton& plant, const std::function<void(SkeletonEditor&)>& change) {
  SkeletonEditor editor(plant);
  change(editor);
  return editor.commit();
}

TEST(ReviewMark, OfANewNodeIsToDo) {
  Skeleton plant = reviewedFork();
  NodeId added{0};
  marked(plant, [&](SkeletonEditor& editor) { added = addChild(editor, shoot, {2, 0, 3}); });
  EXPECT_EQ(plant[added].review, ReviewMark());
  EXPECT_EQ(stateOf(plant, shoot), ReviewState::reviewed) << "its own edge is as it was";
  marked(plant, [&](SkeletonEditor& editor) { added = editor.add(plant[shoot]); });
  EXPECT_EQ(plant[added].review, ReviewMark()) << "a copy was not looked at";
}

TEST(ReviewMark, IsTakenBackFromANodeThatIsMovedAndKeepsItsComment) {
  Skeleton plant = reviewedFork();
  const SkeletonDelta delta = marked(plant, [](SkeletonEditor& editor) {
    moveNode(editor, shoot, {5, 5, 5});
  });
  EXPECT_EQ(plant[shoot].review, (ReviewMark{ReviewState::toDo, "looks right", ""}));
  EXPECT_EQ(stateOf(plant, test::forkTop), ReviewState::reviewed);
  EXPECT_EQ(delta.changes.size(), 1U);
  delta.inverse().apply(plant);
  EXPECT_EQ(plant, reviewedFork()) << "undo brings the mark back";
}

TEST(ReviewMark, IsTakenBackFromNodesThatAreAttachedElsewhere) {
  Skeleton plant = reviewedFork();
  marked(plant, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{3}, test::forkRoot); });
  EXPECT_EQ(stateOf(plant, NodeId{3}), ReviewState::toDo);
  plant = reviewedFork();
  NodeId between{0};
  marked(plant, [&](SkeletonEditor& editor) { between = splitEdge(editor, shoot, 0.5); });
  EXPECT_EQ(stateOf(plant, between), ReviewState::toDo);
  EXPECT_EQ(stateOf(plant, shoot), ReviewState::toDo) << "its edge is another one";
  plant = reviewedFork();
  marked(plant, [](SkeletonEditor& editor) { removeNode(editor, test::forkTop); });
  for (const NodeId id : {shoot, NodeId{3}, NodeId{4}})
    EXPECT_EQ(stateOf(plant, id), ReviewState::toDo);
  EXPECT_EQ(stateOf(plant, test::forkRoot), ReviewState::reviewed);
}

TEST(ReviewMark, IsTakenBackFromBothBranchesThatChangePlaces) {
  Skeleton plant = reviewedFork();
  marked(plant, [](SkeletonEditor& editor) {
    setEdgeType(editor, NodeId{3}, EdgeType::successor); // and so the shoot branches
  });
  EXPECT_EQ(stateOf(plant, NodeId{3}), ReviewState::toDo);
  EXPECT_EQ(stateOf(plant, shoot), ReviewState::toDo);
  EXPECT_EQ(stateOf(plant, NodeId{4}), ReviewState::reviewed);
}

TEST(ReviewMark, StaysWhereRadiusOrNothingChanges) {
  Skeleton plant = reviewedFork();
  marked(plant, [](SkeletonEditor& editor) { editor.setRadius(shoot, 0.3); });
  EXPECT_EQ(stateOf(plant, shoot), ReviewState::reviewed);
  const SkeletonDelta delta = marked(plant, [&](SkeletonEditor& editor) {
    moveNode(editor, shoot, {5, 5, 5});
    moveNode(editor, shoot, {1, 0, 2}); // where it was
  });
  EXPECT_TRUE(delta.isEmpty());
}

TEST(ReviewMark, ThatTheSameEditSetsStays) {
  Skeleton plant = test::fork(3);
  const ReviewMark mark = {ReviewState::reviewed, "moved onto the points", "Anna"};
  marked(plant, [&](SkeletonEditor& editor) {
    moveNode(editor, shoot, {1, 0, 2.5});
    editor.setReview(shoot, mark);
  });
  EXPECT_EQ(plant[shoot].review, mark);
}

TEST(ReviewMark, OfDoubtOutlivesAMove) {
  Skeleton plant = test::fork(3);
  const ReviewMark doubt = {ReviewState::doubtful, "crosses its neighbor?", "Anna"};
  plant.setReview(shoot, doubt);
  marked(plant, [](SkeletonEditor& editor) { moveNode(editor, shoot, {1, 0, 2.5}); });
  EXPECT_EQ(plant[shoot].review, doubt);
}

} // namespace
} // namespace espalier
