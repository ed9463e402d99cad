// The step that smooths, in the pipeline: what comes behind it starts from where it leaves points.
#include "core/pipeline/method_sight.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/region_preview.h"
#include "core/pipeline/used_densities.h"
#include "tests/support/cloud_of.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

/// A trunk of radius 1 whose points scatter by 0.05, and are as far apart.
Eigen::Matrix3Xf roughTrunk() {
  Eigen::Matrix3Xf points(3, 0);
  for (const double radius : {0.95, 1.0, 1.05})
    points = test::both(points, test::cylinder({0, 0, 0}, {0, 0, 4}, radius, 0.09,
                                               static_cast<std::uint64_t>(100 * radius)));
  return points;
}

struct SmoothingInThePipeline : testing::Test {
  std::shared_ptr<const PointCloud> cloud = test::cloudOf(roughTrunk(), {0, 0, 0});
  PipelineOptions options;
  Pipeline pipeline;

  SmoothingInThePipeline() {
    options.set("smooth.method=spheres");
    options.set("smooth.radius=0.4");
    options.set("thin.method=none");
  }
  void smoothNothing() {
    options.methods["smooth"] = "none";
    options.settings.erase("smooth");
  }
  /// Mean distance of places from the trunk, without its ends.
  [[nodiscard]] double roughness(const Eigen::Matrix3Xf& places) const {
    double sum = 0;
    int count = 0;
    for (Eigen::Index i = 0; i < places.cols(); ++i) {
      const Eigen::Vector3d place = places.col(i).cast<double>() + cloud->origin();
      if (place.z() < 0.5 || place.z() > 3.5) continue;
      sum += std::abs(place.head<2>().norm() - 1);
      ++count;
    }
    return sum / count;
  }
};

TEST_F(SmoothingInThePipeline, IsOffUnlessItIsChosen) {
  const Reconstruction result = pipeline.run(cloud, {}, {}, "contract");
  for (const StepRecord& step : result.steps)
    EXPECT_NE(step.step, "smooth");
  smoothNothing();
  options.methods["contract"] = "none";
  EXPECT_EQ(*pipeline.run(cloud, options, {}, "contract").contracted, cloud->positions());
}

TEST_F(SmoothingInThePipeline, BringsPointsToTheTrunk) {
  const Reconstruction result = pipeline.run(cloud, options, {}, "smooth");
  EXPECT_GT(roughness(cloud->positions()), 0.03);
  EXPECT_LT(roughness(*result.contracted), 0.015);
}

TEST_F(SmoothingInThePipeline, IsWhereTheContractionStarts) {
  const Eigen::Matrix3Xf smooth = *pipeline.run(cloud, options, {}, "smooth").contracted;
  options.methods["contract"] = "none";
  EXPECT_EQ(*pipeline.run(cloud, options, {}, "contract").contracted, smooth);
  options.methods["contract"] = "one_step_laplacian";
  const Eigen::Matrix3Xf contracted = *pipeline.run(cloud, options, {}, "contract").contracted;
  EXPECT_LT(roughness(contracted), 0.03);
  smoothNothing();
  EXPECT_NE(*pipeline.run(cloud, options, {}, "contract").contracted, contracted);
}

TEST_F(SmoothingInThePipeline, IsComputedAgainWhereItsOptionsChange) {
  (void)pipeline.run(cloud, options, {}, "contract");
  options.set("smooth.radius=0.3");
  std::vector<std::string> names;
  for (const StepRecord& step : pipeline.run(cloud, options, {}, "contract").steps)
    if (step.isNew) names.push_back(step.step);
  EXPECT_EQ(names, (std::vector<std::string>{"smooth", "contract"}));
}

TEST_F(SmoothingInThePipeline, IsTheSameInThePreviewOfARegion) {
  for (const char* contraction : {"none", "euclidean_ball", "adaptive_geodesic"}) {
    options.methods["contract"] = contraction;
    const Reconstruction whole = pipeline.run(cloud, options, {}, "contract");
    const RegionPreviewer previewer(cloud, {}, whole.scale);
    const RegionPreview part = previewer.contracted({{1, 0, 2}, 0.3}, options);
    ASSERT_GT(part.points.size(), 50U);
    for (std::size_t i = 0; i < part.points.size(); ++i)
      EXPECT_LT((part.contracted.col(static_cast<Eigen::Index>(i)) -
                 whole.contracted->col(part.points[i]))
                    .norm(),
                1e-4F)
          << contraction;
  }
}

// The mean of what is shown is the place that a point was moved to, where smoothing left those.
TEST_F(SmoothingInThePipeline, IsWhatTheMethodSees) {
  const Eigen::Matrix3Xf smooth = *pipeline.run(cloud, options, {}, "smooth").contracted;
  options.methods["contract"] = "euclidean_ball";
  const Reconstruction whole = pipeline.run(cloud, options, {}, "contract");
  const MethodSights sights(cloud, whole.contracted, options, whole.scale);
  for (Eigen::Index point = 0; point < cloud->size(); point += 211) {
    const MethodSight sight = sights.at(point);
    ASSERT_FALSE(sight.ball.empty());
    const Eigen::Vector3f mean = smooth(Eigen::all, sight.ball).rowwise().mean();
    EXPECT_LT((mean - whole.contracted->col(point)).norm(), 1e-4F);
  }
}

TEST_F(SmoothingInThePipeline, CountsForTheDensitiesThatAContractionFollows) {
  options.methods["contract"] = "adaptive_geodesic";
  const PlantScale scale = pipeline.run(cloud, options, {}, "smooth").scale;
  const auto smooth = densitiesUsed(cloud, options, scale);
  smoothNothing();
  const auto scanned = densitiesUsed(cloud, options, scale);
  ASSERT_TRUE(smooth && scanned);
  EXPECT_NE(*smooth, *scanned);
}

} // namespace
} // namespace espalier
