// The steps that clean: in the pipeline, and cutting a plot.
#include "core/base/error.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/pipeline/cleaning.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/presets.h"
#include "core/pipeline/region_preview.h"
#include "core/simulate/plot.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <optional>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Plot {
  SimulatedPlot simulated;
  std::shared_ptr<const PointCloud> cloud;

  explicit Plot(std::uint64_t seed, Eigen::Index points = 80'000, int plants = 3,
                double spacing = 1, std::optional<double> noise = {}) {
    PlotOptions options;
    options.plants = plants;
    options.spacing = spacing;
    options.scanner.rangeNoise = noise;
    options.growth.segments = 150;
    options.scanner.points = points;
    simulated = simulatePlot(options, seed);
    cloud = std::make_shared<const PointCloud>(RawPoints(simulated.points));
  }
  [[nodiscard]] const PlotPoint& truth(Eigen::Index point) const {
    return simulated.truth[cloud->fileOrder()[static_cast<std::size_t>(point)]];
  }
};

const Plot& plot() {
  static const Plot made(101);
  return made;
}

const PipelineOptions& plotPreset() {
  return presetNamed("plot")->options;
}

/// Of the wood: the share that is in a plant which stands where its own does. Of the rest: the
/// share that is in none.
std::pair<double, double> sharesRight(const Plot& plot, const CutPlot& cut) {
  double wood = 0;
  double right = 0;
  double rest = 0;
  double kept = 0;
  std::vector<std::uint32_t> plantOf(static_cast<std::size_t>(plot.cloud->size()), 0);
  for (const CutPlant& plant : cut.plants) {
    const auto nearest =
        std::ranges::min_element(plot.simulated.bases, {}, [&](const Eigen::Vector3d& base) {
          return (base - plant.root).norm();
        });
    for (const Eigen::Index point : plant.points)
      plantOf[static_cast<std::size_t>(point)] =
          static_cast<std::uint32_t>(nearest - plot.simulated.bases.begin() + 1);
  }
  for (Eigen::Index i = 0; i < plot.cloud->size(); ++i) {
    const PlotPoint& truth = plot.truth(i);
    const std::uint32_t found = plantOf[static_cast<std::size_t>(i)];
    const bool isWood = truth.part == PlotPart::plant;
    ++(isWood ? wood : rest);
    if (isWood && found == truth.plant) ++right;
    if (!isWood && found != 0) ++kept;
  }
  return {right / wood, 1 - kept / rest};
}

TEST(Cleaning, OfAPlotByOnePresetCutsItIntoItsPlants) {
  const CutPlot cut = cutPlot(plot().cloud, {}, plotPreset());
  EXPECT_EQ(cut.plants.size(), 3U);
  const auto [wood, rest] = sharesRight(plot(), cut);
  EXPECT_GE(wood, 0.99);
  EXPECT_GE(rest, 0.99);
  for (const CutPlant& plant : cut.plants) {
    double nearest = 1e9;
    for (const Eigen::Vector3d& base : plot().simulated.bases)
      nearest = std::min(nearest, (base - plant.root).norm());
    EXPECT_LT(nearest, 0.3) << "at its foot";
  }
}

