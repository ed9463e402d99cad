#include "core/base/random.h"
#include "core/cloud/far_points.h"
#include "core/cloud/point_cloud.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <numeric>

namespace espalier {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points fork(const Eigen::Vector3d& place = {0, 0, 0}) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  Points result;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result.emplace_back(points.col(i).cast<double>() + place);
  return result;
}

std::vector<Eigen::Index> farOf(const Points& points) {
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& point : points)
    bounds.extend(point);
  const auto place = [&](Eigen::Index i) { return points[static_cast<std::size_t>(i)]; };
  return farPoints(std::ssize(points), place, bounds);
}

/// The columns from `first` to before `end`.
std::vector<Eigen::Index> columns(std::size_t first, std::size_t end) {
  std::vector<Eigen::Index> result(end - first);
  std::iota(result.begin(), result.end(), static_cast<Eigen::Index>(first));
  return result;
}

TEST(FarPoints, AreThoseAtTheOriginOfAScanInMapCoordinates) {
  Points points = fork({455123, 5412987, 312});
  points.emplace_back(0, 0, 0);
  EXPECT_EQ(farOf(points), columns(points.size() - 1, points.size()));
}

TEST(FarPoints, AreFoundThoughFivePercentOfThemLieAnywhere) {
  Points points = fork();
  const std::size_t plant = points.size();
  Random random(5);
  while (points.size() < plant * 100 / 95)
    points.emplace_back(random.uniform(20, 1e6) * random.direction());
  EXPECT_EQ(farOf(points), columns(plant, points.size()));
}

TEST(FarPoints, LieTogetherAsWell) {
  Points points = fork();
  const std::size_t plant = points.size();
  for (int i = 0; i < 15; ++i)
    points.emplace_back(30 + 0.001 * i, 0, 0);
  EXPECT_EQ(farOf(points), columns(plant, points.size()));
}

// A crown of nearly all points, on a trunk of ten times its size with hardly any.
TEST(FarPoints, AreNoneWhereTheyAreLinked) {
  Points points;
  Random random(7);
  for (int i = 0; i < 4000; ++i)
    points.emplace_back(Eigen::Vector3d(0, 0, 10) + 0.5 * random.direction());
  for (int i = 0; i < 40; ++i)
    points.emplace_back(0, 0, 0.25 * i);
  EXPECT_TRUE(farOf(points).empty());
}

TEST(FarPoints, AreNoSecondPlant) {
  Points points = fork();
  for (const Eigen::Vector3d& point : fork({40, 0, 0}))
    points.push_back(point);
  EXPECT_TRUE(farOf(points).empty());
  points.emplace_back(-1000, 0, 0);
  EXPECT_EQ(farOf(points).size(), 1U);
}

TEST(FarPoints, AreNoneOfFewOrOfNone) {
  EXPECT_TRUE(farOf({}).empty());
  EXPECT_TRUE(farOf(Points(50, {1, 2, 3})).empty());
  EXPECT_TRUE(farOf({{0, 0, 0}, {0, 0, 1}, {1e6, 0, 0}}).empty()) << "who is to say which one?";
}

TEST(FarPoints, TurnUpWithTheirDistancesWhateverTheScale) {
  for (const double scale : {1e-3, 1e6}) {
    Points points = fork();
    points.emplace_back(100, 0, 0);
    for (Eigen::Vector3d& point : points)
      point *= scale;
    EXPECT_EQ(farOf(points), columns(points.size() - 1, points.size())) << scale;
  }
}

/// A tree of nearly all points, and far beside it a sapling of hardly any; the tree's points come
/// first in the file.
struct Stand {
  Eigen::Matrix3Xf tree = test::cylinder({0, 0, 0}, {0, 0, 4}, 0.45, 0.02);
  Eigen::Matrix3Xf sapling = test::cylinder({15, 0, 0}, {15, 0, 0.8}, 0.02, 0.02);
  PointCloud cloud = PointCloud(RawPoints{.positions = places()});

  [[nodiscard]] Points places() const {
    Points result;
    const Eigen::Matrix3Xf all = test::both(tree, sapling);
    for (Eigen::Index i = 0; i < all.cols(); ++i)
      result.emplace_back(all.col(i).cast<double>());
    return result;
  }
  [[nodiscard]] PointSet ofTree() const {
    std::vector<Eigen::Index> points;
    for (Eigen::Index i = 0; i < cloud.size(); ++i)
      if (cloud.fileOrder()[static_cast<std::size_t>(i)] < tree.cols()) points.push_back(i);
    return PointSet::of(points);
  }
};

