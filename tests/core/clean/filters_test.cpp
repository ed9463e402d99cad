// The simpler filters, each on points of which the answer is known.
#include "core/clean/crop.h"
#include "core/clean/outliers.h"
#include "core/clean/parts.h"
#include "core/clean/plants.h"
#include "core/clean/thinning.h"
#include "core/clean/value_ranges.h"
#include "core/cloud/voxels.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace espalier {
namespace {

std::ptrdiff_t countOf(const std::vector<bool>& marks) {
  return std::ranges::count(marks, true);
}

Eigen::Matrix3Xf movedBy(Eigen::Matrix3Xf points, float x) {
  points.row(0).array() += x;
  return points;
}

TEST(Outliers, AreThoseFarFromTheirNeighbors) {
  Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Index plant = points.cols();
  points = test::both(points, Eigen::Vector3f(2, 0, 1));
  const SpatialIndex index(points);
  const std::vector<bool> found = statisticalOutliers(index, {.neighbors = 8, .deviations = 6});
  EXPECT_TRUE(found[static_cast<std::size_t>(plant)]);
  EXPECT_LT(countOf(found), 5);
  EXPECT_EQ(countOf(statisticalOutliers(index, {.neighbors = 100000})), 0) << "too few points";
}

TEST(SparsePoints, AreTheShareAskedForTheThinnestFirst) {
  const Eigen::Matrix3Xf points =
      test::both(test::forkCloud(), movedBy(2 * test::forkCloud(), 10)); // half as dense
  const SpatialIndex index(points);
  const std::vector<bool> found = sparsestPoints(index, {.neighbors = 8, .share = 0.25});
  EXPECT_NEAR(static_cast<double>(countOf(found)), 0.25 * static_cast<double>(points.cols()), 2);
  EXPECT_LT(std::count(found.begin(), found.begin() + points.cols() / 2, true), 10);
  EXPECT_EQ(countOf(sparsestPoints(index, {.share = 0})), 0);
}

TEST(Parts, AreKeptByTheirSizeOrTheirRoot) {
  const Eigen::Matrix3Xf small = test::cylinder({5, 0, 0}, {5, 0, 0.5}, 0.04, 0.02);
  const Eigen::Matrix3Xf points = test::both(test::forkCloud(), small);
  const auto plant = points.cols() - small.cols();
  const auto left = [&](KeptParts keep, const std::optional<Eigen::Vector3f>& root, int least) {
    return outsideParts(points, root, {.keep = keep, .widestGap = 0.2, .leastPoints = least});
  };
  EXPECT_EQ(countOf(left(KeptParts::largest, {}, 1)), small.cols());
  EXPECT_EQ(countOf(left(KeptParts::rooted, Eigen::Vector3f(5, 0, 0), 1)), plant);
  EXPECT_EQ(countOf(left(KeptParts::rooted, {}, 1)), small.cols()) << "no root: the largest";
  EXPECT_EQ(countOf(left(KeptParts::large, {}, 50)), 0);
  EXPECT_EQ(countOf(left(KeptParts::large, {}, static_cast<int>(small.cols()) + 1)), small.cols());
  EXPECT_TRUE(outsideParts(Eigen::Matrix3Xf(3, 0), {}, {}).empty());
}

TEST(Parts, AreOneOverGapsThatAreNotTooWide) {
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 1}, 0.04, 0.02),
                                             test::cylinder({0, 0, 1.3}, {0, 0, 2}, 0.04, 0.02));
  const auto lost = [&](double gap) {
    return countOf(outsideParts(points, {}, {.keep = KeptParts::largest, .widestGap = gap}));
  };
  EXPECT_EQ(lost(0.35), 0);
  EXPECT_GT(lost(0.25), 100);
}

TEST(Thinning, ByChanceKeepsExactlyItsShare) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Index leaving = points.cols() - (3 * points.cols() + 9) / 10;
  const std::vector<bool> one = thinnedByChance(points, {.share = 0.3});
  EXPECT_EQ(countOf(one), leaving);
  EXPECT_EQ(thinnedByChance(points, {.share = 0.3}), one);
  EXPECT_NE(thinnedByChance(points, {.share = 0.3, .seed = 2}), one);
  EXPECT_TRUE(thinnedByChance(Eigen::Matrix3Xf(3, 0), {}).empty());
}

