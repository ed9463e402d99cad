#include "core/base/error.h"
#include "core/radius/radius_edits.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>

namespace espalier {
namespace {

Skeleton edited(Skeleton skeleton, const std::function<void(SkeletonEditor&)>& change) {
  SkeletonEditor editor(skeleton);
  change(editor);
  (void)editor.commit();
  return skeleton;
}

Skeleton stickOf(std::initializer_list<double> radii) {
  Skeleton stick = test::stick(static_cast<int>(radii.size()));
  for (std::size_t i = 0; const double radius : radii)
    stick.setRadius(NodeId(static_cast<std::uint32_t>(i++)), radius);
  return stick;
}

double radiusAt(const Skeleton& skeleton, std::uint32_t id) {
  return skeleton[NodeId{id}].radius;
}

void smoothAll(SkeletonEditor& editor) {
  smoothRadii(editor, editor.skeleton().ids());
}
void limitAll(SkeletonEditor& editor) {
  limitRadii(editor, editor.skeleton().ids());
}

TEST(SmoothRadii, HalvesABump) {
  const Skeleton smoothed = edited(stickOf({4, 4, 8, 4, 4}), smoothAll);
  EXPECT_EQ(radiusAt(smoothed, 2), 6);
  EXPECT_EQ(radiusAt(smoothed, 1), 5) << "halfway to the mean of 4 and 8, as it was before";
  EXPECT_EQ(radiusAt(smoothed, 0), 4);
  EXPECT_EQ(radiusAt(smoothed, 4), 4);
}

TEST(SmoothRadii, KeepsAnEvenSlopeOfUnevenNodes) {
  Skeleton narrowing = test::stick(4);
  for (const auto& [id, height] : {std::pair(0U, 0.0), {1U, 1.0}, {2U, 1.5}, {3U, 5.0}}) {
    narrowing.setPosition(NodeId{id}, {0, 0, height});
    narrowing.setRadius(NodeId{id}, 10 - height);
  }
  const Skeleton smoothed = edited(narrowing, smoothAll);
  for (const NodeId id : narrowing.ids())
    EXPECT_NEAR(smoothed[id].radius, narrowing[id].radius, 1e-12);
}

TEST(SmoothRadii, KeepsAxesApartAndUnknownRadiiUnknown) {
  Skeleton fork = test::fork(3);
  fork.setRadius(test::forkRoot, 5);
  const Skeleton smoothed = edited(fork, smoothAll);
  const NodeId next = fork.children(test::forkTop).front();
  const double above = (fork[next].position - fork[test::forkTop].position).norm();
  const double line = 5 + (0.1 - 5) / (1 + above); // forkTop is one above the root
  EXPECT_NEAR(smoothed[test::forkTop].radius, (0.1 + line) / 2, 1e-12);
  for (const NodeId shoot : fork.children(test::forkTop))
    EXPECT_EQ(smoothed[shoot].radius, fork[shoot].radius);
  const Skeleton gap = stickOf({4, 0, 8, 4});
  EXPECT_EQ(edited(gap, smoothAll), gap);
}

TEST(LimitRadii, PassesLimitsUpwards) {
  const Skeleton limited = edited(stickOf({5, 7, 6, 3, 4}), limitAll);
  const double expected[] = {5, 5, 5, 3, 3};
  for (std::uint32_t i = 0; i < 5; ++i)
    EXPECT_EQ(radiusAt(limited, i), expected[i]);
}

TEST(LimitRadii, LooksPastUnknownRadiiAndLeavesThemUnknown) {
  const Skeleton limited = edited(stickOf({0, 5, 0, 7}), limitAll);
  EXPECT_EQ(radiusAt(limited, 0), 0);
  EXPECT_EQ(radiusAt(limited, 2), 0);
  EXPECT_EQ(radiusAt(limited, 3), 5);
}

TEST(LimitRadii, ChangesChosenNodesOnly) {
  const Skeleton limited =
      edited(stickOf({5, 7, 6}), [](SkeletonEditor& editor) { limitRadii(editor, {NodeId{2}}); });
  EXPECT_EQ(radiusAt(limited, 1), 7);
  EXPECT_EQ(radiusAt(limited, 2), 6);
}

// 8 nodes on the root; each shoot carries itself: with tips at 1/8 of the root the exponent is 1.
TEST(PipeModelFrom, FollowsWhatEachNodeCarries) {
  Skeleton fork = test::fork(6);
  fork.setRadius(test::forkRoot, 0.8);
  const Skeleton piped =
      edited(fork, [](SkeletonEditor& editor) { pipeModelFrom(editor, test::forkRoot); });
  EXPECT_EQ(piped[test::forkRoot].radius, 0.8);
  EXPECT_NEAR(piped[test::forkTop].radius, 0.7, 1e-12);
  for (const NodeId shoot : fork.children(test::forkTop))
    EXPECT_NEAR(piped[shoot].radius, 0.1, 1e-12);
}

TEST(PipeModelFrom, LeavesWhatIsBelowAsItIs) {
  Skeleton stick = stickOf({9, 8, 4, 0, 0, 1});
  const Skeleton piped =
      edited(stick, [](SkeletonEditor& editor) { pipeModelFrom(editor, NodeId{2}); });
  EXPECT_EQ(radiusAt(piped, 0), 9);
  EXPECT_EQ(radiusAt(piped, 1), 8);
  EXPECT_EQ(radiusAt(piped, 2), 4);
  EXPECT_NEAR(radiusAt(piped, 3), 3, 1e-12); // 4 nodes, 4 times the tip: proportional
  EXPECT_NEAR(radiusAt(piped, 4), 2, 1e-12);
  EXPECT_NEAR(radiusAt(piped, 5), 1, 1e-12);
}

TEST(PipeModelFrom, BeginsAnewAtNodesThatAreKept) {
  const Skeleton stick = stickOf({8, 0, 0, 0, 2, 0, 0, 1});
  const Skeleton piped = edited(stick, [](SkeletonEditor& editor) {
    pipeModelFrom(editor, NodeId{0}, {NodeId{4}, NodeId{6}});
  });
  EXPECT_NEAR(radiusAt(piped, 3), 5, 1e-12) << "as if nothing were kept above";
  EXPECT_EQ(radiusAt(piped, 4), 2);
  EXPECT_NEAR(radiusAt(piped, 5), 2 * std::sqrt(3.0 / 4), 1e-12); // 4 nodes, twice the tip
  EXPECT_NEAR(radiusAt(piped, 6), 2 * std::sqrt(2.0 / 4), 1e-12) << "it has no radius to keep";
}

TEST(PipeModelFrom, TakesTheExponentOfPublishedStructuresIfNoTipHasARadius) {
  const Skeleton piped = edited(stickOf({4, 0, 0, 0, 0, 0, 0, 0}),
                                [](SkeletonEditor& editor) { pipeModelFrom(editor, NodeId{0}); });
  EXPECT_NEAR(radiusAt(piped, 7), 4 / 2.0, 1e-12) << "the cube root of 8";
}

TEST(PipeModelFrom, NeverGrowsTowardsTheTips) {
  const Skeleton piped = edited(stickOf({1, 0, 0, 5}),
                                [](SkeletonEditor& editor) { pipeModelFrom(editor, NodeId{0}); });
  for (const NodeId id : piped.ids())
    EXPECT_EQ(piped[id].radius, 1);
}

TEST(PipeModelFrom, IsRefusedWithoutARadiusOrWithoutAnythingAbove) {
  Skeleton stick = stickOf({0, 1});
  SkeletonEditor editor(stick);
  EXPECT_THROW(pipeModelFrom(editor, NodeId{0}), Error);
  EXPECT_THROW(pipeModelFrom(editor, NodeId{1}), Error);
  EXPECT_TRUE(editor.commit().isEmpty());
}

TEST(ConfirmedNodes, AreThoseThatWereMeasuredAlike) {
  const Skeleton stick = stickOf({10, 10, 10});
  EXPECT_EQ(confirmedNodes(stick, {{NodeId{0}, 9}, {NodeId{2}, 7}}),
            std::vector<NodeId>{NodeId{0}});
}

} // namespace
} // namespace espalier
