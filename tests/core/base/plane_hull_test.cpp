#include "core/base/parallel.h"
#include "core/base/plane_hull.h"
#include "core/base/random.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector2d;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(PlaneHull, GoesAroundFromTheLeftmostCorner) {
  EXPECT_THAT(planeHull({{1, 1}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {0, 0}, {2, 2}, {0, 1}}),
              ElementsAre(Vector2d(0, 0), Vector2d(2, 0), Vector2d(2, 2), Vector2d(0, 2)))
      << "neither what lies within, nor on an edge, nor twice";
}

TEST(PlaneHull, OfWhatFillsNoPlaneIsItsEnds) {
  EXPECT_THAT(planeHull({}), IsEmpty());
  EXPECT_THAT(planeHull({{3, 4}}), ElementsAre(Vector2d(3, 4)));
  EXPECT_THAT(planeHull({{3, 4}, {3, 4}, {3, 4}}), ElementsAre(Vector2d(3, 4)));
  EXPECT_THAT(planeHull({{3, 1}, {1, 2}}), ElementsAre(Vector2d(1, 2), Vector2d(3, 1)));
  std::vector<Vector2d> line; // in no order, of a slope that rounding bends
  for (int i = 0; i < 100; ++i)
    line.emplace_back(Vector2d(652'000.1, 5'401'000.7) + Vector2d(0.1, 0.7) * (i * 37 % 100));
  EXPECT_THAT(planeHull(line), ElementsAre(line[0], line[27]));
}

/// `corners` points on a circle that is far away, and others within it.
std::vector<Vector2d> disk(int corners, int others, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vector2d> points;
  for (int i = 0; i < corners + others; ++i) {
    const double angle = 2 * std::numbers::pi * random.uniform();
    const double radius = i < corners ? 1 : 0.9 * random.uniform();
    points.emplace_back(652'000 + radius * std::cos(angle), 5'401'000 + radius * std::sin(angle));
  }
  return points;
}

TEST(PlaneHull, IsTheSameInAnyOrder) {
  std::vector<Vector2d> points = disk(1000, 2000, 4);
  const std::vector<Vector2d> hull = planeHull(points);
  EXPECT_EQ(hull.size(), 1000U);
  std::ranges::reverse(points);
  EXPECT_EQ(planeHull(points), hull);
}

TEST(PlaneHull, OfManyAtOnceAreThoseOfEach) {
  std::vector<std::size_t> sizes(200);
  parallelFor(
      std::ssize(sizes),
      [&](Eigen::Index i) {
        const int corners = 3 + static_cast<int>(i);
        sizes[static_cast<std::size_t>(i)] =
            planeHull(disk(corners, 100, static_cast<std::uint64_t>(i))).size();
      },
      {}, 1);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    EXPECT_EQ(sizes[i], planeHull(disk(3 + static_cast<int>(i), 100, i)).size());
}

// However thin, there is a hull: of a body or of a line.
TEST(PlaneHull, TakesThinStrips) {
  Random random(5);
  for (double width = 1; width > 1e-18; width /= 3) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 100; ++i)
      points.emplace_back(Eigen::Rotation2Dd(0.7) *
                          Vector2d(random.uniform(), width * random.uniform()));
    EXPECT_GE(planeHull(points).size(), 2U) << width;
  }
}

} // namespace
} // namespace espalier
