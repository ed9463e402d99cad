#include "core/base/parallel.h"
#include "core/graph/normals.h"
#include "core/graph/orientations.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr float radius = 0.04F; // of the trunk below, along x

Eigen::Matrix3Xf trunk() {
  return test::cylinder({-1, 0, 0}, {1, 0, 0}, radius, 0.01);
}

/// Those of its points that are not near its ends.
template <class Visit> void inTheMiddle(const Eigen::Matrix3Xf& points, const Visit& visit) {
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (std::abs(points(0, i)) < 0.8F) visit(i);
}

/// Across the trunk, away from its axis.
Eigen::Vector3f outwards(const Eigen::Vector3f& point) {
  return Eigen::Vector3f(0, point.y(), point.z()).normalized();
}

TEST(Orientations, RunAlongAThinTrunk) {
  const Eigen::Matrix3Xf points = trunk();
  const auto found = orientations(points, NeighborhoodGraph(points, 7), 6 * radius);
  inTheMiddle(points, [&](Eigen::Index i) {
    const Orientation& one = found[static_cast<std::size_t>(i)];
    EXPECT_GT(std::abs(one.direction.x()), std::cos(0.1F));
    EXPECT_GT(one.linearity, 0.7F);
    EXPECT_NEAR(one.direction.norm(), 1, 1e-5);
  });
}

TEST(Orientations, ShowWhereTheBallIsTooSmallForTheWood) {
  const Eigen::Matrix3Xf points = test::cylinder({-1, 0, 0}, {1, 0, 0}, 0.5, 0.02);
  const auto found = orientations(points, NeighborhoodGraph(points, 7), 0.1F);
  double sum = 0;
  for (const Orientation& one : found)
    sum += one.linearity;
  EXPECT_LT(sum / static_cast<double>(found.size()), 0.5);
}

TEST(Orientations, OfALineAreItsDirection) {
  Eigen::Matrix3Xf line(3, 9);
  for (int i = 0; i < 9; ++i)
    line.col(i) = static_cast<float>(i) * Eigen::Vector3f(2, 1, 2) / 3;
  for (const Orientation& one : orientations(line, NeighborhoodGraph(line, 2), 0)) {
    EXPECT_NEAR(std::abs(one.direction.dot(Eigen::Vector3f(2, 1, 2)) / 3), 1, 1e-5);
    EXPECT_NEAR(one.linearity, 1, 1e-5);
  }
}

TEST(Orientations, AreUnknownWherePointsCoincide) {
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 5);
  for (const Orientation& one : orientations(same, NeighborhoodGraph(same, 4), 1)) {
    EXPECT_EQ(one.direction, Eigen::Vector3f::Zero());
    EXPECT_EQ(one.linearity, 0);
  }
}

TEST(Orientations, AreTheSameOnAnyNumberOfThreadsAndStopWhenAsked) {
  const Eigen::Matrix3Xf points = trunk();
  const NeighborhoodGraph graph(points, 7);
  const auto onMany = orientations(points, graph, 0.1F);
  const ThreadLimit limit(1);
  const auto onOne = orientations(points, graph, 0.1F);
  for (std::size_t i = 0; i < onMany.size(); ++i)
    EXPECT_EQ(onMany[i].direction, onOne[i].direction);
  EXPECT_TRUE(
      test::stopsWhenAsked([&](const Progress& p) { (void)orientations(points, graph, 0.1F, p); }));
}

TEST(Normals, PointAcrossTheWood) {
  const Eigen::Matrix3Xf points = trunk();
  const Eigen::Matrix3Xf found = normals(points, nearestNeighborhoods(points, 12));
  inTheMiddle(points, [&](Eigen::Index i) {
    EXPECT_GT(std::abs(found.col(i).dot(outwards(points.col(i)))), std::cos(0.2F));
  });
}

TEST(OrientedNormals, LookOutwardsAllOver) {
  Eigen::Matrix3Xf points = trunk();
  // A second plant, elsewhere, has its own outside.
  points = test::both(points, points.colwise() + Eigen::Vector3f(0, 3, 0));
  const NeighborhoodGraph graph(points, 10);
  const Eigen::Matrix3Xf found =
      orientedNormals(points, normals(points, nearestNeighborhoods(points, 12)), graph);
  inTheMiddle(points, [&](Eigen::Index i) {
    Eigen::Vector3f place = points.col(i);
    if (place.y() > 1) place.y() -= 3;
    EXPECT_GT(found.col(i).dot(outwards(place)), std::cos(0.2F));
  });
}

} // namespace
} // namespace espalier
