#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/clean/organs.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/leafy_plants.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

using test::LabeledCloud;
using test::labeledScanOf;
using test::leafyHerb;

std::vector<Organ> foundIn(const LabeledCloud& scan) {
  return organsAmong(scan.cloud.positions(), std::nullopt, scan.spacing()).ofPoint;
}

/// How many of the points of `organ` are found to be among `found`.
double shareFound(const std::vector<Organ>& are, const std::vector<Organ>& found, Organ organ,
                  const std::vector<Organ>& as) {
  int all = 0, right = 0;
  for (std::size_t i = 0; i < are.size(); ++i)
    if (are[i] == organ) {
      ++all;
      right += std::ranges::count(as, found[i]) > 0;
    }
  return static_cast<double>(right) / std::max(1, all);
}

double shareAlike(const std::vector<Organ>& a, const std::vector<Organ>& b) {
  double alike = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    alike += a[i] == b[i];
  return alike / static_cast<double>(a.size());
}

TEST(Organs, OfAHerbAreFound) {
  const LabeledCloud& herb = leafyHerb();
  const std::vector<Organ> found = foundIn(herb);
  EXPECT_GT(shareFound(herb.organs, found, Organ::blade, {Organ::blade}), 0.9);
  EXPECT_GT(shareFound(herb.organs, found, Organ::wood, {Organ::wood, Organ::petiole}), 0.9);
}

TEST(Organs, OfABareTreeAreNearlyAllWood) {
  const LabeledCloud tree = labeledScanOf(growPlant({.segments = 60}, 90'002), {}, 20'000);
  EXPECT_GT(shareFound(tree.organs, foundIn(tree), Organ::wood, {Organ::wood}), 0.85);
}

TEST(Organs, AreTheSameInAnotherUnit) {
  const LabeledCloud& herb = leafyHerb();
  const Eigen::Matrix3Xf larger = 1024 * herb.cloud.positions();
  EXPECT_EQ(organsAmong(larger, std::nullopt, 1024 * herb.spacing()).ofPoint, foundIn(herb));
}

// Sums are rounded otherwise.
TEST(Organs, OfATurnedPlantAreNearlyTheSame) {
  const LabeledCloud& herb = leafyHerb();
  const Eigen::Matrix3f turn = Eigen::AngleAxisf(0.7F, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3Xf turned = turn * herb.cloud.positions();
  const auto found = organsAmong(turned, std::nullopt, herb.spacing()).ofPoint;
  EXPECT_GT(shareAlike(found, foundIn(herb)), 0.99);
}

TEST(Organs, AreTheSameOnAnyNumberOfThreads) {
  const auto found = [](int threads) {
    const ThreadLimit limit(threads);
    return foundIn(leafyHerb());
  };
  EXPECT_EQ(found(1), found(2));
}

// The lowest points are of a leaf.
TEST(Organs, HaveTheirRootOnWood) {
  const PointCloud cloud = test::hangingLeaf();
  const Eigen::Matrix3Xf& positions = cloud.positions();
  const FoundOrgans found = organsAmong(positions, std::nullopt, pointSpacing(positions));
  const Eigen::Vector3d root = cloud.position(found.root);
  EXPECT_LT(root.head<2>().norm(), 0.02) << root.transpose();
  EXPECT_LT(root.z(), 0.1);
}

TEST(Organs, OfFewPointsAreOnePerPoint) {
  for (const Eigen::Index count : {1, 2, 5, 40}) {
    Random random(4);
    Eigen::Matrix3Xf points(3, count);
    for (Eigen::Index i = 0; i < count; ++i)
      points.col(i) = random.direction().cast<float>();
    EXPECT_EQ(std::ssize(organsAmong(points, 0, 0.1).ofPoint), count);
  }
}

TEST(Organs, OfPointsAtOnePlaceAreAllTheSame) {
  const Eigen::Matrix3Xf points = Eigen::Matrix3Xf::Constant(3, 300, 2);
  const std::vector<Organ> found = organsAmong(points, 0, 0.1).ofPoint;
  EXPECT_EQ(std::ranges::count(found, found.front()), std::ssize(found));
}

TEST(Organs, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  const LabeledCloud& herb = leafyHerb();
  EXPECT_THROW(
      (void)organsAmong(herb.cloud.positions(), 0, herb.spacing(), Progress(stop.get_token(), {})),
      Cancelled);
}

} // namespace
} // namespace espalier
