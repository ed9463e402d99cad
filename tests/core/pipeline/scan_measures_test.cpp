#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/pipeline/scan_measures.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

struct ScannedPole {
  double radius = 3;
  double arc = 2 * std::numbers::pi;
  double noise = 0.2;
  double density = 1; // points per unit of its surface
  double from = 0;    // along z
  double to = 500;
  double gapFrom = 0; // where points are missing
  double gapTo = 0;
};

void scan(const ScannedPole& pole, RawPoints& raw) {
  Random random(1);
  const double area = pole.arc * pole.radius * (pole.to - pole.from);
  for (int i = 0; i < static_cast<int>(area * pole.density); ++i) {
    const double at = pole.arc * random.uniform();
    const double r = pole.radius + pole.noise * random.normal();
    const double z = pole.from + (pole.to - pole.from) * random.uniform();
    if (z > pole.gapFrom && z < pole.gapTo) continue;
    raw.positions.emplace_back(100 + r * std::cos(at), r * std::sin(at), z);
  }
}

ScanMeasures measuresOf(const ScannedPole& pole) {
  RawPoints raw;
  scan(pole, raw);
  return scanMeasures(PointCloud(std::move(raw)), {}, UpAxis::z);
}

// Points strewn by chance, one per unit of surface, are half a unit from the nearest (in the mean:
// 1 / (2 sqrt(density))); a tenth is nearer than 0.18, another farther than 0.86.
TEST(ScanMeasures, SaysHowFarPointsAreApart) {
  const ScanMeasures measures = measuresOf({.noise = 0});
  ASSERT_TRUE(measures.whole.spacing);
  EXPECT_NEAR(measures.spacing, 0.5, 0.03);
  EXPECT_NEAR(measures.whole.spacing->low, std::sqrt(-std::log(0.9) / std::numbers::pi), 0.03);
  EXPECT_NEAR(measures.whole.spacing->median, std::sqrt(std::log(2) / std::numbers::pi), 0.03);
  EXPECT_NEAR(measures.whole.spacing->high, std::sqrt(-std::log(0.1) / std::numbers::pi), 0.04);
}

TEST(ScanMeasures, SaysWhatTheWoodIsLike) {
  const ScanMeasures measures = measuresOf({});
  ASSERT_TRUE(measures.whole.scatter && measures.whole.thickness && measures.whole.arc);
  EXPECT_NEAR(*measures.whole.scatter, 0.2, 0.04);
  EXPECT_NEAR(measures.whole.thickness->median, 6, 0.4);
  EXPECT_GT(measures.whole.measured, 0.9);
  EXPECT_NEAR(*measures.whole.arc, 2 * std::numbers::pi, 1e-9);
  EXPECT_TRUE(measures.whole.gaps.empty());
}

TEST(ScanMeasures, DoesNotSayHowThickATrunkIs) {
  const ScanMeasures measures = measuresOf({.radius = 12});
  EXPECT_FALSE(measures.whole.thickness);
  EXPECT_LT(measures.whole.measured, 0.2);
  ASSERT_TRUE(measures.whole.scatter);
  EXPECT_NEAR(*measures.whole.scatter, 0.2, 0.04);
}

TEST(ScanMeasures, SeesOneSideOfTheWood) {
  const ScanMeasures measures = measuresOf({.arc = std::numbers::pi});
  ASSERT_TRUE(measures.whole.arc);
  EXPECT_NEAR(*measures.whole.arc, std::numbers::pi, std::numbers::pi / 8);
}

TEST(ScanMeasures, SaysWhereAGapIs) {
  const ScanMeasures measures = measuresOf({.gapFrom = 320, .gapTo = 350});
  ASSERT_EQ(measures.whole.gaps.size(), 1U);
  EXPECT_NEAR(measures.whole.gaps.front(), 30, 3 * measures.spacing);
  ASSERT_EQ(measures.slabs.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) // 320 to 350 is in the fourth of five slabs of 100
    EXPECT_EQ(measures.slabs[i].measures.gaps.size(), i == 3 ? 1U : 0U) << i;
}

TEST(ScanMeasures, SaysTheSameByHeight) {
  RawPoints raw; // thick and dense below, thin, wide apart and noisy above
  scan({.radius = 3, .noise = 0.05, .density = 2, .from = 1000, .to = 1100}, raw);
  scan({.radius = 1.5, .noise = 0.25, .density = 0.5, .from = 1100, .to = 1500}, raw);
  const Eigen::Index below = std::ranges::count_if(
      raw.positions, [](const Eigen::Vector3d& place) { return place.z() < 1100; });
  const auto all = std::ssize(raw.positions);
  const ScanMeasures measures = scanMeasures(PointCloud(std::move(raw)), {}, UpAxis::z);
  ASSERT_EQ(measures.slabs.size(), 5U);
  const WoodMeasures& foot = measures.slabs.front().measures;
  const WoodMeasures& top = measures.slabs.back().measures;
  EXPECT_NEAR(measures.slabs.front().from, 1000, 0.5);
  EXPECT_NEAR(measures.slabs.front().to, 1100, 0.5);
  EXPECT_NEAR(measures.slabs.back().to, 1500, 0.5);
  EXPECT_NEAR(static_cast<double>(foot.points), static_cast<double>(below), 100);
  Eigen::Index sum = 0;
  for (const MeasuredSlab& slab : measures.slabs)
    sum += slab.measures.points;
  EXPECT_EQ(sum, all);
  ASSERT_TRUE(foot.spacing && top.spacing && foot.scatter && top.scatter && foot.thickness &&
              top.thickness);
  EXPECT_NEAR(top.spacing->median / foot.spacing->median, 2, 0.5);
  EXPECT_NEAR(*foot.scatter, 0.05, 0.02);
  EXPECT_NEAR(*top.scatter, 0.25, 0.06);
  EXPECT_NEAR(foot.thickness->median, 6, 0.5);
  EXPECT_NEAR(top.thickness->median, 3, 0.4);
}

