#include "core/decide/decide_ends.h"
#include "core/evaluate/study/perturbation.h"
#include "core/skeleton/branch_end.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace espalier {
namespace {

// Of simulatedTree() [m], about.
constexpr PlantScale scale{.spacing = 0.01, .height = 4, .thickness = 0.02, .scatter = 0.001};

DecidedEnds decided(const Skeleton& skeleton, const EndOptions& options) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  return withDecidedEnds(skeleton, tree.cloud.positions(), tree.cloud.origin(), scale, options);
}

std::set<NodeId> tipsOf(const Skeleton& skeleton) {
  std::set<NodeId> tips;
  for (const NodeId id : skeleton.ids())
    if (skeleton.children(id).empty()) tips.insert(id);
  return tips;
}

// Spurs that no point has asked for go, what the scanner saw stays.
TEST(DecideEnds, TellsShootsFromSpurs) {
  const Skeleton& truth = test::simulatedTree().truth;
  const Skeleton plant = perturbed(truth, Perturbation::spurs, 0.1, 1);
  const std::set<NodeId> shoots = tipsOf(truth);
  const std::set<NodeId> before = tipsOf(plant);
  const std::set<NodeId> after =
      tipsOf(decided(plant, {.leastProbability = 0.5, .length = 0}).skeleton);
  double spurs = 0, spursLeft = 0, shootsThere = 0, shootsLeft = 0;
  for (const NodeId tip : before) { // a shoot with a spur at its tip is longer, no end of its own
    shootsThere += shoots.contains(tip);
    spurs += !shoots.contains(tip);
    spursLeft += !shoots.contains(tip) && after.contains(tip);
    shootsLeft += shoots.contains(tip) && after.contains(tip);
  }
  ASSERT_GT(spurs, 100);
  EXPECT_LE(spursLeft / spurs, 0.1);
  EXPECT_GE(shootsLeft / shootsThere, 0.9);
}

TEST(DecideEnds, KeepsAllWhereNothingIsImprobableEnough) {
  const Skeleton& truth = test::simulatedTree().truth;
  const DecidedEnds all = decided(truth, {.leastProbability = 0, .length = 0});
  EXPECT_EQ(all.skeleton, truth);
  EXPECT_EQ(all.decisions.size(), branchEnds(truth).size());
  EXPECT_TRUE(std::ranges::all_of(all.decisions, &EndDecision::stays));
}

// What is asked is all there: what went, and what stays with its probability.
TEST(DecideEnds, SaysHowProbableEachEndIs) {
  const Skeleton plant = perturbed(test::simulatedTree().truth, Perturbation::spurs, 0.1, 1);
  const DecidedEnds result = decided(plant, {.leastProbability = 0.6, .length = 0});
  std::set<NodeId> staying;
  for (const EndDecision& decision : result.decisions) {
    EXPECT_GT(decision.probability, 0);
    EXPECT_LT(decision.probability, 1);
    EXPECT_EQ(decision.stays, decision.probability >= 0.6);
    ASSERT_GE(decision.path.size(), 2U);
    if (!decision.stays) continue;
    staying.insert(decision.tip);
    EXPECT_EQ(decision.path.back(), result.skeleton[decision.tip].position);
  }
  for (const BranchEnd& end : branchEnds(result.skeleton))
    EXPECT_TRUE(staying.contains(end.nodes.front()));
}

TEST(DecideEnds, AsksTheOddsThatAreGiven) {
  const test::SimulatedPlant& tree = test::simulatedTree();
  const auto byLength = [](const EndEvidence& end) { return end.length > 20 ? 0.9 : 0.1; };
  const DecidedEnds result =
      withDecidedEnds(tree.truth, tree.cloud.positions(), tree.cloud.origin(), scale,
                      {.leastProbability = 0.5, .length = 0}, {}, byLength);
  std::set<double> said;
  for (const EndDecision& decision : result.decisions)
    said.insert(decision.probability);
  EXPECT_EQ(said, (std::set{0.1, 0.9}));
  EXPECT_LT(test::countTips(result.skeleton), test::countTips(tree.truth));
}

TEST(DecideEnds, KeepsOneEndOfEachBranching) {
  const Skeleton& truth = test::simulatedTree().truth;
  const DecidedEnds least = decided(truth, {.leastProbability = 1, .length = 0});
  EXPECT_EQ(test::countTips(least.skeleton), 1);
}

TEST(DecideEnds, NeverCutsAnUnbranchedPlant) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  EXPECT_EQ(
      withDecidedEnds(test::stick(5), points, Eigen::Vector3d::Zero(), {0.02, 5}, {.length = 100})
          .skeleton,
      test::stick(5));
  EXPECT_TRUE(
      withDecidedEnds({}, points, Eigen::Vector3d::Zero(), {0.02, 5}, {}).skeleton.isEmpty());
}

TEST(DecideEnds, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    const test::SimulatedPlant& tree = test::simulatedTree();
    (void)withDecidedEnds(tree.truth, tree.cloud.positions(), tree.cloud.origin(), scale, {},
                          progress);
  }));
}

} // namespace
} // namespace espalier