TEST(Thinning, DrawsTheSamePointsHoweverThePlantStands) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3Xf turned =
      ((1000 * turn * points).colwise() + Eigen::Vector3f(20, -40, 300)).rowwise().reverse();
  const std::vector<bool> one = thinnedByChance(points, {.share = 0.5});
  std::vector<bool> other = thinnedByChance(turned, {.share = 0.5});
  std::reverse(other.begin(), other.end());
  std::ptrdiff_t differing = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    if (one[i] != other[i]) ++differing;
  EXPECT_LE(40 * differing, std::ssize(one)) << "but for those that rounding decides";
}

TEST(Thinning, ByVoxelsKeepsOneOfEach) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const std::vector<bool> leftOut = thinnedByVoxels(points, {.edge = 0.1});
  const Voxels voxels(points, 0.1);
  EXPECT_EQ(points.cols() - countOf(leftOut), std::ssize(voxels.means(points).row(0)));
  for (std::size_t cube = 0; cube < voxels.count(); ++cube)
    EXPECT_EQ(std::ranges::count_if(voxels.members(cube), [&](auto i) { return !leftOut[i]; }), 1);
}

TEST(Thinning, BySpacingKeepsPointsApartAndAllOthersNearOne) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  constexpr float spacing = 0.06F;
  const std::vector<bool> leftOut = thinnedBySpacing(points, {.spacing = 0.06});
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (!leftOut[static_cast<std::size_t>(i)]) kept.push_back(i);
  const Eigen::Matrix3Xf staying = points(Eigen::all, kept);
  const SpatialIndex index(staying);
  for (Eigen::Index i = 0; i < staying.cols(); ++i)
    EXPECT_GE(index.nearest(staying.col(i), 2).back().squaredDistance, spacing * spacing);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    EXPECT_TRUE(index.nearestOne(points.col(i), spacing));
}

TEST(Voxels, FindTheirNeighborsAndTakeAnyWidth) {
  Eigen::Matrix3Xf points(3, 3);
  points << 0, 1.5F, 1e7F, 0, 0, 0, 0, 0, 0;
  const Voxels fine(points.leftCols(2), 1);
  ASSERT_EQ(fine.count(), 2U);
  EXPECT_EQ(fine.find(fine.place(0) + Voxels::Place(1, 0, 0)), 1U);
  EXPECT_FALSE(fine.find(fine.place(0) - Voxels::Place(1, 0, 0)));
  EXPECT_EQ(Voxels(points, 1e-6).edge(), 1e7 / 999999) << "so that a place fits its key";
  EXPECT_EQ(Voxels(Eigen::Matrix3Xf(3, 0), 1).count(), 0U);
}

TEST(ValueRanges, KeepWhatIsBetweenBothEnds) {
  EXPECT_EQ(outsideIntensities({10, 20, 30}, {.least = 0.25, .most = 0.75}),
            (std::vector{true, false, true}));
  EXPECT_EQ(outsideIntensities({7, 7}, {.least = 0.25, .most = 0.75}), (std::vector{false, false}));
  EXPECT_TRUE(outsideIntensities({}, {}).empty());
  const std::vector<Color> colors = {{255, 0, 0}, {0, 200, 0}, {90, 90, 90}, {120, 70, 20}};
  EXPECT_EQ(outsideColors(colors, {.leastRed = 100, .mostGreen = 60}),
            (std::vector{false, true, true, true}));
  EXPECT_EQ(outsideGreenness(colors, {.most = 0.1}), (std::vector{false, true, false, false}));
}

TEST(ValueRanges, KnowHues) {
  const std::vector<Color> colors = {{255, 0, 0}, {0, 200, 0}, {90, 90, 90}, {255, 0, 40}};
  constexpr double degree = std::numbers::pi / 180;
  EXPECT_EQ(outsideHues(colors, {.from = 90 * degree, .to = 150 * degree}),
            (std::vector{true, false, true, true}));
  EXPECT_EQ(outsideHues(colors, {.from = 340 * degree, .to = 20 * degree, .leastSaturation = 0.5}),
            (std::vector{false, true, true, false}))
      << "through red, without grays";
}