TEST(ScanMeasures, FollowsTheAxisThatPointsUp) {
  RawPoints raw;
  scan({.gapFrom = 320, .gapTo = 350}, raw);
  for (Eigen::Vector3d& place : raw.positions)
    place = Eigen::Vector3d(place.z(), place.x(), place.y());
  const ScanMeasures measures = scanMeasures(PointCloud(std::move(raw)), {}, UpAxis::x);
  ASSERT_EQ(measures.slabs.size(), 5U);
  EXPECT_EQ(measures.slabs[3].measures.gaps.size(), 1U);
  EXPECT_NEAR(measures.slabs[3].from, 300, 1);
}

/// A plant whose leaves are known.
SimulatedScan herb(double leaves) {
  const Skeleton plant =
      growPlant({.architecture = Architecture::herb, .height = 1, .segments = 20}, 3);
  ScannerOptions options;
  options.points = 20'000;
  if (leaves > 0)
    options.foliage.blades = {.spacing = 0.06 / leaves, .length = 0.2, .width = 0.1, .reach = 10};
  return espalier::scan(plant, options, 3);
}

TEST(ScanMeasures, SaysWhichShareIsFoliage) {
  const ScanMeasures bare = scanMeasures(PointCloud(herb(0).points), {}, UpAxis::z);
  ASSERT_TRUE(bare.whole.foliage);
  EXPECT_LT(*bare.whole.foliage, 0.05);
  SimulatedScan leafy = herb(1);
  const double truth = static_cast<double>(std::ranges::count(leafy.organs, Organ::blade)) /
                       static_cast<double>(leafy.organs.size());
  ASSERT_GT(truth, 0.3);
  const ScanMeasures measures = scanMeasures(PointCloud(leafy.points), {}, UpAxis::z);
  ASSERT_TRUE(measures.whole.foliage);
  EXPECT_NEAR(*measures.whole.foliage, truth, 0.15);
}

TEST(ScanMeasures, PassesOverWhatIsSetAside) {
  RawPoints raw;
  scan({}, raw);
  const auto kept = std::ssize(raw.positions);
  scan({.radius = 20, .from = 600, .to = 700}, raw);
  const PointCloud cloud(std::move(raw));
  std::vector<Eigen::Index> above;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    if (cloud.position(i).z() > 550) above.push_back(i);
  const ScanMeasures measures = scanMeasures(cloud, PointSet::of(above), UpAxis::z);
  EXPECT_EQ(measures.whole.points, kept);
  EXPECT_NEAR(measures.slabs.back().to, 500, 0.5);
  EXPECT_TRUE(measures.whole.gaps.empty());
}

TEST(ScanMeasures, IsTheSameOnAnyNumberOfThreads) {
  const PointCloud cloud(herb(1).points);
  const ScanMeasures many = scanMeasures(cloud, {}, UpAxis::z);
  const ThreadLimit one(1);
  const ScanMeasures single = scanMeasures(cloud, {}, UpAxis::z);
  EXPECT_EQ(many.whole.scatter, single.whole.scatter);
  EXPECT_EQ(many.whole.thickness->median, single.whole.thickness->median);
  EXPECT_EQ(many.whole.arc, single.whole.arc);
  EXPECT_EQ(many.whole.gaps, single.whole.gaps);
  EXPECT_EQ(many.whole.foliage, single.whole.foliage);
  EXPECT_EQ(many.spacing, single.spacing);
}

TEST(ScanMeasures, SaysNothingOfFewPoints) {
  const ScanMeasures none = scanMeasures(PointCloud(), {}, UpAxis::z);
  EXPECT_EQ(none.whole.points, 0);
  EXPECT_FALSE(none.whole.spacing);
  EXPECT_TRUE(none.slabs.empty());
  RawPoints same;
  same.positions.assign(50, Eigen::Vector3d(1, 2, 3));
  const ScanMeasures one = scanMeasures(PointCloud(std::move(same)), {}, UpAxis::z);
  EXPECT_EQ(one.whole.points, 1);
  EXPECT_FALSE(one.whole.scatter);
  RawPoints two;
  two.positions = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 1)};
  const ScanMeasures pair = scanMeasures(PointCloud(std::move(two)), {}, UpAxis::z);
  ASSERT_TRUE(pair.whole.spacing);
  EXPECT_DOUBLE_EQ(pair.whole.spacing->median, 1);
  EXPECT_FALSE(pair.whole.thickness);
}

TEST(ScanMeasures, StopsWhenAsked) {
  const PointCloud cloud(herb(0).points);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { (void)scanMeasures(cloud, {}, UpAxis::z, progress); }));
}

} // namespace
} // namespace espalier
