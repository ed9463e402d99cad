#include "core/decide/error_ratings.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/length_along.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/support/simulated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace espalier {
namespace {

std::shared_ptr<const PointCloud> scanOfTree() {
  return std::make_shared<const PointCloud>(test::simulatedTree().cloud);
}

std::vector<double> ratedBy(const Skeleton& plant, const std::shared_ptr<const PointCloud>& cloud,
                            const Progress& progress = {}) {
  const PlantScale scale = scaleOf(*cloud, {}, UpAxis::z);
  const SpatialIndex index(cloud->positions());
  const PointDistances distances(cloud, scale.spacing, plant);
  return errorRatings(plant, distances, index, scale, Eigen::Vector3d::UnitZ(), progress).ofEdges;
}

/// The share of the length of some nodes that is as probably wrong as that, and more.
double shareFrom(double probability, const Skeleton& plant, const std::vector<NodeId>& nodes,
                 const std::vector<double>& rated) {
  double all = 0, risky = 0;
  for (const NodeId id : nodes) {
    all += edgeLength(plant, id);
    if (rated[indexOf(id)] >= probability) risky += edgeLength(plant, id);
  }
  return risky / all;
}

TEST(ErrorRatings, RateWoodThatIsNotThereHigherThanWoodThatIs) {
  const auto cloud = scanOfTree();
  Skeleton plant = test::simulatedTree().truth;
  const std::vector<NodeId> real = plant.ids();
  const double spacing = pointSpacing(cloud->positions());
  const std::vector<double> before = ratedBy(plant, cloud);
  EXPECT_LT(shareFrom(0.5, plant, real, before), 0.1);
  std::vector<NodeId> invented;
  NodeId parent = real[real.size() / 2];
  const Eigen::Vector3d away(20 * spacing, 0, 5 * spacing);
  for (int i = 1; i <= 6; ++i) {
    parent = plant.add({.position = plant[parent].position + away,
                        .radius = plant[parent].radius,
                        .parent = parent,
                        .edge = i == 1 ? EdgeType::branching : EdgeType::successor});
    invented.push_back(parent);
  }
  EXPECT_GT(shareFrom(0.5, plant, invented, ratedBy(plant, cloud)), 0.9);
}

TEST(ErrorRatings, AreTheSameInAnotherUnitAndPlace) {
  const auto cloud = scanOfTree();
  const Skeleton plant = test::simulatedTree().truth;
  const Eigen::Vector3d place(3e5, -2e5, 100);
  Skeleton moved = plant;
  for (const NodeId id : plant.ids()) {
    moved.setPosition(id, 1000 * plant[id].position + place);
    moved.setRadius(id, 1000 * plant[id].radius);
  }
  const auto movedCloud = test::cloudOf(1000 * cloud->positions(), 1000 * cloud->origin() + place);
  const std::vector<double> a = ratedBy(plant, cloud);
  const std::vector<double> b = ratedBy(moved, movedCloud);
  ASSERT_EQ(a.size(), b.size());
  std::size_t other = 0; // floats: a point may lie on either side of a limit
  for (std::size_t i = 0; i < a.size(); ++i)
    other += std::abs(a[i] - b[i]) > 0.02 ? 1 : 0;
  EXPECT_LE(other, a.size() / 100);
}

TEST(ErrorRatings, CountWhatIsNearAPieceInSpacings) {
  // A stem of 40 with a branch of 10 to the side, and points along the stem alone, 1 apart.
  Skeleton plant = test::stick(5, 10);
  const NodeId tip =
      plant.add({.position = {10, 0, 20}, .parent = NodeId{2}, .edge = EdgeType::branching});
  Eigen::Matrix3Xf points(3, 41);
  for (int i = 0; i <= 40; ++i)
    points.col(i) = Eigen::Vector3f(0.5F, 0, static_cast<float>(i));
  const auto cloud = test::cloudAtOrigin(points);
  const PlantScale scale{.spacing = 1, .height = 40};
  const SpatialIndex index(cloud->positions());
  const PointDistances distances(cloud, 1, plant);
  const std::vector<Stretch> pieces = stretches(plant, 100);
  const auto found =
      errorEvidence(plant, pieces, distances, index, scale, Eigen::Vector3d::UnitZ());
  const auto of = [&](NodeId id) {
    return found[static_cast<std::size_t>(
        std::ranges::find_if(pieces,
                             [&](const Stretch& piece) { return std::ranges::count(piece, id); }) -
        pieces.begin())];
  };
  const ErrorEvidence branch = of(tip);
  EXPECT_DOUBLE_EQ(branch.length, 10);
  EXPECT_DOUBLE_EQ(branch.whole, 10);
  EXPECT_DOUBLE_EQ(branch.carried, 0);
  EXPECT_NEAR(branch.inAir, 0.8, 1e-6); // its first two spacings are near the points of the stem
  EXPECT_NEAR(branch.turn, 0, 1e-12);
  EXPECT_TRUE(branch.branches);
  EXPECT_TRUE(branch.isEnd);
  EXPECT_GT(branch.withoutOwn, 3);
  const ErrorEvidence stem = of(NodeId{2});
  EXPECT_DOUBLE_EQ(stem.length, 20);
  EXPECT_DOUBLE_EQ(stem.carried, 30);
  EXPECT_NEAR(stem.points, 20, 1.5);
  EXPECT_NEAR(stem.scatter, 0.5 - plant[NodeId{2}].radius, 1e-6);
  EXPECT_DOUBLE_EQ(stem.inAir, 0);
  EXPECT_DOUBLE_EQ(stem.withoutOwn, 0);
  EXPECT_FALSE(stem.branches);
  EXPECT_FALSE(stem.isEnd);
}

TEST(ErrorRatings, HaveThePieceOfSomeNodesThatIsProbablyWrongForMost) {
  ErrorEvidence longOne{.length = 10}, shortOne{.length = 2};
  const ErrorRatings ratings{.ofEdges = {0, 0.1, 0.1, 0.3, 0.9},
                             .pieces = {{NodeId{1}, NodeId{2}}, {NodeId{3}}, {NodeId{4}}},
                             .evidence = {longOne, longOne, shortOne}};
  EXPECT_EQ(riskiestPiece(ratings, {NodeId{1}, NodeId{2}, NodeId{4}}), 2); // 1 and 1.8 spacings
  EXPECT_EQ(riskiestPiece(ratings, {NodeId{1}, NodeId{3}, NodeId{4}}), 1);
  EXPECT_EQ(riskiestPiece(ratings, {NodeId{0}, NodeId{7}}), std::nullopt) << "a root, a later node";
}

TEST(ErrorRatings, CanBeStopped) {
  const auto cloud = scanOfTree();
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    static_cast<void>(ratedBy(test::simulatedTree().truth, cloud, progress));
  }));
}

TEST(ErrorRatings, OfNothingAreNone) {
  EXPECT_TRUE(ratedBy(Skeleton(), scanOfTree()).empty());
}

} // namespace
} // namespace espalier
