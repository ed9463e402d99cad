#include "core/project/review_record.h"
#include "core/skeleton/edits.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace espalier {
namespace {

/// A plant that is marked step by step.
struct Marked {
  Skeleton skeleton;
  std::vector<HistoryStep> steps = {};

  void step(const std::function<void(SkeletonEditor&)>& change) {
    SkeletonEditor editor(skeleton);
    change(editor);
    steps.push_back({.delta = editor.commit()});
  }
  void mark(ReviewState state, const std::vector<NodeId>& nodes, const std::string& comment = {}) {
    step([&](SkeletonEditor& editor) {
      for (const NodeId id : nodes)
        editor.setReview(id, {.state = state, .comment = comment});
    });
  }
  [[nodiscard]] ReviewRecord record() const { return reviewRecord(steps, skeleton); }
};

TEST(ReviewRecord, PartsWhatWasLookedAtFromWhatWasMarkedInBulk) {
  // A stem of 10 with two branches of 5: more than two of the longest stretches.
  Skeleton plant = test::stick(11);
  const NodeId left =
      plant.add({.position = {-5, 0, 5}, .parent = NodeId{5}, .edge = EdgeType::branching});
  const NodeId right =
      plant.add({.position = {5, 0, 7}, .parent = NodeId{7}, .edge = EdgeType::branching});
  Marked work{.skeleton = plant};
  std::vector<NodeId> stem = plant.ids();
  std::erase_if(stem, [&](NodeId id) { return id == left || id == right; });
  work.mark(ReviewState::reviewed, stem); // one axis
  work.mark(ReviewState::reviewed, {left, right});
  const ReviewRecord record = work.record();
  EXPECT_EQ(record.lookedAt, (ReviewRecord::Amount{11, 10}));
  EXPECT_EQ(record.inBulk, (ReviewRecord::Amount{2, 10}));
  EXPECT_EQ(record.before, ReviewRecord::Amount());
}

TEST(ReviewRecord, CountsTheLastStepThatMarkedANode) {
  Skeleton plant = test::stick(11);
  const NodeId left =
      plant.add({.position = {-9, 0, 5}, .parent = NodeId{5}, .edge = EdgeType::branching});
  Marked work{.skeleton = plant};
  work.mark(ReviewState::reviewed, plant.ids());
  EXPECT_EQ(work.record().inBulk.nodes, 12U) << "all of two long axes";
  work.mark(ReviewState::toDo, {left});
  EXPECT_EQ(work.record().inBulk.nodes, 11U) << "what is to do was not reviewed by anything";
  work.mark(ReviewState::reviewed, {left});
  EXPECT_EQ(work.record().inBulk.nodes, 11U);
  EXPECT_EQ(work.record().lookedAt, (ReviewRecord::Amount{1, 9}));
}

TEST(ReviewRecord, SaysWhatCameWithThePlant) {
  Marked work{.skeleton = test::stick(3)};
  for (const NodeId id : work.skeleton.ids())
    work.skeleton.setReview(id, {.state = ReviewState::reviewed});
  EXPECT_EQ(work.record().before, (ReviewRecord::Amount{3, 2}));
  work.step([](SkeletonEditor& editor) { editor.setRadius(NodeId{1}, 0.5); });
  EXPECT_EQ(work.record().before, (ReviewRecord::Amount{3, 2})) << "a radius marks nothing";
}

TEST(ReviewRecord, CountsDoubtsThatWereSettledAndPlacesWithAComment) {
  Marked work{.skeleton = test::stick(5)};
  work.mark(ReviewState::doubtful, {NodeId{1}, NodeId{2}, NodeId{4}}, "thin");
  EXPECT_EQ(work.record().doubted.nodes, 0U) << "not yet";
  EXPECT_EQ(work.record().comments, 2U) << "1 and 2 are one place";
  work.mark(ReviewState::reviewed, work.skeleton.ids());
  EXPECT_EQ(work.record().doubted, (ReviewRecord::Amount{3, 3}));
  EXPECT_EQ(work.record().comments, 0U);
}

TEST(ReviewRecord, OfNothingIsNothing) {
  EXPECT_EQ(reviewRecord({}, Skeleton()), ReviewRecord());
}

} // namespace
} // namespace espalier
