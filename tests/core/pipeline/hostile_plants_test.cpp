// Scans that are no plant, or hardly one, go through every method of every step, each with the
// defaults of the others: a sensible forest comes out, or a clear error.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/evaluate/match/comparable.h"
#include "core/pipeline/pipeline.h"
#include "tests/core/pipeline/every_method.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <numbers>

namespace espalier {
namespace {

using test::cloudOf;
using Points = Eigen::Matrix3Xf;

constexpr double spacing = 0.02; // [L], of all but the smallest scans

Points stick() {
  return test::cylinder({0, 0, 0}, {0, 0, 1}, 0.03, spacing);
}

/// A cylinder bent to a circle of radius 0.3 that stands on its rim.
Points ring() {
  Points points = test::cylinder({0, 0, 0}, {0, 0, 2 * std::numbers::pi * 0.3}, 0.03, spacing);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const float angle = points(2, i) / 0.3F;
    const float reach = 0.3F + points(0, i);
    points.col(i) =
        Eigen::Vector3f(reach * std::sin(angle), points(1, i), -reach * std::cos(angle));
  }
  return points;
}

Points twoPlants() {
  Points other = test::forkCloud(2);
  other.row(1).array() += 5;
  return test::both(test::forkCloud(), other);
}

/// One point in fifty lies anywhere in and around the plant.
Points withStrays() {
  const Points plant = test::forkCloud();
  Random random(3);
  Points strays(3, plant.cols() / 50);
  for (Eigen::Index i = 0; i < strays.cols(); ++i)
    strays.col(i) =
        Eigen::Vector3d(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 4))
            .cast<float>();
  return test::both(plant, strays);
}

/// Seen from one side only: the trunk of a fork has half its bark.
Points halfScanned() {
  const Points all = test::forkCloud();
  Points seen(3, all.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < all.cols(); ++i)
    if (all(1, i) > 0 || all(2, i) > 2) seen.col(count++) = all.col(i);
  return seen.leftCols(count);
}

Points withGap() {
  return test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.03, spacing, 1),
                    test::cylinder({0, 0, 1 + 5 * spacing}, {0, 0, 2}, 0.03, spacing, 2));
}

Points flatSheet() {
  Points points(3, 900);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = Eigen::Vector3f(static_cast<float>(i % 30), 0, static_cast<float>(i / 30)) *
                    static_cast<float>(spacing);
  return points;
}

Points threePoints() {
  Points points(3, 3);
  points << 0, 0, 0.1F, 0, 0, 0, 0, 1, 2;
  return points;
}

const std::map<std::string, Points>& hostilePlants() {
  static const std::map<std::string, Points> plants = {
      {"stick", stick()},
      {"ring", ring()},
      {"two plants", twoPlants()},
      {"strays", withStrays()},
      {"half scanned", halfScanned()},
      {"gap", withGap()},
      {"every point twice", test::both(test::forkCloud(), test::forkCloud())},
      {"flat sheet", flatSheet()},
      {"three points", threePoints()},
      {"fewer points than neighbors", test::forkCloud().leftCols(5)},
  };
  return plants;
}

/// All is finite, and lies where the scan is.
void expectSensiblePlant(const Skeleton& skeleton, const PointCloud& cloud) {
  EXPECT_FALSE(skeleton.isEmpty());
  Eigen::AlignedBox3d box = cloud.bounds();
  const double margin = 0.25 * box.diagonal().norm();
  box.min().array() -= margin;
  box.max().array() += margin;
  for (const NodeId id : skeleton.ids()) {
    EXPECT_TRUE(box.contains(skeleton[id].position)) << indexOf(id);
    EXPECT_TRUE(std::isfinite(skeleton[id].radius) && skeleton[id].radius >= 0) << indexOf(id);
  }
}

Eigen::Vector3d rootOf(const Skeleton& skeleton) {
  return skeleton[skeleton.roots().front()].position;
}

struct EveryMethod : testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(EveryMethod, MakesAForestOfAnyScanOrSaysWhyNot) {
  const auto& [step, method] = GetParam();
  PipelineOptions options;
  options.methods[step] = method;
  for (const auto& [name, points] : hostilePlants()) {
    SCOPED_TRACE(name);
    const auto cloud = cloudOf(points);
    try {
      expectSensiblePlant(*Pipeline().run(cloud, options).skeleton, *cloud);
    } catch (const Error& error) {
      EXPECT_GT(std::string(error.what()).size(), 20U) << error.what();
      EXPECT_LT(points.cols(), 10) << "a scan of this size has something to find: " << error.what();
    }
  }
}

Points times(int copies, const Points& points) {
  Points result(3, 0);
  for (int i = 0; i < copies; ++i)
    result = test::both(result, points);
  return result;
}

Points with(const Eigen::Vector3f& stray, const Points& points) {
  return test::both(stray, points);
}

TEST_P(EveryMethod, MakesTheSameWithAPointFarAway) {
  const auto& [step, method] = GetParam();
  PipelineOptions options;
  options.methods[step] = method;
  const Points plant = test::forkCloud();
  const Reconstruction alone = Pipeline().run(cloudOf(plant), options);
  const bool keepsAll = step == "clean" && method == "none";
  for (const Eigen::Vector3f& stray : {Eigen::Vector3f(30, 0, 0), Eigen::Vector3f(0, 0, -100),
                                       Eigen::Vector3f(1e6F, 4.77F, 10.78F)}) {
    SCOPED_TRACE(stray.transpose());
    const auto cloud = cloudOf(with(stray, plant));
    const Reconstruction result = Pipeline().run(cloud, options);
    EXPECT_EQ(result.scale.spacing, alone.scale.spacing);
    EXPECT_EQ(result.scale.height, alone.scale.height);
    EXPECT_LT((rootOf(*result.skeleton) - rootOf(*alone.skeleton)).norm(), 0.1);
    EXPECT_TRUE(keepsAll || *result.skeleton == *alone.skeleton);
  }
}

