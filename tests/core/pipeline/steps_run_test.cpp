// Which steps the pipeline computes after each kind of change.
#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <stop_token>

namespace espalier {
namespace {

using Names = std::vector<std::string>;
using testing::ElementsAre;
using testing::IsEmpty;

/// The steps from `first` on that are on by default.
Names from(const std::string& first) {
  Names names;
  for (const Step& step : pipelineSteps())
    if (!isOff(step, {}) && (!names.empty() || step.name == first)) names.push_back(step.name);
  return names;
}

Names newSteps(const Reconstruction& reconstruction) {
  Names names;
  for (const StepRecord& step : reconstruction.steps)
    if (step.isNew) names.push_back(step.step);
  return names;
}

/// A pipeline that has run once, with the options of that run.
struct StepsRun : testing::Test {
  std::shared_ptr<const PointCloud> cloud = test::cloudOf(test::forkCloud(), {0, 0, 0});
  PipelineOptions options;
  Pipeline pipeline;

  StepsRun() { (void)pipeline.run(cloud, options); }
  Names run(const std::string& last = {}) {
    return newSteps(pipeline.run(cloud, options, {}, last));
  }
};

TEST_F(StepsRun, AreAllForANewCloud) {
  EXPECT_EQ(newSteps(Pipeline().run(cloud)), from("thin"));
  cloud = test::cloudOf(test::forkCloud(2), {0, 0, 0});
  EXPECT_EQ(run(), from("thin"));
}

TEST_F(StepsRun, AreNoneWithoutAChange) {
  EXPECT_THAT(run(), IsEmpty());
  EXPECT_THAT(run("contract"), IsEmpty());
}

TEST_F(StepsRun, AreThoseFromTheOneWithAnotherOption) {
  for (const auto& [assignment, step] :
       std::vector<std::pair<std::string, std::string>>{{"clean.distance=20 spacings", "contract"},
                                                        {"contract.radius=0.11", "contract"},
                                                        {"skeleton.bin_width=0.11", "skeleton"},
                                                        {"axes.reach=5", "axes"},
                                                        {"prune.length=0.1", "prune"},
                                                        {"recenter.rounds=2", "recenter"}}) {
    options = {};
    (void)run(); // not the one asked for longest ago
    options.set(assignment);
    Names expected = from(step);
    if (assignment.starts_with("clean")) expected.insert(expected.begin(), "clean");
    EXPECT_EQ(run(), expected) << assignment;
  }
}

TEST_F(StepsRun, AreThoseFromTheOneWithAnotherMethod) {
  options.methods["contract"] = "euclidean_ball";
  EXPECT_EQ(run(), from("contract"));
  options.methods["radius"] = "length_pipe";
  EXPECT_EQ(run(), from("radius"));
}

TEST_F(StepsRun, AreThoseThatSeeTheRoot) {
  options.root = Eigen::Vector3d(0, 0, 1.2);
  EXPECT_EQ(run(), from("skeleton")) << "points are cleaned and contracted without it";
  options.methods["contract"] = "path_based";
  EXPECT_EQ(run(), from("contract"));
  options.root = Eigen::Vector3d(0, 0, 0.9);
  EXPECT_EQ(run(), from("contract")) << "its paths lead to the root";
}

TEST_F(StepsRun, AreNoneForTheRootThatWasFound) {
  options.root = cloud->position(findRoot(cloud->positions()));
  EXPECT_THAT(run(), IsEmpty());
}

TEST_F(StepsRun, AreAllAfterPointsAreSetAside) {
  options.leftOut = PointSet::firstOf(10);
  EXPECT_EQ(run(), from("thin"));
}

// The height of the plant changes, also of what thinning leaves; no default of these methods
// follows from it but that and the root.
TEST_F(StepsRun, AreThoseThatSeeTheRootOrTheHeightWithAnotherUpAxis) {
  options.up = UpAxis::x;
  EXPECT_EQ(run(), from("thin"));
  options.set("thin.method=none");
  (void)run();
  options.up = UpAxis::z;
  EXPECT_EQ(run(), from("skeleton"));
  options.up = UpAxis::x;
  options.methods["contract"] = "adaptive_sections";
  EXPECT_EQ(run(), from("contract"));
  options.up = UpAxis::z;
  EXPECT_EQ(run(), from("contract")) << "its radii follow from the height";
}

TEST_F(StepsRun, AreNoneOnGoingBackToOneOfFourChoices) {
  const Skeleton first = *pipeline.run(cloud, options).skeleton;
  for (const char* radius : {"0.11", "0.12", "0.13"}) {
    options.set(std::string("contract.radius=") + radius);
    EXPECT_EQ(run(), from("contract")) << radius;
  }
  options = {};
  const Reconstruction again = pipeline.run(cloud, options);
  EXPECT_THAT(newSteps(again), IsEmpty());
  EXPECT_EQ(*again.skeleton, first);
  options.leftOut = PointSet::firstOf(10);
  EXPECT_EQ(run(), from("thin"));
  options = {};
  EXPECT_THAT(run(), IsEmpty()) << "points brought back";
}

TEST_F(StepsRun, KeepNoMoreThanFourChoices) {
  for (const char* radius : {"0.11", "0.12", "0.13", "0.14"}) {
    options.set(std::string("contract.radius=") + radius);
    (void)run();
  }
  options.set("contract.radius=0.11");
  EXPECT_THAT(run(), IsEmpty());
  options = {};
  EXPECT_EQ(run(), from("contract")) << "asked for longest ago";
  options.set("contract.radius=0.12");
  EXPECT_EQ(run(), from("contract")) << "0.11 was asked for later";
}

TEST_F(StepsRun, OfARunThatWasStoppedAreKeptAsFarAsItCame) {
  options.set("contract.radius=0.11");
  std::stop_source stop;
  const StepWatch watch{.began = {}, .ended = [&](const Step& step) {
                          if (step.name == "contract") stop.request_stop();
                        }};
  EXPECT_THROW((void)pipeline.run(cloud, options, Progress(stop.get_token(), {}), {}, watch),
               Cancelled);
  EXPECT_EQ(run(), from("skeleton"));
}

// Of two plants, that of the root has a third of the points, and no link leads to the other.
TEST_F(StepsRun, OfARunThatFailedAreKeptAsFarAsItCame) {
  cloud = test::cloudOf(test::both(test::forkCloud(), (test::forkCloud(2).array() + 5).matrix()),
                        {0, 0, 0});
  std::vector<Eigen::Index> halfOfOne;
  for (Eigen::Index i = 0; i < cloud->size(); i += 2)
    if (cloud->position(i).y() < 2) halfOfOne.push_back(i);
  options.leftOut = PointSet::of(halfOfOne);
  options.root = Eigen::Vector3d(0, 0, 0);
  options.set("skeleton.widest_gap=0.1");
  Names ended;
  const StepWatch watch{.began = {},
                        .ended = [&](const Step& step) { ended.push_back(step.name); }};
  EXPECT_THROW((void)pipeline.run(cloud, options, {}, {}, watch), Error)
      << "most points are out of reach";
  EXPECT_THAT(ended, ElementsAre("thin", "clean", "contract"));
  options.set("skeleton.widest_gap=0");
  EXPECT_EQ(run(), from("skeleton"));
}

TEST_F(StepsRun, AreReportedAsTheyBeginAndEnd) {
  options.set("prune.length=0.1");
  Names reported;
  const StepWatch watch{
      .began = [&](const Step& step) { reported.push_back("began " + step.name); },
      .ended = [&](const Step& step) { reported.push_back("ended " + step.name); }};
  (void)pipeline.run(cloud, options, {}, "axes", watch);
  EXPECT_THAT(reported, ElementsAre("began prune", "ended prune", "began axes", "ended axes"));
}

TEST_F(StepsRun, TakeTheScaleOfTheWholePlant) {
  const PlantScale twice{.spacing = 2 * pipeline.run(cloud, options).scale.spacing, .height = 7};
  const std::vector<ChosenStep> steps =
      stepsBetween(StepResult::cleaned, StepResult::contracted, options, twice);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps.front().step->name, "contract");
  EXPECT_DOUBLE_EQ(steps.front().method.values[1], 7.5 * twice.spacing);
}

TEST(StepGraph, TakesWhatAStepBeforeMade) {
  StepResult made = StepResult::scan; // by the last step that is not optional: others may be off
  for (const Step& step : pipelineSteps()) {
    EXPECT_EQ(step.takes, made) << step.name;
    EXPECT_GE(step.makes, made) << step.name;
    if (!step.isOptional) made = step.makes;
  }
  EXPECT_EQ(made, StepResult::radii);
}

} // namespace
} // namespace espalier
