#include "core/base/random.h"
#include "core/reconstruct/direction_clusters.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// `count` directions about one that is `angle` off upwards, `spread` apart from it [rad].
void addAbout(std::vector<Eigen::Vector3d>& directions, double angle, double azimuth, int count,
              double spread, Random& random) {
  const Eigen::Vector3d middle(std::sin(angle) * std::cos(azimuth),
                               std::sin(angle) * std::sin(azimuth), std::cos(angle));
  for (int i = 0; i < count; ++i)
    directions.push_back(
        (middle + spread * Eigen::Vector3d(random.normal(), random.normal(), random.normal()))
            .normalized());
}

TEST(DirectionClusters, AreAsManyAsThereAreBunches) {
  Random random(1);
  for (int bunches = 1; bunches <= 4; ++bunches) {
    std::vector<Eigen::Vector3d> directions;
    for (int i = 0; i < bunches; ++i)
      addAbout(directions, 60 * degree, 2 * std::numbers::pi * i / 4, 25, 0.08, random);
    const auto groups = directionClusters(directions);
    ASSERT_EQ(groups.size(), static_cast<std::size_t>(bunches));
    for (const std::vector<std::size_t>& group : groups) {
      EXPECT_EQ(group.size(), 25U);
      for (const std::size_t i : group)
        EXPECT_EQ(i / 25, group.front() / 25); // none of another bunch
    }
  }
}

TEST(DirectionClusters, NeitherWrapNorHaveAPole) {
  Random random(2);
  std::vector<Eigen::Vector3d> directions;
  addAbout(directions, 0, 0, 30, 0.08, random);                          // about the pole
  addAbout(directions, 90 * degree, std::numbers::pi, 30, 0.08, random); // about the seam
  const auto groups = directionClusters(directions);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].size(), 30U);
}

TEST(DirectionClusters, KeepANarrowForkInOne) {
  Random random(3);
  std::vector<Eigen::Vector3d> directions;
  addAbout(directions, 9 * degree, 0, 30, 0.02, random);
  addAbout(directions, 9 * degree, std::numbers::pi, 30, 0.02, random);
  EXPECT_EQ(directionClusters(directions).size(), 1U);
}

TEST(DirectionClusters, TurnWithTheDirections) {
  Random random(4);
  std::vector<Eigen::Vector3d> directions;
  addAbout(directions, 40 * degree, 0, 40, 0.15, random);
  addAbout(directions, 40 * degree, 2, 20, 0.15, random);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, 0.5, -0.4, 0.7).normalized();
  std::vector<Eigen::Vector3d> turned;
  for (const Eigen::Vector3d& direction : directions)
    turned.emplace_back(turn * direction);
  EXPECT_EQ(directionClusters(turned), directionClusters(directions));
}

TEST(DirectionClusters, TakeMoreDirectionsThanAreFitted) {
  Random random(5);
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < 300; ++i)
    addAbout(directions, 60 * degree, i % 2 * std::numbers::pi, 1, 0.08, random);
  const auto groups = directionClusters(directions);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].size(), 150U);
}

TEST(DirectionClusters, CopeWithFewEqualOppositeAndNoDirections) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(directionClusters({}).empty());
  EXPECT_TRUE(directionClusters({Eigen::Vector3d::Zero()}).empty());
  EXPECT_EQ(directionClusters({up}).size(), 1U);
  EXPECT_EQ(directionClusters({up, up, up, up}).size(), 1U);
  const auto groups = directionClusters({up, up, up, up, -up, -up, -up, -up});
  EXPECT_EQ(groups.size(), 2U);
}

} // namespace
} // namespace espalier
