#include "core/radius/pipe_ends.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

const std::vector<double> unseen(const Skeleton& plant) {
  return std::vector<double>(plant.idEnd(), 0);
}

std::vector<MeasuredRadius> measured(const std::vector<double>& radii) {
  std::vector<MeasuredRadius> result;
  for (const double radius : radii)
    result.push_back({.radius = radius, .deviation = 0.1});
  return result;
}

std::vector<double> radiiOf(const Skeleton& plant) {
  std::vector<double> radii(plant.idEnd(), 0);
  for (const NodeId id : plant.ids())
    radii[indexOf(id)] = plant[id].radius;
  return radii;
}

/// A trunk of 30 nodes with a twig of 3 on each from the fifth on: the root carries 105.
Skeleton twiggedStick() {
  Skeleton plant = test::stick(30);
  for (std::uint32_t i = 5; i < 30; ++i) {
    NodeId below{i};
    for (int k = 1; k <= 3; ++k)
      below = plant.add({.position = {1.0 * k, 0, 1.0 * i},
                         .parent = below,
                         .edge = k == 1 ? EdgeType::branching : EdgeType::successor});
  }
  return plant;
}

constexpr NodeCountPipeOptions law{.rootRadius = 0.4, .apexRadius = 0.05}; // exponent 0.447

Skeleton byLaw() {
  return withNodeCountPipeRadii(twiggedStick(), law);
}

TEST(PipeEnds, GiveBackTheLawThatRadiiFollow) {
  const Skeleton plant = byLaw();
  std::vector<double> lowest = unseen(plant);
  for (std::size_t i = 1; i < 8; ++i)
    lowest[i] = plant[NodeId{static_cast<std::uint32_t>(i)}].radius;
  const PipeEnds ends = pipeEnds(plant, lowest, measured(radiiOf(plant)), 1);
  EXPECT_EQ(ends.basis, PipeBasis::foot);
  EXPECT_NEAR(ends.radii.rootRadius, 0.4, 1e-9) << "though the root was not measured";
  EXPECT_NEAR(ends.radii.apexRadius, 0.05, 1e-12);
  EXPECT_NEAR(ends.footToTip, 8, 1e-9);
}

// A third of the foot and four fifths of the outermost wood measure up to 20 times too thick.
TEST(PipeEnds, AreNotPulledByWrongRadii) {
  const Skeleton plant = byLaw();
  std::vector<double> lowest = unseen(plant);
  for (std::size_t i = 0; i < 9; ++i)
    lowest[i] = plant[NodeId{static_cast<std::uint32_t>(i)}].radius * (i % 3 == 0 ? 5 : 1);
  std::vector<double> wood = radiiOf(plant);
  for (std::size_t i = 0; i < wood.size(); ++i)
    if (i % 5 != 0) wood[i] *= static_cast<double>(2 + i % 19);
  const PipeEnds ends = pipeEnds(plant, lowest, measured(wood), 1);
  EXPECT_EQ(ends.basis, PipeBasis::foot);
  EXPECT_NEAR(ends.radii.apexRadius / law.apexRadius, 1, 1e-9);
  EXPECT_NEAR(ends.radii.rootRadius / law.rootRadius, 1, 1e-9);
}

// Tips as thick as the foot would make one radius of all.
TEST(PipeEnds, KeepTheFootWhereTheTipsMeasureAsThick) {
  const Skeleton plant = byLaw();
  std::vector<double> lowest = unseen(plant);
  lowest[0] = lowest[1] = lowest[2] = 0.4;
  for (const double thick : {0.39, 0.4, 4.0}) {
    const PipeEnds ends =
        pipeEnds(plant, lowest, measured(std::vector<double>(plant.idEnd(), thick)), 1);
    EXPECT_EQ(ends.basis, PipeBasis::footOnly);
    EXPECT_NEAR(ends.radii.rootRadius, 0.4, 0.01);
    EXPECT_NEAR(ends.radii.rootRadius / ends.radii.apexRadius, std::pow(105, 1 / 2.9), 1e-9);
    EXPECT_LT(ends.footToTip, 1.1);
  }
  EXPECT_EQ(pipeEnds(plant, lowest, measured(std::vector<double>(plant.idEnd(), 1e-9)), 1).basis,
            PipeBasis::footOnly)
      << "tips that measure next to nothing are not trusted either";
}