TEST(Cleaning, OfAPlotWhoseCrownsTouchLeavesBranchesToTheirPlants) {
  const Plot crowded(7, 200'000, 5, 0.7);
  const CutPlot cut = cutPlot(crowded.cloud, {}, plotPreset());
  EXPECT_EQ(cut.plants.size(), 5U);
  const auto [wood, rest] = sharesRight(crowded, cut);
  EXPECT_GE(wood, 0.99);
  EXPECT_GE(rest, 0.99);
  PipelineOptions byLength = plotPreset();
  byLength.set("plant.thinness=0");
  byLength.set("plant.turn=0");
  EXPECT_LT(sharesRight(crowded, cutPlot(crowded.cloud, {}, byLength)).first, 0.99);
}

// Their branches are thicker than a cube of points where they touch, and thinner than the trunks.
TEST(Cleaning, OfAPlotWhoseThickBranchesTouchTakesNoTrunkForABranch) {
  const Plot crowded(9, 100'000, 4, 0.5);
  const CutPlot cut = cutPlot(crowded.cloud, {}, plotPreset());
  EXPECT_EQ(cut.plants.size(), 4U);
  EXPECT_GE(sharesRight(crowded, cut).first, 0.95);
}

TEST(Cleaning, OfAPlotThatScattersWideLeavesOutItsGround) {
  const Plot noisy(7, 200'000, 3, 1, 0.02);
  const CutPlot cut = cutPlot(noisy.cloud, {}, plotPreset());
  EXPECT_EQ(cut.plants.size(), 3U);
  const auto [wood, rest] = sharesRight(noisy, cut);
  EXPECT_GE(wood, 0.98);
  EXPECT_GE(rest, 0.99);
  PipelineOptions asIfExact = plotPreset();
  asIfExact.set("ground.noise=0");
  asIfExact.set("plant.noise=0");
  EXPECT_LT(sharesRight(noisy, cutPlot(noisy.cloud, {}, asIfExact)).second, 0.96)
      << "the cloth lies on the lowest points";
}

// By hand it is easily asked for twice. A cloth then touches branches, and they would be gone.
TEST(Cleaning, FindsNoGroundAboveTheGroundThatWasSetAside) {
  const PointCloud& cloud = *plot().cloud;
  const ChosenMethod cloth =
      chosenFor(stepNamed("ground"), plotPreset(), scaleOf(cloud, {}, UpAxis::z));
  const auto groundWithout = [&](const PointSet& leftOut) {
    return leftOutBy(*cloth.method, cloth.values, plot().cloud, {.leftOut = leftOut});
  };
  const PointSet ground = groundWithout({}).value;
  ASSERT_GT(ground.size(), 10'000U);
  const Imported<PointSet> again = groundWithout(ground);
  EXPECT_TRUE(again.value.isEmpty());
  ASSERT_EQ(again.notes.size(), 1U);
  EXPECT_EQ(inEnglish(again.notes.front()), "the ground was set aside before");

  std::vector<Eigen::Index> some; // as strays that were set aside first, anywhere
  for (Eigen::Index i = 0; i < cloud.size(); i += 50)
    some.push_back(i);
  const PointSet strays = PointSet::of(some);
  EXPECT_GT(groundWithout(strays).value.size(), 95 * ground.size() / 100);
}

TEST(Cleaning, KeepsThePlantAtTheRootThatWasChosen) {
  Pipeline pipeline;
  for (std::size_t i = 0; i < 3; ++i) {
    PipelineOptions options = plotPreset();
    options.root = plot().simulated.bases[i];
    const Reconstruction result = pipeline.run(plot().cloud, options, {}, "clean");
    ASSERT_TRUE(result.apart);
    double own = 0;
    double others = 0;
    for (Eigen::Index k = 0; k < plot().cloud->size(); ++k)
      if (plot().truth(k).part == PlotPart::plant && !result.apart->contains(k))
        ++(plot().truth(k).plant == i + 1 ? own : others);
    EXPECT_GT(own, 100 * others) << i;
  }
}

TEST(Cleaning, GivesRulesBehindItTheScaleOfWhatIsLeft) {
  const Reconstruction result = Pipeline().run(plot().cloud, plotPreset(), {}, "clean");
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < plot().cloud->size(); ++i)
    if (!result.apart->contains(i)) kept.push_back(i);
  const PlantScale left = scaleOf(*someOf(*plot().cloud, kept), {}, UpAxis::z);
  EXPECT_EQ(result.scale.spacing, left.spacing);
  EXPECT_EQ(result.scale.height, left.height);
  const PlantScale whole = scaleOf(*plot().cloud, {}, UpAxis::z);
  EXPECT_EQ(result.steps.front().scale.height, whole.height);
  EXPECT_NE(result.scale.height, whole.height);
  const Reconstruction thin = [] {
    PipelineOptions options;
    options.set("thin.method=spacing");
    options.set("thin.spacing=5 spacings");
    return Pipeline().run(plot().cloud, options, {}, "clean");
  }();
  EXPECT_GE(thin.scale.spacing, 5 * whole.spacing);
}

TEST(Cleaning, RunsOnlyWhatIsOn) {
  const auto namesOf = [](const Reconstruction& result) {
    std::vector<std::string> names;
    for (const StepRecord& step : result.steps)
      names.push_back(step.step);
    return names;
  };
  const auto fork = test::cloudAtOrigin(test::forkCloud());
  EXPECT_THAT(namesOf(Pipeline().run(fork, {}, {}, "contract")),
              ElementsAre("thin", "clean", "contract"));
  PipelineOptions options;
  options.set("crop.method=distance");
  EXPECT_THAT(namesOf(Pipeline().run(fork, options, {}, "contract")),
              ElementsAre("crop", "thin", "clean", "contract"));
  EXPECT_THAT(namesOf(Pipeline().run(fork, {}, {}, "crop")), ElementsAre("crop"));
}

TEST(Cleaning, IsComputedAgainForAnotherUpAxisOrRoot) {
  const auto fork = test::cloudAtOrigin(test::forkCloud());
  Pipeline pipeline;
  PipelineOptions options;
  options.set("crop.method=distance");
  options.set("crop.distance=0.2");
  options.root = Eigen::Vector3d(0, 0, 0);
  const auto left = [&] { return pipeline.run(fork, options, {}, "clean").apart->size(); };
  const std::size_t atFoot = left();
  options.root = Eigen::Vector3d(0.8, 0, 3.2);
  EXPECT_NE(left(), atFoot);
  options.root = Eigen::Vector3d(0, 0, 0);
  EXPECT_EQ(left(), atFoot);
  options.up = UpAxis::x;
  EXPECT_NE(left(), atFoot);
}

TEST(Cleaning, OfARegionIsThatOfTheWhole) {
  const PlantScale scale = scaleOf(*plot().cloud, {}, UpAxis::z);
  PipelineOptions options = plotPreset();
  options.root = plot().simulated.bases[0];
  const Reconstruction whole = Pipeline().run(plot().cloud, options, {}, "contract");
  const RegionPreviewer previewer(plot().cloud, {}, scale, UpAxis::z, options.root);
  const Ball ball{*options.root + Eigen::Vector3d(0, 0, 1), 0.4};
  const RegionPreview region = previewer.contracted(ball, options);
  std::size_t near = 0;
  for (std::size_t i = 0; i < region.points.size(); ++i)
    if ((region.contracted.col(static_cast<Eigen::Index>(i)) -
         whole.contracted->col(region.points[i]))
            .norm() < 1e-4F)
      ++near;
  EXPECT_GT(region.points.size(), 50U);
  EXPECT_GT(near, region.points.size() * 98 / 100);
}

TEST(Cleaning, SaysWhatEachStepLeftOut) {
  const CleanedScan cleaned = cleanedScan(plot().cloud, plotPreset());
  Eigen::Index sum = 0;
  for (const CleaningRecord& record : cleaned.steps)
    sum += record.leftOut;
  EXPECT_EQ(sum, static_cast<Eigen::Index>(cleaned.leftOut.size())) << "no place is there twice";
  const auto poles = std::ranges::find(
      cleaned.steps, "poles", [](const CleaningRecord& record) { return record.step->name; });
  ASSERT_NE(poles, cleaned.steps.end());
  EXPECT_THAT(eachInEnglish(poles->notes), ElementsAre("1 pole left out"));
}

TEST(Cleaning, ReportsWhatCannotBeDone) {
  const auto fork = test::cloudAtOrigin(test::forkCloud());
  PipelineOptions all;
  all.set("crop.method=slab");
  all.set("crop.from=100 heights");
  all.set("crop.to=101 heights");
  for (const auto& work : std::vector<std::function<void()>>{
           [&] { (void)Pipeline().run(fork, all); }, [&] { (void)cleanedScan(fork, all); }}) {
    try {
      work();
      FAIL() << "nothing is left";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("fewer than 2 points are left"));
    }
  }
  PipelineOptions high;
  high.set("plant.slab_from=100 heights");
  high.set("plant.slab_to=101 heights");
  high.methods["plant"] = "geodesic";
  try {
    (void)cutPlot(fork, {}, high);
    FAIL() << "no stem";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no stem is found"));
  }
}

TEST(Cleaning, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked(
      [](const Progress& progress) { (void)cutPlot(plot().cloud, {}, plotPreset(), progress); }));
}

} // namespace
} // namespace espalier
