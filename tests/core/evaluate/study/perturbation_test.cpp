#include "core/base/error.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/study/perturbation.h"
#include "core/evaluate/traits/traits.h"
#include "core/skeleton/bounds.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace espalier {
namespace {

std::vector<Perturbation> allKinds() {
  std::vector<Perturbation> kinds;
  for (std::size_t i = 0; i < perturbations().size(); ++i)
    kinds.push_back(static_cast<Perturbation>(i));
  return kinds;
}

TEST(Perturbation, OfLevelZeroChangesNothing) {
  for (const Perturbation kind : allKinds())
    EXPECT_EQ(perturbed(test::bush(), kind, 0, 1), test::bush());
}

TEST(Perturbation, FollowsTheSeed) {
  for (const Perturbation kind : allKinds()) {
    const Skeleton first = perturbed(test::bush(), kind, 0.5, 1);
    EXPECT_EQ(perturbed(test::bush(), kind, 0.5, 1), first);
    const bool isDrawn = kind != Perturbation::shorten && kind != Perturbation::resample;
    EXPECT_EQ(perturbed(test::bush(), kind, 0.5, 2) != first, isDrawn)
        << perturbations()[static_cast<std::size_t>(kind)].name;
  }
}

TEST(Perturbation, OfPositionScattersByMedianEdges) {
  const Skeleton plant = test::bush();
  const Skeleton noisy = perturbed(plant, Perturbation::position, 0.5, 7);
  const Skeleton twice = perturbed(plant, Perturbation::position, 1, 7);
  double sum = 0;
  for (const NodeId id : plant.ids()) {
    const Eigen::Vector3d moved = noisy[id].position - plant[id].position;
    sum += moved.squaredNorm();
    EXPECT_NEAR((twice[id].position - plant[id].position - 2 * moved).norm(), 0, 1e-9);
  }
  const double sigma = std::sqrt(sum / (3 * static_cast<double>(plant.size())));
  EXPECT_NEAR(sigma / (0.5 * medianEdgeLength(plant)), 1, 0.06); // 3 deviations of 1299 draws
}

TEST(Perturbation, OfReparentingAttachesSegmentsToTheNearestOtherNode) {
  // The arms of the fork are alone: each is attached to a tip of another arm, or to the root.
  const Skeleton plant = test::fork(2);
  const Skeleton half = perturbed(plant, Perturbation::reparent, 0.5, 1);
  std::size_t moved = 0;
  for (const NodeId id : plant.ids()) {
    EXPECT_EQ(half[id].position, plant[id].position);
    if (half[id].parent == plant[id].parent) continue;
    ++moved;
    EXPECT_EQ(half[id].edge, EdgeType::branching);
    EXPECT_NEAR((half[id].position - half[*half[id].parent].position).norm(), 2, 0.3)
        << "the other tip is 2 away, the root 2.2";
  }
  EXPECT_EQ(moved, 1U);
}

TEST(Perturbation, OfPruningCutsTerminalSegments) {
  EXPECT_EQ(perturbed(test::fork(3), Perturbation::prune, 1, 1).size(), 2U);
  EXPECT_EQ(perturbed(test::fork(4), Perturbation::prune, 0.5, 1).size(), 4U);
  EXPECT_EQ(perturbed(test::stick(4), Perturbation::prune, 1, 1), test::stick(4))
      << "a trunk is no twig";
}

TEST(Perturbation, OfShorteningTakesFromTheTips) {
  const Skeleton plant = perturbed(test::fork(2), Perturbation::shorten, 0.25, 1);
  EXPECT_NEAR(totalLength(plant), 1 + 1.5 * std::sqrt(2.0), 1e-12);
  Skeleton longer = test::fork(2);
  longer.add({.position = {2, 0, 3}, .parent = NodeId{2}}); // that arm: two edges of one length
  const Skeleton cut = perturbed(longer, Perturbation::shorten, 0.75, 1);
  EXPECT_FALSE(cut.contains(NodeId{4}));
  EXPECT_NEAR((cut[NodeId{2}].position - Eigen::Vector3d(0.5, 0, 1.5)).norm(), 0, 1e-9);
}

TEST(Perturbation, OfSpursAddsTwigsSideways) {
  const Skeleton plant = test::stick(5, 2);
  const Skeleton spurred = perturbed(plant, Perturbation::spurs, 0.6, 3);
  EXPECT_EQ(spurred.size(), 5U + 3U);
  for (const NodeId id : spurred.ids()) {
    if (plant.contains(id)) continue;
    const Node& spur = spurred[id];
    const Eigen::Vector3d offset = spur.position - spurred[*spur.parent].position;
    EXPECT_NEAR(offset.norm(), 2, 1e-12);
    EXPECT_EQ(spur.edge, EdgeType::branching);
    if (spurred[*spur.parent].parent) {
      EXPECT_NEAR(offset.z(), 0, 1e-12);
    }
  }
}

TEST(Perturbation, OfResamplingMovesNodesAlongTheSameLines) {
  const Skeleton plant = perturbed(test::stick(5), Perturbation::resample, 0.5, 1);
  EXPECT_EQ(plant.size(), 9U);
  EXPECT_DOUBLE_EQ(totalLength(plant), 4);
  const Skeleton bush = test::bush();
  const Skeleton fine = perturbed(bush, Perturbation::resample, 0.1, 1);
  const Skeleton coarse = perturbed(bush, Perturbation::resample, 100, 1);
  EXPECT_EQ(traits(fine).axesByOrder, traits(bush).axesByOrder);
  EXPECT_EQ(traits(fine).segments, traits(bush).segments);
  EXPECT_EQ(coarse.size(), traits(bush).segments + 2)
      << "a node per segment, the root, and the top of the trunk, where one shoot begins";
  EXPECT_EQ(branchings(coarse).size(), branchings(bush).size());
}

TEST(Perturbation, OfShiftAndTurnAreRigid) {
  const Skeleton plant = test::bush();
  const double edge = medianEdgeLength(plant);
  const Skeleton shifted = perturbed(plant, Perturbation::shift, 1.5, 4);
  const Eigen::Vector3d by = shifted[NodeId{0}].position - plant[NodeId{0}].position;
  EXPECT_NEAR(by.norm(), 1.5 * edge, 1e-9);
  const Skeleton turned = perturbed(plant, Perturbation::turn, 0.1, 4);
  const Eigen::Vector3d middle = bounds(plant).center();
  for (const NodeId id : plant.ids()) {
    EXPECT_NEAR((shifted[id].position - plant[id].position - by).norm(), 0, 1e-9);
    const double arm = (plant[id].position - middle).norm();
    EXPECT_NEAR((turned[id].position - middle).norm(), arm, 1e-9);
    EXPECT_LE((turned[id].position - plant[id].position).norm(), 0.1 * arm + 1e-9);
  }
}

// Each of these took all memory, or an afternoon.
TEST(Perturbation, RefusesLevelsThatAreAbsurd) {
  const Skeleton plant = test::stick(5);
  for (const auto& [kind, level] :
       {std::pair(Perturbation::position, 1e300), std::pair(Perturbation::spurs, 1e300),
        std::pair(Perturbation::resample, 1e-300), std::pair(Perturbation::shift, 1e300),
        std::pair(Perturbation::turn, 1e300)})
    EXPECT_THROW((void)perturbed(plant, kind, level, 1), Error) << level;
}

TEST(Perturbation, RefusesLevelsThatAreNoneAndPlantsThatAreNone) {
  EXPECT_THROW((void)perturbed({}, Perturbation::shift, 1, 1), Error);
  for (const Perturbation kind : allKinds()) {
    EXPECT_THROW((void)perturbed(test::bush(), kind, -0.1, 1), Error);
    EXPECT_THROW((void)perturbed(test::bush(), kind, std::numeric_limits<double>::quiet_NaN(), 1),
                 Error);
  }
  EXPECT_THROW((void)perturbed(test::bush(), Perturbation::prune, 1.01, 1), Error);
}

} // namespace
} // namespace espalier
