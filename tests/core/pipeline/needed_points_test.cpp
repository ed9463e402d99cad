// The method "as_needed" of the step Thin.
#include "core/pipeline/needed_points.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/pipeline_start.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"
#include "tests/support/leafy_plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <memory>

namespace espalier {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::size_t tipsOf(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids();
  return static_cast<std::size_t>(
      std::ranges::count_if(ids, [&](NodeId id) { return skeleton.children(id).empty(); }));
}

/// A stem with a few leaves much wider than its points are apart, of a seed that nothing was fitted
/// on; made once.
const std::shared_ptr<const PointCloud>& denseGrass() {
  static const auto cloud = [] {
    Foliage foliage{
        .blades = {.spacing = 0.2, .length = 0.5, .width = 0.06, .angle = 0.6, .reach = 10}};
    foliage.droop = 1;
    const Skeleton plant = growPlant(
        {.architecture = Architecture::herb, .height = 4, .segments = 1, .baseRadius = 0.05},
        90'021);
    return std::make_shared<const PointCloud>(test::labeledScanOf(plant, foliage, 100'000).cloud);
  }();
  return cloud;
}

/// A conifer in needles of many points each, of a seed that nothing was fitted on.
struct DenseConifer {
  Skeleton plant;
  std::shared_ptr<const PointCloud> cloud;
};

/// @param noise [L], of ranges
DenseConifer denseConifer(std::uint64_t seed, int segments, double noise) {
  DenseConifer made{
      growPlant({.architecture = Architecture::conifer, .height = 4, .segments = segments}, seed),
      nullptr};
  ScannerOptions scanner{.points = 5000 * segments, .stations = 2};
  scanner.rangeNoise = noise;
  scanner.foliage = foliageOf(Architecture::conifer, 1.4);
  made.cloud = std::make_shared<const PointCloud>(scan(made.plant, scanner, seed).points);
  return made;
}

PipelineOptions withoutThinning() {
  PipelineOptions options;
  options.set("thin.method=none");
  return options;
}

/// Ends are removed by their length alone, so that what they are of makes no difference.
PipelineOptions prunedByLength(PipelineOptions options) {
  options.set("prune.method=spurs");
  return options;
}

TEST(NeededPoints, FindWideLeavesAsOneAxisEach) {
  const Reconstruction all = Pipeline().run(denseGrass(), prunedByLength(withoutThinning()));
  const Reconstruction some = Pipeline().run(denseGrass(), prunedByLength({}));
  ASSERT_EQ(some.steps.front().step, "thin");
  EXPECT_GT(some.steps.front().leftOut, denseGrass()->size() / 2);
  EXPECT_THAT(inEnglish(some.steps.front().notes.at(0)), HasSubstr("points are used"));
  EXPECT_GT(tipsOf(*all.skeleton), 15U);
  EXPECT_LE(tipsOf(*some.skeleton), 9U);
  EXPECT_GE(tipsOf(*some.skeleton), 4U);
}

TEST(NeededPoints, DoNotMakeTwigsOfNeedles) {
  const DenseConifer conifer = denseConifer(90'022, 60, 0);
  const Reconstruction all = Pipeline().run(conifer.cloud, withoutThinning());
  const Reconstruction some = Pipeline().run(conifer.cloud);
  const std::size_t tips = tipsOf(conifer.plant);
  EXPECT_GT(tipsOf(*all.skeleton), 3 * tips);
  EXPECT_LT(tipsOf(*some.skeleton), 3 * tips / 2);
  EXPECT_GT(tipsOf(*some.skeleton), tips / 2);
}

TEST(NeededPoints, AreEnoughForThePlantWhereItsThicknessCannotBeMeasured) {
  const DenseConifer conifer = denseConifer(90'023, 24, 0.02);
  const Reconstruction found = Pipeline().run(conifer.cloud);
  EXPECT_GT(tipsOf(*found.skeleton), tipsOf(conifer.plant) / 4);
}

TEST(NeededPoints, AreAllWhereTheWoodIsThin) {
  const auto fork = test::cloudAtOrigin(test::forkCloud());
  const Reconstruction result = Pipeline().run(fork);
  EXPECT_EQ(result.steps.front().leftOut, 0);
  EXPECT_THAT(result.steps.front().notes, IsEmpty());
  EXPECT_EQ(*result.skeleton, *Pipeline().run(fork, withoutThinning()).skeleton);
}

TEST(NeededPoints, AreTheSameWhereverThePlantStands) {
  RawPoints moved;
  for (Eigen::Index i = 0; i < denseGrass()->size(); ++i)
    moved.positions.push_back(denseGrass()->position(i) + Eigen::Vector3d(64, -32, 8));
  const auto elsewhere = std::make_shared<const PointCloud>(std::move(moved));
  const auto countOf = [](const std::shared_ptr<const PointCloud>& cloud) {
    return static_cast<double>(Pipeline().run(cloud, prunedByLength({}), {}, "thin").apart->size());
  };
  EXPECT_NEAR(countOf(elsewhere) / countOf(denseGrass()), 1, 0.01);
}

TEST(NeededPoints, AreNotAskedForByPartsOfAScan) {
  const PipelineOptions ofPart = withScanCleaned(denseGrass(), {}, {});
  EXPECT_TRUE(ofPart.leftOut.isEmpty());
  EXPECT_EQ(ofPart.methods.at("thin"), "none");
}

} // namespace
} // namespace espalier
