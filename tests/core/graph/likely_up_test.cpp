#include "core/base/random.h"
#include "core/graph/likely_up.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// A stem that bears a ball of leaves, upright.
std::vector<Eigen::Vector3d> tree() {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Matrix3Xf stem = test::cylinder({0, 0, 0}, {0, 0, 1.5}, 0.05, 0.03);
  for (const auto& place : stem.colwise())
    points.emplace_back(place.cast<double>());
  for (int i = 0; i < 4000; ++i) { // evenly over a ball about the top of the stem
    const double height = 2 * (i + 0.5) / 4000 - 1;
    const double angle = 2.399963 * i;
    const double radius = std::sqrt(1 - height * height);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 2 + height);
  }
  return points;
}

TEST(LikelyUp, IsTheAxisThatTheFootIsAtTheLowEndOf) {
  std::vector<Eigen::Vector3d> points = tree();
  EXPECT_EQ(likelyUp(points), UpAxis::z);
  for (Eigen::Vector3d& point : points)
    point = {point.y(), point.z(), point.x()};
  EXPECT_EQ(likelyUp(points), UpAxis::y);
  for (Eigen::Vector3d& point : points)
    point = 1000 * Eigen::Vector3d(point.y() - 7, point.z(), point.x());
  EXPECT_EQ(likelyUp(points), UpAxis::x);
}

/// As in a file whose y axis points up.
std::vector<Eigen::Vector3d> lyingOnItsSide(const SimulatedScan& scan) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& point : scan.points.positions)
    points.emplace_back(point.y(), point.z(), point.x());
  return points;
}

TEST(LikelyUp, IsFoundOfSimulatedTreesHoweverTheyLie) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SimulatedScan tree =
        scan(growPlant({.segments = 250}, seed), {.points = 15'000, .stations = 1}, seed);
    EXPECT_EQ(likelyUp(tree.points.positions), UpAxis::z) << "seed " << seed;
    EXPECT_EQ(likelyUp(lyingOnItsSide(tree)), UpAxis::y) << "seed " << seed;
  }
}

// The foot of this shrub is wide, and one of its twigs reaches far out along x.
TEST(LikelyUp, IsNoTwigThatStandsOutAtASide) {
  const Skeleton shrub = growPlant({.architecture = Architecture::shrub, .segments = 250}, 1);
  const SimulatedScan seen = scan(shrub, {.points = 15'000, .stations = 1, .clumps = 30}, 1);
  EXPECT_EQ(likelyUp(seen.points.positions), std::nullopt);
}

/// A crown down to the ground, evenly filled, out of which a thick twig stands along y.
std::vector<Eigen::Vector3d> crownWithTwig(double height) {
  std::vector<Eigen::Vector3d> points;
  Random random(3);
  for (int i = 0; i < 4000; ++i)
    points.emplace_back(random.uniform(), random.uniform(), height * random.uniform());
  for (int i = 0; i < 300; ++i)
    points.emplace_back(0.5 + 0.01 * random.uniform(), -0.4 * random.uniform(), height / 2);
  return points;
}

TEST(LikelyUp, IsNoTwigOfAPlantThatIsMuchLongerAlongZ) {
  EXPECT_EQ(likelyUp(crownWithTwig(1.2)), UpAxis::y);
  EXPECT_EQ(likelyUp(crownWithTwig(3)), std::nullopt);
}

TEST(LikelyUp, IsNotGuessedWhereThereIsNoFoot) {
  std::vector<Eigen::Vector3d> points = tree();
  for (int i = 0; i < 6400; ++i) // ground
    points.emplace_back(0.05 * (i % 80) - 2, 0.05 * (i / 80) - 2, -0.01);
  EXPECT_EQ(likelyUp(points), std::nullopt);
  EXPECT_EQ(likelyUp({}), std::nullopt);
  EXPECT_EQ(likelyUp(std::vector<Eigen::Vector3d>(100, {1, 2, 3})), std::nullopt);
  EXPECT_EQ(likelyUp(std::vector<Eigen::Vector3d>(100, Eigen::Vector3d::Constant(NAN))),
            std::nullopt);
}

} // namespace
} // namespace espalier
