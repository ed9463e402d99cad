#include "core/base/error.h"
#include "core/simulate/piece_tree.h"
#include "core/simulate/plant_grower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

int segments(const Skeleton& plant) {
  int count = 0;
  for (const NodeId id : plant.ids())
    if (const auto parent = plant[id].parent)
      count += !plant[*parent].parent || plant.children(*parent).size() > 1 ? 1 : 0;
  return count;
}

std::vector<int> orders(const Skeleton& plant) {
  std::vector<int> order(plant.idEnd(), 0);
  for (const NodeId id : plant.ids())
    if (const auto parent = plant[id].parent)
      order[indexOf(id)] =
          order[indexOf(*parent)] + (plant[id].edge == EdgeType::branching ? 1 : 0);
  return order;
}

/// Direction of the edge to the parent; that of the parent for a root.
Vector3d edgeDirection(const Skeleton& plant, NodeId id) {
  return (plant[id].position - plant[*plant[id].parent].position).normalized();
}

class EachArchitecture : public testing::TestWithParam<Architecture> {
protected:
  [[nodiscard]] static GrowthOptions options(int segments) {
    return {.architecture = GetParam(), .segments = segments};
  }
};

INSTANTIATE_TEST_SUITE_P(PlantGrower, EachArchitecture,
                         testing::Values(Architecture::broadleaf, Architecture::conifer,
                                         Architecture::shrub, Architecture::herb));

TEST_P(EachArchitecture, GivesOneTreeOfTheHeightAskedOnTheOrigin) {
  GrowthOptions asked = options(150);
  asked.height = 1234.5;
  const Skeleton plant = growPlant(asked, 1);
  ASSERT_EQ(plant.roots().size(), 1U);
  EXPECT_EQ(plant[plant.roots().front()].position, Vector3d::Zero());
  double top = 0;
  for (const NodeId id : plant.ids()) {
    ASSERT_TRUE(plant[id].position.allFinite());
    EXPECT_GE(plant[id].position.z(), 0); // nothing grows into the ground
    top = std::max(top, plant[id].position.z());
  }
  EXPECT_NEAR(top, asked.height, 1e-9);
}

TEST_P(EachArchitecture, HasTheSegmentsAskedForAndHardlyMore) {
  for (const int asked : {1, 50, 1000}) {
    const int found = segments(growPlant(options(asked), 2));
    EXPECT_GE(found, asked);
    EXPECT_LE(found, asked + 1); // a branch adds two at most
  }
}

TEST_P(EachArchitecture, ReachesHigherOrdersByBranchingOnceEach) {
  const Skeleton plant = growPlant(options(400), 3);
  const std::vector<int> order = orders(plant);
  EXPECT_GE(*std::max_element(order.begin(), order.end()), 2);
  EXPECT_LE(*std::max_element(order.begin(), order.end()), 12);
  for (const NodeId id : plant.ids()) {
    const std::vector<NodeId>& children = plant.children(id);
    EXPECT_LE(std::count_if(children.begin(), children.end(),
                            [&](NodeId child) { return plant[child].edge == EdgeType::successor; }),
              1);
  }
}

TEST_P(EachArchitecture, HasRadiiThatNeverGrowTowardsTheApex) {
  const Skeleton plant = growPlant(options(400), 4);
  for (const NodeId id : plant.ids()) {
    ASSERT_GT(plant[id].radius, 0);
    if (plant[id].parent) {
      ASSERT_LE(plant[id].radius, plant[*plant[id].parent].radius);
    }
  }
}

TEST_P(EachArchitecture, BendsItsAxesSmoothly) {
  const Skeleton plant = growPlant(options(400), 5);
  int sharp = 0;
  int bends = 0;
  for (const NodeId id : plant.ids()) {
    const auto parent = plant[id].parent;
    if (!parent || !plant[*parent].parent || plant[id].edge == EdgeType::branching) continue;
    ++bends;
    if (edgeDirection(plant, id).dot(edgeDirection(plant, *parent)) < std::cos(0.5)) ++sharp;
  }
  EXPECT_LT(sharp, 0.01 * bends);
}

