#include "core/base/error.h"
#include "core/pipeline/sweep.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

const Option& optionNamed(const std::string& step, const std::string& method,
                          const std::string& name) {
  for (const Option& option : methodNamed(stepNamed(step), method).options)
    if (option.name == name) return option;
  throw Error("no option " + name);
}

constexpr PlantScale sweptScale{.spacing = 2, .height = 1000};

TEST(SweepValues, StandAroundTheDefaultByEqualRatios) {
  const Option& radius = optionNamed("contract", "geodesic_centroid", "radius"); // 7.5 spacings
  EXPECT_THAT(sweepValues(radius, sweptScale, 5),
              ElementsAre(DoubleNear(3.75, 1e-9), DoubleNear(7.5, 1e-9), DoubleNear(15, 1e-9),
                          DoubleNear(30, 1e-9), DoubleNear(60, 1e-9)));
  EXPECT_THAT(sweepValues(radius, sweptScale, 1), ElementsAre(DoubleNear(15, 1e-9)));
}

TEST(SweepValues, StandBetweenTheEndsOneChooses) {
  const Option& radius = optionNamed("contract", "geodesic_centroid", "radius");
  EXPECT_THAT(sweepValues(radius, sweptScale, 3, std::pair(10.0, 40.0)),
              ElementsAre(DoubleNear(10, 1e-9), DoubleNear(20, 1e-9), DoubleNear(40, 1e-9)));
  EXPECT_THAT(sweepValues(radius, sweptScale, 1, std::pair(10.0, 40.0)),
              ElementsAre(DoubleNear(10, 1e-9)));
  const Option& neighbors = optionNamed("contract", "geodesic_centroid", "neighbors"); // from 3
  EXPECT_THAT(sweepValues(neighbors, sweptScale, 4, std::pair(1.0, 4.0)), ElementsAre(3, 4));
  const Option& turn = optionNamed("axes", "weighed", "sharpest_turn");
  EXPECT_THAT(sweepValues(turn, sweptScale, 3, std::pair(10.0, 30.0)), ElementsAre(10, 20, 30));
}

TEST(SweepValues, AreAsPeopleReadThemButForTheDefault) {
  const Option& radius = optionNamed("contract", "geodesic_centroid", "radius");
  EXPECT_THAT(sweepValues(radius, {.spacing = 0.506312, .height = 1000}, 3),
              ElementsAre(DoubleNear(0.949, 1e-9), 7.5 * 0.506312, DoubleNear(15.2, 1e-9)));
}

TEST(SweepValues, AreWholeForCounts) {
  const Option& neighbors = optionNamed("contract", "geodesic_centroid", "neighbors"); // 7, from 3
  EXPECT_THAT(sweepValues(neighbors, sweptScale, 3), ElementsAre(3, 9, 28));
  const Option& rounds = optionNamed("recenter", "sections", "rounds"); // 1
  EXPECT_THAT(sweepValues(rounds, sweptScale, 20), ElementsAre(1, 2, 3, 4)) << "each once";
}

TEST(SweepValues, AreEvenWhereTheDefaultIsZeroAndForAngles) {
  const Option& gap = optionNamed("skeleton", "geodesic_bins", "widest_gap");
  EXPECT_THAT(sweepValues(gap, sweptScale, 3), ElementsAre(0, 40, 80));
  const Option& turn = optionNamed("axes", "weighed", "sharpest_turn"); // from 1 to 180
  EXPECT_THAT(sweepValues(turn, sweptScale, 3), ElementsAre(1, 90.5, 180));
}

TEST(SweepValues, AreAllWordsThatAnOptionTakes) {
  const Option& circles = optionNamed("contract", "geodesic_centroid", "circles");
  EXPECT_THAT(sweepValues(circles, sweptScale, 9), ElementsAre(0, 1));
}

