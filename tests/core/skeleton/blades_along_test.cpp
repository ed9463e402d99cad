#include "core/skeleton/blades_along.h"
#include "core/skeleton/checks_of_scan.h"
#include "tests/support/cloud_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace espalier {
namespace {

constexpr double spacing = 0.01;

/// A stem of height 1 and of a radius of one spacing, with nodes each 0.1.
Skeleton bladeStem() {
  Skeleton plant;
  std::optional<NodeId> last;
  for (int i = 0; i <= 10; ++i)
    last = plant.add({.position = {0, 0, 0.1 * i}, .radius = spacing, .parent = last});
  return plant;
}

/// Points a spacing apart, of a sheet, `z` high and `off` from the stem.
std::shared_ptr<const PointCloud>
sheetOfPoints(double lowest, double highest, double least, double most,
              const std::function<Eigen::Vector3d(double z, double off)>& place) {
  std::vector<Eigen::Vector3d> places;
  for (double z = lowest; z <= highest; z += spacing)
    for (double off = least; off <= most; off += spacing)
      places.push_back(place(z, off));
  Eigen::Matrix3Xf points(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = places[i].cast<float>();
  return test::cloudAtOrigin(points);
}

Eigen::Vector3d besideStem(double z, double off) {
  return {off, 0, z};
}

/// Those of all points that are no blade.
std::vector<Eigen::Index> offBlades(const std::shared_ptr<const PointCloud>& cloud,
                                    const Skeleton& plant) {
  std::vector<Eigen::Index> all(static_cast<std::size_t>(cloud->size()));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  const PointDistances distances(cloud, spacing, plant);
  return pointsOffBlades(plant, all, distances, 3 * spacing, spacing);
}

bool isBlade(const std::shared_ptr<const PointCloud>& cloud, const Skeleton& plant) {
  return offBlades(cloud, plant).empty();
}

TEST(BladesAlong, AreWideFlatAndTouchTheAxis) {
  const Skeleton plant = bladeStem();
  EXPECT_TRUE(isBlade(sheetOfPoints(0.1, 0.9, 0.045, 0.15, besideStem), plant));
  EXPECT_FALSE(isBlade(sheetOfPoints(0.1, 0.9, 0.045, 0.075, besideStem), plant))
      << "as narrow as a twig";
  EXPECT_FALSE(isBlade(sheetOfPoints(0.1, 0.9, 0.07, 0.18, besideStem), plant))
      << "a gap lies between";
  EXPECT_FALSE(isBlade(sheetOfPoints(0.4, 0.6, 0.045, 0.3, besideStem), plant)) << "it sticks out";
}

TEST(BladesAlong, AreBothHalvesAndMayBendAlongTheAxis) {
  const auto halves = sheetOfPoints(0.1, 0.9, -0.15, 0.15, [](double z, double off) {
    return Eigen::Vector3d(off + std::copysign(0.045, off), 0, z);
  });
  EXPECT_TRUE(isBlade(halves, bladeStem()));
  const auto turning = sheetOfPoints(0.1, 0.9, 0.045, 0.15, [](double z, double off) {
    return Eigen::Vector3d(off * std::cos(2 * z), off * std::sin(2 * z), z);
  });
  EXPECT_TRUE(isBlade(turning, bladeStem()));
}

/// Half of a blade along the stem, 0.15 wide, and a leaf 0.06 wide that grows aside from its
/// margin.
Eigen::Vector3d bladeWithLeaf(double z, double off) {
  if (off <= 0.15) return {off, 0, z};
  return {0.15 + 0.5 * (off - 0.15), 0.87 * (off - 0.15), z};
}

std::shared_ptr<const PointCloud> pointsOfBladeWithLeaf(double least) {
  const auto blade = sheetOfPoints(0.1, 0.9, least, 0.15, bladeWithLeaf);
  const auto leaf = sheetOfPoints(0.47, 0.53, 0.16, 0.8, bladeWithLeaf);
  Eigen::Matrix3Xf all(3, blade->size() + leaf->size());
  all << blade->positions(), leaf->positions();
  return test::cloudAtOrigin(all);
}

TEST(BladesAlong, ALeafOnTheirMarginIsNone) {
  const auto cloud = pointsOfBladeWithLeaf(0.045);
  const std::vector<Eigen::Index> left = offBlades(cloud, bladeStem());
  const Eigen::Index leaf = 7 * 65; // its points
  EXPECT_GE(static_cast<Eigen::Index>(left.size()), leaf * 3 / 4);
  const auto ofBlade = std::ranges::count_if(
      left, [&](Eigen::Index point) { return cloud->position(point).x() < 0.15; });
  EXPECT_LE(ofBlade, 5) << "at most, of 891";
}

TEST(BladesAlong, ALeafOnTheirMarginIsAFindingOfItsOwn) {
  const Skeleton plant = bladeStem();
  const auto cloud = pointsOfBladeWithLeaf(-0.15); // both halves, and what the stem explains
  const PointDistances distances(cloud, spacing, plant);
  constexpr double leaf = 7 * 65; // points
  ASSERT_GT(unexplainedClusters(distances, spacing, {}).front().amount, 2 * leaf);
  const std::vector<Finding> found = pointsWithoutWood(plant, distances, spacing, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LE(found[0].amount, leaf);
}

TEST(BladesAlong, AStemBesideTheAxisIsNone) {
  const auto round = sheetOfPoints(0.1, 0.9, 0, 6.28, [](double z, double around) {
    return Eigen::Vector3d(0.1 + 0.055 * std::cos(around), 0.055 * std::sin(around), z);
  });
  EXPECT_FALSE(isBlade(round, bladeStem()));
}

TEST(BladesAlong, ABranchThatLeavesAtASharpAngleIsNone) {
  const auto branch = sheetOfPoints(0, 0.5, -0.02, 0.02, [](double along, double across) {
    return Eigen::Vector3d(0.045 + 0.5 * along, across, 0.3 + 0.87 * along);
  });
  EXPECT_FALSE(isBlade(branch, bladeStem()));
}

TEST(BladesAlong, AreNoFinding) {
  const Skeleton plant = bladeStem();
  const auto cloud =
      sheetOfPoints(0, 1, 0, 0.15, besideStem); // with the points that the stem explains
  const PointDistances distances(cloud, spacing, plant);
  EXPECT_FALSE(unexplainedClusters(distances, spacing, {}).empty());
  EXPECT_TRUE(pointsWithoutWood(plant, distances, spacing, {}).empty());
}

} // namespace
} // namespace espalier
