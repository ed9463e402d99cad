#include "core/base/random.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/pipeline/cleaning.h"
#include "core/pipeline/organs_of_scan.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/leafy_plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <memory>

namespace espalier {
namespace {

using testing::HasSubstr;

PipelineOptions withoutLeaves(const char* which) {
  PipelineOptions options;
  options.set("leaves.method=shapes");
  options.set(std::string("leaves.leave_out=") + which);
  return options;
}

/// Share of the points of an organ that the step leaves out.
double shareLeftOut(const test::LabeledCloud& scan, const CleanedScan& cleaned, Organ organ) {
  double all = 0, out = 0;
  for (std::size_t i = 0; i < scan.organs.size(); ++i)
    if (scan.organs[i] == organ) {
      ++all;
      out += cleaned.leftOut.contains(static_cast<Eigen::Index>(i));
    }
  return out / all;
}

TEST(LeavesStep, LeavesOutBladesAndKeepsStems) {
  const test::LabeledCloud& herb = test::leafyHerb();
  const auto cloud = std::make_shared<const PointCloud>(herb.cloud);
  const CleanedScan without = cleanedScan(cloud, withoutLeaves("foliage"));
  EXPECT_GT(shareLeftOut(herb, without, Organ::blade), 0.9);
  EXPECT_LT(shareLeftOut(herb, without, Organ::wood), 0.1);
  const CleanedScan needles = cleanedScan(cloud, withoutLeaves("needles"));
  EXPECT_LT(shareLeftOut(herb, needles, Organ::blade), 0.1);
}

/// As the panel that cleans asks for it.
TEST(LeavesStep, FindsTheSameByItself) {
  const auto cloud = std::make_shared<const PointCloud>(test::leafyHerb().cloud);
  const Step& step = stepNamed("leaves");
  const PointSet found = leftOutBy(methodNamed(step, "shapes"), {0}, cloud, {}).value;
  PipelineOptions alone = withoutLeaves("foliage");
  alone.set("clean.method=none");
  EXPECT_EQ(found, cleanedScan(cloud, alone).leftOut);
  EXPECT_GT(found.size(), 1000U);
}

// Half of the stem is of blades and the lower blades are of wood, as a hand says.
TEST(LeavesStep, TakesOrgansThatWereSetByHand) {
  const test::LabeledCloud& herb = test::leafyHerb();
  const auto cloud = std::make_shared<const PointCloud>(herb.cloud);
  PipelineOptions options = withoutLeaves("foliage");
  options.set("clean.method=none");
  const PointSet before = cleanedScan(cloud, options).leftOut;
  const PointSet in = PointSet::of(others(before, cloud->size()));
  const PointSet some = PointSet::of({before.points()[5], before.points()[900]});
  const PointSet stem = PointSet::of({in.points()[3], in.points()[400]});
  options.organs = OrganMarks()
                       .with(some, Organ::wood)
                       .with(stem, Organ::blade)
                       .with(PointSet::of({cloud->size() + 7}), Organ::blade); // of no point
  const CleanedScan by = cleanedScan(cloud, options);
  EXPECT_EQ(by.leftOut, (before - some) | stem);
  EXPECT_THAT(eachInEnglish(by.steps.front().notes),
              testing::Contains(HasSubstr("4 were set by hand")));
}

TEST(LeavesStep, RunsAgainWhereOrgansAreSetByHand) {
  const auto cloud = std::make_shared<const PointCloud>(test::leafyHerb().cloud);
  PipelineOptions options = withoutLeaves("foliage");
  Pipeline pipeline;
  const Reconstruction first = pipeline.run(cloud, options, {}, "clean");
  options.organs = OrganMarks().with(PointSet::firstOf(500), Organ::blade);
  const Reconstruction second = pipeline.run(cloud, options, {}, "clean");
  EXPECT_NE(*first.apart, *second.apart);
  EXPECT_TRUE((PointSet::firstOf(500) - *second.apart).isEmpty());
  options.organs = {};
  EXPECT_EQ(*pipeline.run(cloud, options, {}, "clean").apart, *first.apart);
}

TEST(OrgansOfScan, AreWhatTheStepLeavesOut) {
  const auto cloud = std::make_shared<const PointCloud>(test::leafyHerb().cloud);
  PipelineOptions options = withoutLeaves("all");
  options.set("clean.method=none");
  options.leftOut = PointSet::firstOf(200);
  options.organs = OrganMarks().with(PointSet::of({300, 301}), Organ::needle);
  const auto organs = organsOfScan(cloud, options);
  std::vector<Eigen::Index> notWood;
  for (Eigen::Index i = 0; i < cloud->size(); ++i) {
    const std::optional<Organ>& organ = organs[static_cast<std::size_t>(i)];
    ASSERT_EQ(organ.has_value(), i >= 200);
    if (organ != Organ::wood) notWood.push_back(i);
  }
  EXPECT_EQ(organs[300], Organ::needle);
  EXPECT_EQ(PointSet::of(notWood), cleanedScan(cloud, options).leftOut);
}

TEST(OrgansOfScan, AreNotKnownOfPointsAtOnePlace) {
  RawPoints raw;
  raw.positions.assign(50, Eigen::Vector3d(1, 2, 3));
  const auto cloud = std::make_shared<const PointCloud>(std::move(raw));
  for (const std::optional<Organ>& organ : organsOfScan(cloud))
    EXPECT_FALSE(organ);
}

TEST(OrgansOfScan, AreStoppedAndRefuseUnknownOptions) {
  const auto cloud = std::make_shared<const PointCloud>(test::leafyHerb().cloud);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)organsOfScan(cloud, {}, Progress(stop.get_token(), {})), Cancelled);
  PipelineOptions unknown;
  unknown.methods["leaves"] = "guesses";
  EXPECT_THROW((void)organsOfScan(cloud, unknown), Error);
}

