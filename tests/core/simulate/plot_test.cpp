#include "core/base/error.h"
#include "core/simulate/plot.h"
#include "core/skeleton/assign_points.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <map>

namespace espalier {
namespace {

PlotOptions smallPlot() {
  PlotOptions options;
  options.growth.segments = 40;
  options.scanner.points = 20'000;
  return options;
}

TEST(Plot, HasAsManyPointsOfEachPartAsAskedFor) {
  const SimulatedPlot plot = simulatePlot(smallPlot(), 3);
  std::map<PlotPart, double> counts;
  for (const PlotPoint& point : plot.truth)
    ++counts[point.part];
  ASSERT_EQ(plot.truth.size(), plot.points.positions.size());
  EXPECT_NEAR(counts[PlotPart::ground], 8000, 400);
  EXPECT_NEAR(static_cast<double>(plot.truth.size()), 20'000, 3000);
  EXPECT_GT(counts[PlotPart::pole], 50);
  EXPECT_GT(counts[PlotPart::wire], 10);
  EXPECT_NEAR(counts[PlotPart::stray], 12, 4);
  EXPECT_EQ(plot.bases.size(), 3U);
}

TEST(Plot, KnowsWhoseWoodEachPointLiesOn) {
  PlotOptions options = smallPlot();
  options.slope = 0.4;
  const SimulatedPlot plot = simulatePlot(options, 4);
  for (std::uint32_t plant = 1; plant <= 3; ++plant) {
    std::vector<Eigen::Vector3d> own;
    for (std::size_t i = 0; i < plot.truth.size(); ++i)
      if (plot.truth[i] == PlotPoint{PlotPart::plant, plant})
        own.push_back(plot.points.positions[i]);
    ASSERT_GT(own.size(), 500U);
    Eigen::Matrix3Xf points(3, std::ssize(own));
    for (std::size_t i = 0; i < own.size(); ++i)
      points.col(static_cast<Eigen::Index>(i)) = own[i].cast<float>();
    std::size_t near = 0;
    const Skeleton& skeleton = plot.plants[plant - 1];
    EXPECT_EQ(skeleton[skeleton.roots().front()].position, plot.bases[plant - 1]);
    for (const PointOnSkeleton& place : assignPoints(points, Eigen::Vector3d::Zero(), skeleton, {}))
      if (place.distance < 0.1) ++near;
    EXPECT_GT(near, own.size() * 99 / 100);
  }
}

TEST(Plot, IsTheSameForASeedAndAnotherForAnother) {
  const SimulatedPlot one = simulatePlot(smallPlot(), 5);
  EXPECT_EQ(simulatePlot(smallPlot(), 5).points.positions, one.points.positions);
  EXPECT_NE(simulatePlot(smallPlot(), 6).points.positions, one.points.positions);
}

TEST(Plot, RefusesWhatIsOutOfRange) {
  for (const auto& spoil : std::vector<std::function<void(PlotOptions&)>>{
           [](PlotOptions& options) { options.plants = 0; },
           [](PlotOptions& options) { options.slope = 2; },
           [](PlotOptions& options) { options.groundShare = 1; },
           [](PlotOptions& options) { options.spacing = 0; },
           [](PlotOptions& options) { options.wireRadius = 0; },
           [](PlotOptions& options) { options.poles = -1; }}) {
    PlotOptions options = smallPlot();
    spoil(options);
    EXPECT_THROW((void)simulatePlot(options, 1), Error);
  }
}

TEST(Plot, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked(
      [](const Progress& progress) { (void)simulatePlot(smallPlot(), 1, progress); }));
}

} // namespace
} // namespace espalier
