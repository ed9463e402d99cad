#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/contract/fill_holes.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace espalier {
namespace {

using Points = Eigen::Matrix3Xf;

/// Those of some points that are not where `isHole`.
Points without(const Points& points, const std::function<bool(const Eigen::Vector3f&)>& isHole) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (!isHole(points.col(i))) kept.push_back(i);
  return points(Eigen::all, kept);
}

/// A square sheet of points about 1 apart, with a round hole in its middle.
Points sheetWithHole(double radius) {
  Random random(3);
  Points points(3, 1600);
  for (int i = 0; i < 1600; ++i)
    points.col(i) = Eigen::Vector3d(i % 40 - 19.5 + random.uniform(-0.2, 0.2),
                                    i / 40 - 19.5 + random.uniform(-0.2, 0.2), 0)
                        .cast<float>();
  return without(points, [&](const Eigen::Vector3f& point) {
    return static_cast<double>(point.norm()) < radius;
  });
}

HoleOptions upTo(double widest) {
  return {.widest = widest, .spacing = 0.9, .radius = 6};
}

/// Radius of the largest circle in the sheet, with its middle in the hole, that holds no point.
double largestCircle(const Points& points, double hole) {
  const SpatialIndex index(points);
  double largest = 0;
  for (double x = -hole; x <= hole; x += 0.1)
    for (double y = -hole; y <= hole; y += 0.1)
      if (std::hypot(x, y) <= hole)
        largest = std::max(
            largest,
            std::sqrt(static_cast<double>(
                index.nearestOne(Eigen::Vector3d(x, y, 0).cast<float>())->squaredDistance)));
  return largest;
}

TEST(FillHoles, PutsPointsIntoTheHoleOfASheetAndNowhereElse) {
  const Points sheet = sheetWithHole(5);
  EXPECT_GT(largestCircle(sheet, 5), 4.5);
  for (const LocalShape shape : {LocalShape::plane, LocalShape::sphere}) {
    const Points added = pointsInHoles(sheet, shape, upTo(12));
    ASSERT_GT(added.cols(), 5);
    EXPECT_LT(added.row(2).cwiseAbs().maxCoeff(), 1e-3F) << "on the sheet";
    EXPECT_LT(added.colwise().norm().maxCoeff(), 5) << "in the hole";
    const Points all = test::both(sheet, added);
    EXPECT_LT(largestCircle(all, 5), 1.7);
    const SpatialIndex index(all);
    for (Eigen::Index i = sheet.cols(); i < all.cols(); ++i)
      EXPECT_GT(index.nearest(all.col(i), 2)[1].squaredDistance, 0.9 * 0.9);
  }
}

TEST(FillHoles, LeavesHolesThatAreWider) {
  EXPECT_EQ(pointsInHoles(sheetWithHole(5), LocalShape::plane, upTo(8)).cols(), 0);
}

TEST(FillHoles, LeavesAWholeSheetAndItsEdge) {
  EXPECT_EQ(pointsInHoles(sheetWithHole(0), LocalShape::plane, upTo(12)).cols(), 0);
}

TEST(FillHoles, LeavesWoodOpenThatWasSeenFromOneSide) {
  const Points half = without(test::cylinder({0, 0, -20}, {0, 0, 20}, 10, 1),
                              [](const Eigen::Vector3f& point) { return point.y() > 0; });
  EXPECT_EQ(pointsInHoles(half, LocalShape::sphere, upTo(12)).cols(), 0);
}

TEST(FillHoles, FollowsTheBendOfTheWood) {
  const Points wood =
      without(test::cylinder({0, 0, -25}, {0, 0, 25}, 15, 1), [](const Eigen::Vector3f& point) {
        return point.x() > 0 && std::hypot(point.y(), point.z()) < 4;
      });
  const Points added = pointsInHoles(wood, LocalShape::sphere, upTo(11));
  ASSERT_GT(added.cols(), 3);
  for (const auto& point : added.colwise()) {
    EXPECT_NEAR(point.head<2>().norm(), 15, 0.15);
    EXPECT_LT(std::hypot(point.y(), point.z()), 4);
  }
}

TEST(FillHoles, IsTheSameOnAnyNumberOfThreads) {
  const Points sheet = sheetWithHole(5);
  const Points added = pointsInHoles(sheet, LocalShape::sphere, upTo(12));
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(pointsInHoles(sheet, LocalShape::sphere, upTo(12)), added) << threads;
  }
}

TEST(FillHoles, FindsNoneWhereThereIsNoSurface) {
  Points line(3, 30);
  for (Eigen::Index i = 0; i < line.cols(); ++i)
    line.col(i) = Eigen::Vector3f(0, 0, static_cast<float>(i * i));
  for (const Points& scan :
       {Points(3, 0), Points(Points::Zero(3, 1)), Points(Points::Ones(3, 40)), line})
    EXPECT_EQ(pointsInHoles(scan, LocalShape::plane, upTo(12)).cols(), 0);
}

TEST(FillHoles, StopsWhenAsked) {
  const Points sheet = sheetWithHole(5);
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)pointsInHoles(sheet, LocalShape::plane, upTo(12), progress);
  }));
}

} // namespace
} // namespace espalier