// Every value that is offered is one that the pipeline takes.
TEST(SweepValues, AreInRangeForEveryOption) {
  for (const Step& step : pipelineSteps())
    for (const Method& method : step.methods)
      for (const Option& option : method.options)
        for (const double value : sweepValues(option, sweptScale, 7)) {
          PipelineOptions options;
          options.methods[step.name] = method.name;
          options.settings[step.name][option.name] = fixedAt(value);
          EXPECT_NO_THROW((void)resolvedValues(step, method, options, sweptScale))
              << step.name << '.' << option.name << " = " << value;
        }
}

struct Sweeps : testing::Test {
  std::shared_ptr<const PointCloud> cloud = test::cloudOf(test::forkCloud());
  Pipeline pipeline;
  PipelineOptions options;
  std::vector<SweepResult> results;

  void sweep(const std::string& step, const std::string& option, const std::vector<double>& values,
             const std::string& last = {}) {
    results.clear();
    runSweep(pipeline, cloud, options, step, option, values, last, {},
             [&](const SweepResult& result) { results.push_back(result); });
  }
};

TEST_F(Sweeps, GiveWhatEachValueGives) {
  sweep("contract", "radius", {0.08, 0.12, 0.2});
  ASSERT_EQ(results.size(), 3U);
  for (const SweepResult& result : results) {
    PipelineOptions own = options;
    own.settings["contract"]["radius"] = fixedAt(result.value);
    EXPECT_EQ(*result.reconstruction.skeleton, *Pipeline().run(cloud, own).skeleton);
    EXPECT_TRUE(result.failure.empty());
  }
  EXPECT_FALSE(results[1].reconstruction.steps[0].isNew) << "what lies before is computed once";
}

TEST_F(Sweeps, GiveWhatEachMethodGives) {
  const Step& contract = stepNamed("contract");
  options.set("contract.radius=0.12");
  const double own = *methodOption(contract).valueOf(contract.methods.front().name);
  const double other = *methodOption(contract).valueOf("euclidean_ball");
  sweep("contract", "method", {own, other});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(*results[0].reconstruction.skeleton, *Pipeline().run(cloud, options).skeleton);
  PipelineOptions ball;
  ball.set("contract.method=euclidean_ball");
  EXPECT_EQ(*results[1].reconstruction.skeleton, *Pipeline().run(cloud, ball).skeleton)
      << "by its own defaults";
}

TEST_F(Sweeps, EndWithTheStepThatIsAskedFor) {
  sweep("contract", "radius", {0.1}, "contract");
  EXPECT_EQ(results.front().reconstruction.steps.back().step, "contract");
}

// Of two plants, that of the root has a third of the points: no skeleton but over the gap.
TEST_F(Sweeps, ReportValuesThatFail) {
  cloud = test::cloudOf(test::both(test::forkCloud(), (test::forkCloud(2).array() + 5).matrix()),
                        {0, 0, 0});
  std::vector<Eigen::Index> halfOfOne;
  for (Eigen::Index i = 0; i < cloud->size(); i += 2)
    if (cloud->position(i).y() < 2) halfOfOne.push_back(i);
  options.leftOut = PointSet::of(halfOfOne);
  options.root = Eigen::Vector3d(0, 0, 0);
  sweep("skeleton", "widest_gap", {0.1, 0});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_FALSE(results[0].failure.empty());
  EXPECT_TRUE(results[0].reconstruction.skeleton->isEmpty());
  EXPECT_TRUE(results[1].failure.empty()) << "the next value is tried";
}

TEST_F(Sweeps, RefuseWhatTheyCannotTryBeforeTheyRun) {
  EXPECT_THROW(sweep("contract", "strength", {1}), Error);
  EXPECT_THROW(sweep("flower", "radius", {1}), Error);
  EXPECT_THROW(sweep("contract", "radius", {0.1, -1}), Error);
  EXPECT_TRUE(results.empty());
}

TEST_F(Sweeps, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    runSweep(pipeline, cloud, options, "contract", "radius", {0.1}, {}, progress,
             [](const SweepResult&) {});
  }));
}

} // namespace
} // namespace espalier