TEST_P(EveryMethod, MakesTheSameHoweverOftenEachPointIsThere) {
  const auto& [step, method] = GetParam();
  PipelineOptions options;
  options.methods[step] = method;
  const Points plant = test::forkCloud();
  const Reconstruction alone = Pipeline().run(cloudOf(plant), options);
  for (const int copies : {2, 8, 9, 20}) {
    const auto cloud = cloudOf(times(copies, plant));
    const Reconstruction result = Pipeline().run(cloud, options);
    EXPECT_EQ(result.scale.spacing, alone.scale.spacing) << copies;
    EXPECT_EQ(*result.skeleton, *alone.skeleton) << copies;
    for (Eigen::Index i = 0; i < cloud->size(); ++i)
      ASSERT_EQ(result.contracted->col(i), alone.contracted->col(i / copies)) << copies << ' ' << i;
  }
}

INSTANTIATE_TEST_SUITE_P(HostilePlants, EveryMethod, testing::ValuesIn(test::everyMethod()),
                         [](const auto& each) {
                           return each.param.first + "_" + each.param.second;
                         });

Skeleton reconstructed(const Points& points) {
  return *Pipeline().run(cloudOf(points, {0, 0, 0})).skeleton;
}

TEST(HostilePlants, AStickIsOneAxisOfItsLength) {
  const Skeleton skeleton = reconstructed(stick());
  EXPECT_EQ(test::countTips(skeleton), 1);
  EXPECT_NEAR(totalLength(skeleton), 1, 3 * spacing);
  for (const NodeId id : skeleton.ids())
    EXPECT_LT(skeleton[id].position.head<2>().norm(), spacing) << indexOf(id);
}

// No tree goes round: the two arms from the foot meet on top without being joined there.
TEST(HostilePlants, ARingIsCutIntoTwoArms) {
  const Skeleton skeleton = reconstructed(ring());
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 2);
  EXPECT_NEAR(totalLength(skeleton), 2 * std::numbers::pi * 0.3, 0.3);
}

TEST(HostilePlants, TwoPlantsAreOneTreeUnlessTheGapIsTooWide) {
  const Skeleton joined = reconstructed(twoPlants());
  EXPECT_EQ(joined.roots().size(), 1U);
  EXPECT_EQ(test::countTips(joined), 3) << "the two are joined along an arm of each";
  PipelineOptions options;
  options.set("skeleton.widest_gap=1");
  const Skeleton alone = *Pipeline().run(cloudOf(twoPlants(), {0, 0, 0}), options).skeleton;
  EXPECT_EQ(alone.roots().size(), 1U);
  EXPECT_EQ(test::countTips(alone), 2) << "what cannot be reached from the root is left out";
}

TEST(HostilePlants, StraysMakeNoTwigs) {
  const Skeleton skeleton = reconstructed(withStrays());
  EXPECT_EQ(test::countTips(skeleton), 2);
  EXPECT_LT(test::farthestFromFork(skeleton), 3 * spacing);
}

TEST(HostilePlants, AHalfScannedTrunkStaysWithinItsWood) {
  const Skeleton skeleton = reconstructed(halfScanned());
  EXPECT_EQ(test::countTips(skeleton), 2);
  EXPECT_LT(test::farthestFromFork(skeleton), 0.04) << "the radius of the wood";
}

TEST(HostilePlants, AGapOfFiveSpacingsIsBridged) {
  const Skeleton skeleton = reconstructed(withGap());
  EXPECT_EQ(skeleton.roots().size(), 1U);
  EXPECT_EQ(test::countTips(skeleton), 1);
  EXPECT_NEAR(totalLength(skeleton), 2, 4 * spacing);
}

TEST(HostilePlants, AFewCopiesOfSomePointsChangeNothing) {
  const Points plant = test::forkCloud();
  const Points some = test::both(plant, times(11, plant.leftCols(plant.cols() / 3)));
  EXPECT_EQ(reconstructed(some), reconstructed(plant));
}

// Too near to be far, and in no one's way: cleaning leaves them out as isolated.
TEST(HostilePlants, StraysBelowThePlantAreNotItsFoot) {
  const Points plant = test::forkCloud();
  Points points = plant;
  for (const float below : {-0.7F, -0.9F, -1.2F, -2.5F})
    points = with({0.4F, -0.3F, below}, points);
  for (const char* clean : {"isolated_points", "none"}) {
    PipelineOptions options;
    options.methods["clean"] = clean;
    const auto cloud = cloudOf(points, {0, 0, 0});
    const Reconstruction result = Pipeline().run(cloud, options);
    EXPECT_LT(rootOf(*result.skeleton).norm(), 0.2) << clean;
    EXPECT_EQ(result.scale.height, test::heightOf(plant, UpAxis::z)) << clean;
    EXPECT_NEAR(result.scale.spacing, pointSpacing(plant), 1e-3 * spacing) << clean;
  }
}

TEST(HostilePlants, PointsSetAsideDoNotCountForTheScale) {
  const auto cloud = cloudOf(twoPlants(), {0, 0, 0}); // one 1 spacing lower would not be seen
  std::vector<Eigen::Index> upper;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->position(i).z() > 1) upper.push_back(i);
  PipelineOptions options;
  options.leftOut = PointSet::of(upper);
  Pipeline pipeline;
  EXPECT_NEAR(pipeline.run(cloud, options).scale.height, 1, 2 * spacing);
  EXPECT_GT(pipeline.run(cloud).scale.height, 3);
}

} // namespace
} // namespace espalier