TEST(FarPoints, AreSoughtAmongThoseThatAreNotSetAside) {
  const Stand stand;
  EXPECT_EQ(std::ssize(farPoints(stand.cloud)), stand.sapling.cols());
  EXPECT_TRUE(farPoints(stand.cloud, stand.ofTree()).empty());
  EXPECT_GT(plantBounds(stand.cloud, stand.ofTree()).min().x(), 14.9);
  EXPECT_LT(plantBounds(stand.cloud).max().x(), 0.5);
}

// 200 copies of one place are over 1 % of the points, and yet one place.
TEST(FarPoints, AreAllOfThoseAtAPlaceThatCountsOnce) {
  RawPoints raw{.positions = fork()};
  const Eigen::AlignedBox3d plant = PointCloud(raw).bounds();
  raw.positions.insert(raw.positions.end(), 200, Eigen::Vector3d(30, 0, 0));
  const PointCloud cloud(raw);
  EXPECT_EQ(farPoints(cloud).size(), 200U);
  EXPECT_LT(plantBounds(cloud).max().x(), plant.max().x() + 0.01);
  EXPECT_EQ(farPoints(cloud, PointSet::of({farPoints(cloud).front()})).size(), 199U);
}

/// A scan of the fork, in map coordinates.
RawPoints rawFork() {
  return {.positions = fork({455123.25, 5412987.5, 312.125})};
}

TEST(PointCloud, IsStoredAsWithoutItsFarPoints) {
  const PointCloud alone(rawFork());
  for (const Eigen::Vector3d& stray :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(455123, 5412987, -1e12)}) {
    RawPoints raw = rawFork();
    raw.positions.insert(raw.positions.begin() + 77, stray);
    const PointCloud cloud(raw);
    const std::vector<Eigen::Index> far = farPoints(cloud);
    ASSERT_EQ(far.size(), 1U);
    EXPECT_EQ(cloud.position(far[0]).cast<float>(), stray.cast<float>());
    EXPECT_EQ(cloud.origin(), alone.origin());
    Eigen::Matrix3Xf others(3, alone.size());
    for (Eigen::Index i = 0, next = 0; i < cloud.size(); ++i)
      if (i != far[0]) others.col(next++) = cloud.positions().col(i);
    EXPECT_EQ(others, alone.positions()) << "bit for bit, in the same order";
    EXPECT_EQ(plantBounds(cloud).max(), alone.bounds().max());
    EXPECT_EQ(plantBounds(cloud).min(), alone.bounds().min());
    EXPECT_GT(cloud.bounds().sizes().maxCoeff(), 1e5) << "of all points";
  }
}

TEST(PointCloud, FindsItsFarPointsAgainWhenItIsStored) {
  RawPoints raw = rawFork();
  raw.positions.emplace_back(0, 0, 0);
  const PointCloud cloud(raw);
  const PointCloud again(StoredPoints{.positions = cloud.positions(),
                                      .origin = cloud.origin(),
                                      .colors = {},
                                      .intensities = {},
                                      .fileOrder = cloud.fileOrder()});
  EXPECT_EQ(farPoints(again), farPoints(cloud));
  EXPECT_EQ(farPoints(cloud).size(), 1U);
  EXPECT_TRUE(farPoints(PointCloud(rawFork())).empty());
}

// The one end of all that is read lies twice as far from the other as from the middle.
TEST(PointCloud, IsStoredWithAPointAtTheOtherEndOfAllThatIsRead) {
  RawPoints raw;
  for (const Eigen::Vector3d& place : fork())
    raw.positions.emplace_back(place + Eigen::Vector3d(1e12 - 100, 0, 0));
  raw.positions.emplace_back(-1e12, 0, 0);
  const PointCloud cloud(raw);
  ASSERT_EQ(cloud.size(), std::ssize(raw.positions));
  const PointCloud again(StoredPoints{.positions = cloud.positions(),
                                      .origin = cloud.origin(),
                                      .colors = {},
                                      .intensities = {},
                                      .fileOrder = cloud.fileOrder()});
  EXPECT_EQ(again.positions(), cloud.positions());
}

} // namespace
} // namespace espalier