TEST_P(EachArchitecture, KeepsTheAxesOutOfOtherWood) {
  const Skeleton plant = growPlant(options(250), 6);
  int inside = 0;
  int looked = 0;
  const std::vector<EdgeSolid> wood = woodOf(plant);
  for (const NodeId id : plant.ids()) {
    if (!plant.children(id).empty()) continue; // apices are far from where their axes start
    ++looked;
    const bool stuck = std::any_of(wood.begin(), wood.end(), [&](const EdgeSolid& piece) {
      return !plant.isAncestor(*piece.node, id) &&
             signedDistance(piece, plant[id].position) < plant[id].radius;
    });
    inside += stuck ? 1 : 0;
  }
  EXPECT_GT(looked, 80);
  EXPECT_LT(inside, 0.02 * looked);
}

TEST_P(EachArchitecture, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(growPlant(options(100), 7), growPlant(options(100), 7));
  EXPECT_NE(growPlant(options(100), 7), growPlant(options(100), 8));
}

TEST(PlantGrower, GrowsTheSamePlantInAnyUnit) {
  const Skeleton meters = growPlant({.height = 4}, 3);
  const Skeleton larger = growPlant({.height = 4096}, 3); // a power of two more: no rounding
  ASSERT_EQ(meters.size(), larger.size());
  for (const NodeId id : meters.ids()) {
    EXPECT_EQ((1024 * meters[id].position - larger[id].position).norm(), 0);
    EXPECT_NEAR(1024 * meters[id].radius, larger[id].radius, 1e-9);
  }
}

TEST(PlantGrower, GrowsStraightAxesIfAskedTo) {
  const Skeleton plant =
      growPlant({.architecture = Architecture::conifer, .segments = 1, .wander = 0}, 1);
  Vector3d along = plant[NodeId{1}].position.normalized();
  for (const NodeId id : plant.ids())
    EXPECT_NEAR(plant[id].position.cross(along).norm(), 0, 1e-9);
}

TEST(PlantGrower, KeepsTheRadiiAndTheSpacingAskedFor) {
  const GrowthOptions asked{
      .nodeSpacing = 0.1, .baseRadius = 0.08, .apexRadius = 0.004, .radiusSpread = 0};
  const Skeleton plant = growPlant(asked, 1);
  for (const NodeId id : plant.ids()) {
    if (plant.children(id).empty()) {
      EXPECT_NEAR(plant[id].radius, 0.004, 1e-6);
    }
    if (const auto parent = plant[id].parent) {
      EXPECT_LT((plant[id].position - plant[*parent].position).norm(), 0.1 * 1.3);
    }
  }
  const double flare = 1 + habitOf(Architecture::broadleaf).flare;
  EXPECT_NEAR(plant[NodeId{0}].radius, 0.08 * flare, 1e-9);
}

TEST(PlantGrower, RefusesOptionsOutOfRange) {
  const auto grow = [](const GrowthOptions& options) { static_cast<void>(growPlant(options, 1)); };
  EXPECT_THROW(grow({.height = 0}), Error);
  EXPECT_THROW(grow({.height = std::nan("")}), Error);
  EXPECT_THROW(grow({.segments = 0}), Error);
  EXPECT_THROW(grow({.segments = 20001}), Error);
  EXPECT_THROW(grow({.nodeSpacing = -1}), Error);
  EXPECT_THROW(grow({.wander = 4}), Error);
  EXPECT_THROW(grow({.baseRadius = 0.001, .apexRadius = 0.002}), Error);
  EXPECT_THROW(grow({.radiusSpread = 2}), Error);
}

TEST(PlantGrower, StopsWhenAskedTo) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(static_cast<void>(growPlant({}, 1, Progress(source.get_token(), {}))), Cancelled);
}

} // namespace
} // namespace espalier
