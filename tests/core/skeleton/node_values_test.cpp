#include "core/skeleton/node_values.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::Eq;
using testing::Optional;

TEST(NodeValues, AreOrderAndRadius) {
  Skeleton plant = test::fork(2);
  plant.setRadius(NodeId{3}, 0.05);
  EXPECT_THAT(nodeValues(plant, NodeValue::order, nullptr, 0),
              ElementsAre(Optional(0), Optional(0), Optional(0), Optional(1)));
  EXPECT_THAT(nodeValues(plant, NodeValue::radius, nullptr, 0),
              ElementsAre(Optional(0.1), Optional(0.1), Optional(0.1), Optional(0.05)));
  EXPECT_THAT(nodeValues(plant, NodeValue::radiusToParent, nullptr, 0),
              ElementsAre(Eq(std::nullopt), Optional(1), Optional(1), Optional(0.5)));
}

TEST(NodeValues, AreHalfTheWidthOfTheIntervalOfARadius) {
  Skeleton plant = test::stick(2);
  plant.setRadius(NodeId{1}, 3, {RadiusSource::measured, 0.75F, 1.75F});
  EXPECT_THAT(nodeValues(plant, NodeValue::radiusSpread, nullptr, 0),
              ElementsAre(Eq(std::nullopt), Optional(0.5)));
}

TEST(NodeValues, AreNoneWhereNothingIsKnown) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{1}, 0);
  EXPECT_EQ(nodeValues(plant, NodeValue::radius, nullptr, 0)[1], std::nullopt);
  EXPECT_EQ(nodeValues(plant, NodeValue::radiusToParent, nullptr, 0)[2], std::nullopt);
  for (const auto& value : nodeValues(plant, NodeValue::distance, nullptr, 0))
    EXPECT_EQ(value, std::nullopt);
  plant.erase(NodeId{2});
  EXPECT_EQ(nodeValues(plant, NodeValue::order, nullptr, 0)[2], std::nullopt);
}

// Points 0.3 and 0.5 off the axis of a stick of radius 0.1, all beside its upper edge.
TEST(NodeValues, AreTheMeanDistanceOfThePointsOfAnEdge) {
  Eigen::Matrix3Xf points(3, 2);
  points << 0.3F, 0.5F, 0, 0, 1.5F, 1.5F;
  const Skeleton plant = test::stick(3);
  const PointDistances distances(test::cloudAtOrigin(points), 0.1, plant);
  const auto values = nodeValues(plant, NodeValue::distance, &distances, 0.1);
  EXPECT_EQ(values[1], std::nullopt);
  ASSERT_TRUE(values[2].has_value());
  EXPECT_NEAR(*values[2], 0.3, 1e-6);
}

// Half of a cylinder is scanned, from its foot to its middle.
TEST(NodeValues, AreTheShareOfTheSurfaceThatHasPoints) {
  const Eigen::Matrix3Xf points =
      test::cylinder(Eigen::Vector3d::Zero(), Eigen::Vector3d(0, 0, 1), 0.1, 0.02);
  const Skeleton plant = test::stick(3);
  const auto cloud = test::cloudAtOrigin(points);
  const double spacing = pointSpacing(cloud->positions());
  const PointDistances distances(cloud, spacing, plant);
  const auto values = nodeValues(plant, NodeValue::confidence, &distances, spacing);
  EXPECT_EQ(values[0], std::nullopt); // no edge of its own
  EXPECT_GT(*values[1], 0.7);
  EXPECT_LE(*values[1], 1);
  EXPECT_LT(*values[2], 0.1);
}

} // namespace
} // namespace espalier