TEST(LeavesStep, IsOffByDefault) {
  const auto cloud = std::make_shared<const PointCloud>(test::leafyHerb().cloud);
  for (const CleaningRecord& record : cleanedScan(cloud, {}).steps)
    EXPECT_NE(record.step->name, "leaves");
}

TEST(LeavesStep, GivesTheSkeletonItsRootOnWood) {
  const auto cloud = std::make_shared<const PointCloud>(test::hangingLeaf());
  const Reconstruction result = Pipeline().run(cloud, withoutLeaves("foliage"));
  const std::vector<NodeId> ids = result.skeleton->ids();
  ASSERT_FALSE(ids.empty());
  const Eigen::Vector3d root = (*result.skeleton)[ids.front()].position;
  EXPECT_LT(root.head<2>().norm(), 0.03) << root.transpose();
  EXPECT_LT(root.z(), 0.1);
  EXPECT_GT(root.z(), -0.05);
}

TEST(BladesStep, GivesALeafItsMidline) {
  const auto cloud = std::make_shared<const PointCloud>(test::hangingLeaf());
  const Eigen::Vector3d tip(0.31, 0, -0.1);
  const auto nearestEnd = [&](const PipelineOptions& options) {
    const Reconstruction result = Pipeline().run(cloud, options);
    double nearest = 1;
    for (const NodeId id : result.skeleton->ids())
      nearest = std::min(nearest, ((*result.skeleton)[id].position - tip).norm());
    return nearest;
  };
  PipelineOptions options = withoutLeaves("foliage");
  EXPECT_GT(nearestEnd(options), 0.2);
  options.set("blades.method=midlines");
  EXPECT_LT(nearestEnd(options), 0.1) << "half of the width of the blade";
}

TEST(BladesStep, SaysThatItNeedsLeaves) {
  const auto cloud = std::make_shared<const PointCloud>(test::hangingLeaf());
  PipelineOptions options;
  options.set("blades.method=midlines");
  EXPECT_THAT(notesOf(Pipeline().run(cloud, options)), testing::Contains(HasSubstr("step Leaves")));
}

TEST(LeavesStep, KeepsAllWhereItFindsNoWood) {
  Random random(6);
  RawPoints sheet; // one blade and nothing else
  for (int i = 0; i < 4000; ++i)
    sheet.positions.emplace_back(random.uniform(), random.uniform(), 0);
  const auto cloud = std::make_shared<const PointCloud>(std::move(sheet));
  const CleanedScan cleaned = cleanedScan(cloud, withoutLeaves("all"));
  EXPECT_THAT(eachInEnglish(cleaned.steps.front().notes),
              testing::Contains(HasSubstr("nothing is left out")));
  EXPECT_EQ(cleaned.steps.front().leftOut, 0);
}

} // namespace
} // namespace espalier