TEST(Crop, KeepsWhatIsInside) {
  Eigen::Matrix3Xf points(3, 4);
  points << 0, 1, 3, 0, 0, 0, 0, 2, 5, 6, 7, 9;
  const Eigen::Vector3f foot(0, 0, 5);
  EXPECT_EQ(outsideSlab(points, {.from = 1, .to = 2}), (std::vector{true, false, false, true}));
  EXPECT_EQ(outsideDistance(points, foot, {.distance = 2}),
            (std::vector{false, false, true, false}));
  EXPECT_EQ(outsideBox(points, foot, {.width = 2, .depth = 3, .height = 3}),
            (std::vector{false, false, true, true}));
}

const PlantsOptions plotOptions{.slabFrom = 0.1,
                                .slabTo = 0.3,
                                .together = 0.3,
                                .widestGap = 0.3,
                                .voxel = 0.04,
                                .leastShare = 0.01,
                                .ground = {.cell = 0.1, .tolerance = 0.02}};

std::vector<float> heightsOf(const Eigen::Matrix3Xf& points) {
  return {points.row(2).begin(), points.row(2).end()};
}

/// Of the points: the share that is of the plant it was made for, the first plant at x = 0.
double shareRight(const PlantParts& parts, Eigen::Index ofFirst) {
  const std::uint32_t first = std::abs(parts.bases[0].x()) < std::abs(parts.bases[1].x()) ? 1 : 2;
  double right = 0;
  for (std::size_t i = 0; i < parts.ofPoint.size(); ++i)
    if ((parts.ofPoint[i] == first) == (static_cast<Eigen::Index>(i) < ofFirst)) ++right;
  return right / static_cast<double>(parts.ofPoint.size());
}

/// A trunk at x, and a branch that gets thinner, to a tenth and not under 5 mm.
Eigen::Matrix3Xf tree(double x, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      double radius) {
  Eigen::Matrix3Xf points = test::cylinder({x, 0, 0}, {x, 0, 1}, 0.05, 0.01);
  constexpr int pieces = 10;
  for (int i = 0; i < pieces; ++i)
    points = test::both(points, test::cylinder(from + (to - from) * i / pieces,
                                               from + (to - from) * (i + 1) / pieces,
                                               std::max(0.005, radius * (1 - 0.1 * i)), 0.006));
  return points;
}

PlantsOptions fine() {
  PlantsOptions options = plotOptions;
  options.voxel = 0.02;
  return options;
}

TEST(Plants, AreCutWhereTheyTouch) {
  const Eigen::Matrix3Xf first = tree(0, {0, 0, 0.8}, {0.9, 0, 1.2}, 0.03);
  const Eigen::Matrix3Xf second = tree(1.8, {1.8, 0, 0.8}, {0.9, 0, 1.2}, 0.03);
  const Eigen::Matrix3Xf points = test::both(first, second); // branches meet at their tips
  const PlantParts parts = plantsAmong(points, heightsOf(points), {}, fine());
  ASSERT_EQ(parts.sizes.size(), 2U);
  EXPECT_GT(shareRight(parts, first.cols()), 0.99);
  EXPECT_EQ(parts.sizes[0] + parts.sizes[1], points.cols());
}

TEST(Plants, AreCutAtEqualWoodWhereTheyAreSaidToStand) {
  const Eigen::Matrix3Xf fork = test::forkCloud(); // arms as thick as the stem
  const Eigen::Matrix3Xf points = test::both(fork, movedBy(fork, 1.75F)); // meet at their tips
  const PlantParts parts =
      plantsAmong(points, heightsOf(points), {{0, 0, 0}, {1.75, 0, 0}}, plotOptions);
  ASSERT_EQ(parts.sizes.size(), 2U);
  EXPECT_GT(shareRight(parts, fork.cols()), 0.99);
  EXPECT_EQ(plantsAmong(points, heightsOf(points), {}, plotOptions).sizes.size(), 1U)
      << "an arch from the ground to the ground";
}

