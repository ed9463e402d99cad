#include "core/base/random.h"
#include "core/surface/envelopes/envelope.h"
#include "core/surface/envelopes/rings.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace espalier {
namespace {

/// A drum of many sides: its ends are fans of slivers that all meet in the middle.
SurfaceMesh drum(int sides, const Eigen::Vector3d& middle) {
  std::vector<Ring> rings(2);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (std::size_t end = 0; end < 2; ++end)
      rings[end].push_back(
          middle + Eigen::Vector3d(std::cos(angle), 0.5 * std::sin(angle), end == 0 ? -1.0 : 1.0));
  }
  return meshOfRings(middle - Eigen::Vector3d::UnitZ(), rings, middle + Eigen::Vector3d::UnitZ());
}

/// Share of the points behind each triangle of a convex mesh.
double shareBehindAll(const SurfaceMesh& mesh, const Eigen::Matrix3Xd& points) {
  double inside = 0;
  for (const auto& point : points.colwise())
    inside += std::ranges::all_of(mesh.triangles, [&](const std::array<int, 3>& triangle) {
      const auto at = [&](std::size_t i) {
        return mesh.corners[static_cast<std::size_t>(triangle[i])];
      };
      return (at(1) - at(0)).cross(at(2) - at(0)).dot(point - at(0)) <= 0;
    });
  return inside / static_cast<double>(points.cols());
}

Eigen::Matrix3Xd pointsAround(const Eigen::Vector3d& middle, Eigen::Index count) {
  Random random(3);
  Eigen::Matrix3Xd points(3, count);
  for (auto point : points.colwise())
    point = middle + 1.2 * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1),
                                           random.uniform(-1, 1));
  return points;
}

TEST(ShareInside, IsThatOfThePointsBehindAllTriangles) {
  for (const Eigen::Vector3d& middle :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(652'000, 5'401'000, 250)})
    for (const int sides : {3, 4, 17, 500}) {
      SCOPED_TRACE(sides);
      const Eigen::Matrix3Xd points = pointsAround(middle, 3'000);
      const SurfaceMesh mesh = drum(sides, middle);
      const double share = shareBehindAll(mesh, points);
      EXPECT_GT(share, 0.05); // of a drum with three sides: 0.09
      EXPECT_EQ(shareInside(mesh, points), share);
    }
}

TEST(ShareInside, CountsPointsOnEdgesSeenFromAboveOnce) {
  const SurfaceMesh mesh = drum(8, Eigen::Vector3d::Zero());
  Eigen::Matrix3Xd points(3, 4); // on the edges of the fans, and at its middle
  points << 0, 0.5, 0, -0.25, 0, 0, 0.25, 0, 0, 0, 0.5, -0.5;
  EXPECT_EQ(shareInside(mesh, points), 1);
  EXPECT_EQ(shareInside(mesh, points.colwise() + Eigen::Vector3d(0, 0, 1.6)), 0);
  EXPECT_EQ(shareInside(mesh, Eigen::Matrix3Xd(3, 0)), 0);
}

TEST(ShareInside, OfAFanOfThousandsOfSliversIsFound) {
  const Eigen::Matrix3Xd points = pointsAround(Eigen::Vector3d::Zero(), 20'000);
  double truth = 0; // the drum is an elliptic cylinder but for 1e-7 of its radius
  for (const auto& point : points.colwise())
    truth += std::hypot(point.x(), 2 * point.y()) <= 1 && std::abs(point.z()) <= 1;
  EXPECT_NEAR(shareInside(drum(8'000, Eigen::Vector3d::Zero()), points), truth / 20'000, 1e-4);
}

} // namespace
} // namespace espalier
