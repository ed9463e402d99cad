#include "core/evaluate/match/diadem_score.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/study/perturbation.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(DiademScore, OfAPlantWithItselfIsPerfect) {
  for (const Skeleton& plant : {test::bush(), test::fork(4), test::stick(3), test::stick(1)}) {
    const DiademScore score = diademScore(plant, plant, {.distance = 0.01});
    EXPECT_EQ(score.score, 1);
    EXPECT_EQ(score.connected, score.landmarks);
  }
}

// The branching weighs three tips, each tip one: five of six are left.
TEST(DiademScore, CountsAMissingTip) {
  Skeleton missing = test::fork(3);
  missing.erase(NodeId{4});
  const DiademScore score = diademScore(missing, test::fork(3), {.distance = 0.1});
  EXPECT_EQ(score.landmarks, 4U);
  EXPECT_EQ(score.matched, 3U);
  EXPECT_DOUBLE_EQ(score.score, 5.0 / 6);
}

// The spur is a tip, and where it stands is a branching that carries one: two against one.
TEST(DiademScore, CountsWhatIsInvented) {
  Skeleton spurred = test::stick(5);
  spurred.add({.position = {0.5, 0, 2}, .parent = NodeId{2}, .edge = EdgeType::branching});
  EXPECT_DOUBLE_EQ(diademScore(spurred, test::stick(5), {.distance = 0.1}).score, 1.0 / 3);
}

// Two shoots with three arms and two: one arm is found where it is, but on the other shoot.
TEST(DiademScore, SeesATipThatIsAttachedToAnotherBranching) {
  Skeleton plant = test::fork(2);
  for (const double z : {1.0, 3.0}) {
    plant.add({.position = {2, 0, z}, .parent = NodeId{2}, .edge = EdgeType::branching});
    plant.add({.position = {-2, 0, z}, .parent = NodeId{3}, .edge = EdgeType::branching});
  }
  const NodeId arm =
      plant.add({.position = {0, 0, 3}, .parent = NodeId{2}, .edge = EdgeType::branching});
  Skeleton wrong = plant;
  wrong.reparent(arm, NodeId{3}, EdgeType::branching);
  const DiademScore score = diademScore(wrong, plant, {.distance = 0.1});
  EXPECT_EQ(score.matched, 8U);
  EXPECT_EQ(score.connected, 7U);
  EXPECT_DOUBLE_EQ(score.score, 14.0 / 15) << "5 + 3 + 2 for the branchings, 5 for the tips";
}

TEST(DiademScore, SeesATipThatIsReachedByADetour) {
  Skeleton detour = test::fork(2);
  const NodeId arm{3};
  const NodeId far = detour.add({.position = {-4, 0, 1}, .parent = test::forkTop});
  detour.reparent(arm, far, EdgeType::successor);
  detour.setEdge(far, EdgeType::branching);
  const DiademScore score = diademScore(detour, test::fork(2), {.distance = 0.1});
  EXPECT_EQ(score.matched, 3U);
  EXPECT_DOUBLE_EQ(score.score, 3.0 / 4);
}

TEST(DiademScore, PassesOverALandmarkThatIsNotFound) {
  Skeleton reference = test::stick(5); // a twig at 2 is missed: the path from 1 to the tip goes on
  for (const std::uint32_t foot : {1U, 2U})
    reference.add({.position = {1, 0, static_cast<double>(foot)},
                   .parent = NodeId{foot},
                   .edge = EdgeType::branching});
  Skeleton result = reference;
  result.erase(NodeId{6});
  const DiademScore score = diademScore(result, reference, {.distance = 0.1});
  EXPECT_EQ(score.connected, 3U) << "the lower branching, its twig, the top";
  EXPECT_DOUBLE_EQ(score.score, (3.0 + 1 + 1) / (3 + 2 + 3));
}

TEST(DiademScore, DependsNeitherOnNodesWithinEdgesNorOnTheFrame) {
  const Skeleton reference = test::bush();
  const Skeleton result = test::jittered(reference, 0.1);
  const double score = diademScore(result, reference, {.distance = 0.2}).score;
  EXPECT_GT(score, 0.01);
  EXPECT_LT(score, 0.99);
  EXPECT_EQ(diademScore(test::withMiddleNodes(result), reference, {.distance = 0.2}).score, score);
  const auto motion = test::motion(0.7, {3, 4, 5});
  EXPECT_EQ(diademScore(moved(result, motion), moved(reference, motion), {.distance = 0.2}).score,
            score);
}

TEST(DiademScore, FallsAsMoreIsCutOff) {
  const Skeleton plant = test::bush();
  double before = 1;
  for (const double share : {0.2, 0.5, 0.9}) {
    const Skeleton pruned = perturbed(plant, Perturbation::prune, share, 1);
    const double score = diademScore(pruned, plant, {.distance = 0.05}).score;
    EXPECT_LT(score, before) << share;
    before = score;
  }
}

TEST(DiademScore, OfDisjointPlantsIsZero) {
  EXPECT_EQ(
      diademScore(test::shifted(test::bush(), {500, 0, 0}), test::bush(), {.distance = 1}).score,
      0);
}

} // namespace
} // namespace espalier