TEST(Plants, KeepABranchThatATwigOfAnotherTouches) {
  const Eigen::Matrix3Xf first = tree(0, {0, 0, 0.5}, {0.5, 0, 0.96}, 0.02);
  const Eigen::Matrix3Xf second = tree(2, {2, 0, 0.6}, {0.3, 0, 1}, 0.04);
  const Eigen::Matrix3Xf points = test::both(first, second);
  const PlantParts parts = plantsAmong(points, heightsOf(points), {}, fine());
  ASSERT_EQ(parts.sizes.size(), 2U);
  EXPECT_GT(shareRight(parts, first.cols()), 0.97);
  PlantsOptions byLength = fine();
  byLength.costs = {.power = 1.5, .thinness = 0, .turn = 0};
  EXPECT_LT(shareRight(plantsAmong(points, heightsOf(points), {}, byLength), first.cols()), 0.93)
      << "the outer half of the branch is nearer to the other stem";
}

TEST(Plants, GoOnStraightWhereTheirTwigsCross) {
  const Eigen::Matrix3Xf first = tree(0, {0, 0, 0.5}, {1.6, 0, 0.8}, 0.02);
  const Eigen::Matrix3Xf second = tree(2, {2, 0.1, 0.6}, {0.7, -0.1, 0.8}, 0.02);
  const Eigen::Matrix3Xf points = test::both(first, second);
  const PlantParts parts = plantsAmong(points, heightsOf(points), {}, fine());
  ASSERT_EQ(parts.sizes.size(), 2U);
  PlantsOptions anyTurn = fine();
  anyTurn.costs.turn = 0;
  const double right = shareRight(parts, first.cols());
  EXPECT_GT(right, 0.95);
  EXPECT_GT(right,
            shareRight(plantsAmong(points, heightsOf(points), {}, anyTurn), first.cols()) + 0.01)
      << "who is first at the crossing takes both ends";
}

TEST(Plants, ReachTheGroundWithTheirBranches) {
  Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Vector3d from(0, 0, 1.2);
  const Eigen::Vector3d step(0.2, 0, -0.23);
  for (int i = 0; i < 5; ++i) // gets thinner
    points = test::both(
        points, test::cylinder(from + i * step, from + (i + 1) * step, 0.05 - 0.008 * i, 0.015));
  const std::vector<float> heights = heightsOf(points);
  const PlantParts parts = plantsAmong(points, heights, {}, plotOptions);
  ASSERT_EQ(parts.sizes.size(), 1U) << "the branch is no stem";
  EXPECT_LT(parts.bases[0].head<2>().norm(), 0.05);
  PlantsOptions apart = plotOptions;
  apart.oneWood = 10;
  EXPECT_EQ(plantsAmong(points, heights, {}, apart).sizes.size(), 2U);
}

TEST(Plants, StandWhereTheUserSays) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const std::vector<float> heights(static_cast<std::size_t>(points.cols()), 1);
  EXPECT_TRUE(plantsAmong(points, heights, {}, plotOptions).sizes.empty()) << "nothing in the slab";
  const PlantParts parts = plantsAmong(points, heights, {{0, 0, 0}, {0, 0, 2}}, plotOptions);
  ASSERT_EQ(parts.sizes.size(), 2U) << "cut across the trunk";
  EXPECT_TRUE(plantsAmong(Eigen::Matrix3Xf(3, 0), {}, {}, plotOptions).sizes.empty());
}

TEST(Plants, StopWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const std::vector<float> heights(static_cast<std::size_t>(points.cols()), 1);
  for (const auto& work : std::vector<std::function<void(const Progress&)>>{
           [&](const Progress& progress) {
             (void)plantsAmong(points, heights, {{0, 0, 0}}, plotOptions, progress);
           },
           [&](const Progress& progress) { (void)outsideParts(points, {}, {}, progress); },
           [&](const Progress& progress) {
             (void)thinnedBySpacing(points, {.spacing = 0.05}, progress);
           },
           [&](const Progress& progress) {
             (void)thinnedByVoxels(points, {.edge = 0.05}, progress);
           }})
    EXPECT_TRUE(test::stopsWhenAsked(work));
}

} // namespace
} // namespace espalier
