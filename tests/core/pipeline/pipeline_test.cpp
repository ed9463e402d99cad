#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <string>

namespace espalier {
namespace {

using test::cloudOf;

TEST(Pipeline, TurnsAScanIntoASkeletonWithRadii) {
  const Reconstruction result = Pipeline().run(cloudOf(test::forkCloud()));
  EXPECT_EQ(result.skeleton->roots().size(), 1U);
  EXPECT_EQ(test::countTips(*result.skeleton), 2);
  for (const NodeId id : result.skeleton->ids())
    EXPECT_GT((*result.skeleton)[id].radius, 0);
  const Eigen::Vector3d root = (*result.skeleton)[result.skeleton->roots().front()].position;
  EXPECT_LT((root - Eigen::Vector3d(500, 600, 700)).norm(), 0.25);
}

TEST(Pipeline, DoesNotFollowStrayPoints) {
  Eigen::Matrix3Xf strays(3, 3);
  strays << 2, -2, 0, 1, 1, -2, 2, 1, 3;
  const Reconstruction result = Pipeline().run(cloudOf(test::both(test::forkCloud(), strays)));
  EXPECT_EQ(test::countTips(*result.skeleton), 2);
}

// Two parallel trunks stand beside each other; one of them is set aside.
TEST(Pipeline, SeesNothingOfPointsThatAreSetAside) {
  Eigen::Matrix3Xf other = test::forkCloud(2);
  other.row(0).array() += 0.3F;
  const auto cloud = cloudOf(test::both(test::forkCloud(), other), {0, 0, 0});
  std::vector<Eigen::Index> ofOther;
  for (Eigen::Index i = 0; i < cloud->size(); ++i)
    if (cloud->fileOrder()[static_cast<std::size_t>(i)] >= test::forkCloud().cols())
      ofOther.push_back(i);
  PipelineOptions options;
  options.leftOut = PointSet::of(ofOther);
  Pipeline pipeline;
  const Reconstruction alone = pipeline.run(cloud, options);
  EXPECT_EQ(test::countTips(*alone.skeleton), 2);
  EXPECT_LT(test::farthestFromFork(*alone.skeleton), 0.08);
  EXPECT_EQ(alone.contracted->cols(), cloud->size()) << "one for each point, as always";
  EXPECT_GT(test::farthestFromFork(*pipeline.run(cloud, {}).skeleton), 0.2)
      << "brought back, they are seen again";
}

TEST(Pipeline, IsRefusedIfAllPointsAreSetAside) {
  const auto cloud = cloudOf(test::forkCloud());
  PipelineOptions options;
  options.leftOut = PointSet::firstOf(cloud->size());
  EXPECT_THROW((void)Pipeline().run(cloud, options), Error);
}

TEST(Pipeline, GivesTheSameAnewAsFromWhatIsAtHand) {
  const auto cloud = cloudOf(test::forkCloud());
  Pipeline kept;
  (void)kept.run(cloud);
  PipelineOptions options;
  options.set("contract.radius=0.2");
  EXPECT_EQ(*kept.run(cloud, options).skeleton, *Pipeline().run(cloud, options).skeleton);
}

TEST(Pipeline, RunsUpToAStep) {
  const Reconstruction result = Pipeline().run(cloudOf(test::forkCloud()), {}, {}, "contract");
  EXPECT_TRUE(result.skeleton->isEmpty());
  ASSERT_TRUE(result.contracted);
  EXPECT_EQ(result.steps.back().step, "contract");
}

TEST(Pipeline, RefusesARootFarFromTheScan) {
  PipelineOptions options;
  options.root = Eigen::Vector3d(1e9, 0, 0);
  EXPECT_THROW((void)Pipeline().run(cloudOf(test::forkCloud()), options), Error);
}

TEST(Pipeline, StartsAtTheRootItIsGiven) {
  PipelineOptions options;
  options.root = Eigen::Vector3d(500 + 0.86, 600, 703.2);
  const Reconstruction result = Pipeline().run(cloudOf(test::forkCloud()), options);
  const Eigen::Vector3d root = (*result.skeleton)[result.skeleton->roots().front()].position;
  EXPECT_LT((root - *options.root).norm(), 0.25);
}

TEST(Pipeline, TakesMillimetersLikeMeters) {
  const Skeleton meters = *Pipeline().run(cloudOf(test::forkCloud(), {0, 0, 0})).skeleton;
  const Skeleton millimeters =
      *Pipeline().run(cloudOf(1024 * test::forkCloud(), {0, 0, 0})).skeleton; // exact in binary
  EXPECT_NEAR(static_cast<double>(millimeters.size()), static_cast<double>(meters.size()), 2);
  EXPECT_EQ(test::countTips(millimeters), test::countTips(meters));
}

TEST(Pipeline, IsTheSameOnAnyNumberOfThreads) {
  const auto cloud = cloudOf(test::forkCloud());
  const Skeleton onMany = *Pipeline().run(cloud).skeleton;
  const ThreadLimit limit(1);
  EXPECT_EQ(*Pipeline().run(cloud).skeleton, onMany);
}

TEST(Pipeline, RefusesScansWithoutAPlant) {
  EXPECT_THROW((void)Pipeline().run(cloudOf(Eigen::Matrix3Xf(3, 0))), Error);
  EXPECT_THROW((void)Pipeline().run(cloudOf(Eigen::Matrix3Xf::Ones(3, 1))), Error);
  EXPECT_THROW((void)Pipeline().run(cloudOf(Eigen::Matrix3Xf::Ones(3, 100))), Error);
}

TEST(Pipeline, TakesTheFewestPointsThereCanBe) {
  for (int count = 2; count < 30; ++count)
    EXPECT_FALSE(Pipeline().run(cloudOf(test::forkCloud().leftCols(count))).skeleton->isEmpty());
}

TEST(Pipeline, RefusesOptionsItDoesNotKnowAndValuesOutOfRange) {
  const auto cloud = cloudOf(test::forkCloud());
  const auto runWith = [&](const std::string& assignment) {
    PipelineOptions options;
    options.set(assignment);
    (void)Pipeline().run(cloud, options);
  };
  EXPECT_THROW(runWith("contract.strength=2"), Error);
  EXPECT_THROW(runWith("contract.radius=-1"), Error);
  EXPECT_THROW(runWith("contract.neighbors=3.5"), Error);
  EXPECT_THROW(runWith("contract.radius"), Error);
  EXPECT_THROW(runWith("contract.radius=wide"), Error);
  EXPECT_THROW(runWith("contract.circles=1"), Error); // a word is meant
  EXPECT_THROW(runWith("flower.radius=1"), Error);
  EXPECT_THROW(runWith("skeleton.method=magic"), Error);
}

TEST(Pipeline, NamesARangeInFewDigitsThatCanBeTyped) {
  const auto cloud = cloudOf(test::forkCloud());
  PipelineOptions options;
  options.set("contract.radius=1e6");
  std::string message;
  try {
    (void)Pipeline().run(cloud, options);
  } catch (const Error& error) {
    message = error.what();
  }
  std::smatch ends;
  ASSERT_TRUE(std::regex_search(message, ends, std::regex("from ([0-9.e+-]+) to ([0-9.e+-]+) ")))
      << message;
  for (const std::string& end : {ends.str(1), ends.str(2)}) {
    EXPECT_LE(std::ranges::count_if(end, [](unsigned char c) { return std::isdigit(c) != 0; }), 6)
        << "three that count, and zeros: " << message;
    options.set("contract.radius=" + end);
    EXPECT_NO_THROW((void)Pipeline().run(cloud, options)) << end;
  }
}

TEST(Pipeline, ReportsTheStepOfAValueThatIsOutOfRange) {
  PipelineOptions options;
  options.set("contract.radius=1e6");
  std::string stage;
  const Progress progress({}, [&](double, std::string_view name) { stage = name; });
  EXPECT_THROW((void)Pipeline().run(cloudOf(test::forkCloud()), options, progress), Error);
  EXPECT_EQ(stage, stepNamed("contract").label);
}

TEST(Pipeline, StopsWhenAsked) {
  const auto cloud = cloudOf(test::forkCloud());
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)Pipeline().run(cloud, {}, progress); }));
}

} // namespace
} // namespace espalier