TEST(PipeEnds, TakeWhatThereIsAtOneEnd) {
  const Skeleton plant = byLaw();
  std::vector<MeasuredRadius> tips(plant.idEnd());
  tips[plant.idEnd() - 1] = {.radius = 0.05, .deviation = 0.1};
  const PipeEnds fromTips = pipeEnds(plant, unseen(plant), tips, 1);
  EXPECT_EQ(fromTips.basis, PipeBasis::tipsOnly);
  EXPECT_NEAR(fromTips.radii.apexRadius, 0.05, 1e-12);
  EXPECT_NEAR(fromTips.radii.rootRadius, 0.05 * std::pow(105, 1 / 2.9), 1e-9);
  const std::vector<MeasuredRadius> none(plant.idEnd());
  std::vector<double> lowest = unseen(plant);
  lowest[1] = 0.4;
  EXPECT_EQ(pipeEnds(plant, lowest, none, 1).basis, PipeBasis::footOnly);
  const PipeEnds fromNothing = pipeEnds(plant, unseen(plant), none, 0.02);
  EXPECT_EQ(fromNothing.basis, PipeBasis::nothing);
  EXPECT_EQ(fromNothing.radii.apexRadius, 0.02);
}

TEST(PipeEnds, TakeTheWoodOfTheFootWhereNoCircleIsFound) {
  const Skeleton plant = byLaw();
  const PipeEnds ends = pipeEnds(plant, unseen(plant), measured(radiiOf(plant)), 1);
  EXPECT_EQ(ends.basis, PipeBasis::foot);
  EXPECT_NEAR(ends.radii.rootRadius, 0.4, 1e-9);
}

TEST(PipeEnds, AreFiniteWithoutAnyRadiusOrNode) {
  for (const Skeleton& plant : {Skeleton(), test::stick(1), test::stick(3)})
    for (const double otherwise : {0.0, 1.0}) {
      const PipeEnds ends =
          pipeEnds(plant, unseen(plant), std::vector<MeasuredRadius>(plant.idEnd()), otherwise);
      EXPECT_EQ(ends.basis, PipeBasis::nothing);
      EXPECT_EQ(ends.radii.apexRadius, otherwise);
      EXPECT_TRUE(std::isfinite(ends.radii.rootRadius));
    }
}

struct Lowest {
  Eigen::Matrix3Xf points;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  SpatialIndex index{points};

  explicit Lowest(Eigen::Matrix3Xf scan) : points(std::move(scan)) {}
  [[nodiscard]] std::vector<double> radii(const Skeleton& plant) const {
    return lowestWoodRadii(plant, {points, origin, index, 0.02});
  }
};

// Two strands of nodes run up the bark of one trunk, as tracking leaves them on thick wood.
TEST(LowestWoodRadii, OfATrunkThatHasStrandsOnItsBarkAreThoseOfTheTrunk) {
  const Lowest trunk(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.02));
  Skeleton strands = test::stick(21, 0.1);
  for (const NodeId id : strands.ids())
    strands.setPosition(id, strands[id].position + Eigen::Vector3d(0.09, 0, 0));
  NodeId below{0};
  for (int i = 1; i <= 18; ++i)
    below = strands.add({.position = {-0.09, 0, 0.1 * i},
                         .parent = below,
                         .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
  const std::vector<double> radii = trunk.radii(strands);
  for (const std::uint32_t id : {2U, 3U})
    EXPECT_NEAR(radii[id], 0.1, 0.002) << id;
  EXPECT_EQ(radii[20], 0) << "no foot";
  EXPECT_EQ(radii[30], 0) << "of the lighter strand";
}

TEST(LowestWoodRadii, AreNoneWithoutPointsOrNodes) {
  const Lowest trunk(test::cylinder({0, 0, 0}, {0, 0, 2}, 0.1, 0.02));
  EXPECT_TRUE(trunk.radii({}).empty());
  EXPECT_THAT(trunk.radii(test::stick(1)), testing::ElementsAre(0));
  const Lowest nothing(Eigen::Matrix3Xf(3, 0));
  EXPECT_THAT(nothing.radii(test::stick(3)), testing::Each(0));
}

} // namespace
} // namespace espalier
