#include "ui/document/scan.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Five points around (1000, 0, 2), and five far from them around (1000, 0, 8).
Scan twoClumps() {
  RawPoints raw;
  for (const double z : {2.0, 8.0})
    for (const Eigen::Vector2d& offset :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.1, 0), Eigen::Vector2d(-0.1, 0),
          Eigen::Vector2d(0, 0.1), Eigen::Vector2d(0, -0.1)})
      raw.positions.emplace_back(1000 + offset.x(), offset.y(), z);
  return Scan(PointCloud(raw));
}

TEST(Scan, FindsTheMiddleOfTheFiveNearestPoints) {
  EXPECT_TRUE(twoClumps().onPoints({1000.3, 0.2, 7}).isApprox(Eigen::Vector3d(1000, 0, 8), 1e-7));
}

TEST(Scan, LeavesAPlaceThatIsOutOfReach) {
  const Eigen::Vector3d place(1000, 0, 3.5);
  EXPECT_EQ(twoClumps().onPoints(place, 1), place);
  EXPECT_TRUE(twoClumps().onPoints(place, 2).isApprox(Eigen::Vector3d(1000, 0, 2), 1e-7));
}

TEST(Scan, KnowsItsHeightAndSpacing) {
  EXPECT_NEAR(twoClumps().height(UpAxis::z), 6, 1e-6);
  EXPECT_NEAR(twoClumps().height(UpAxis::y), 0.2, 1e-6) << "if it stands along y";
  EXPECT_NEAR(twoClumps().spacing(), 0.1, 1e-5);
}

TEST(Scan, FindsNothingOfThePointsSetAside) {
  const Scan whole = twoClumps(); // sorted along z: the lower five come first
  const Scan upper = whole.leavingOut(PointSet::firstOf(5));
  EXPECT_EQ(upper.cloud(), whole.cloud()) << "shared, and whole";
  EXPECT_TRUE(upper.onPoints({1000, 0, 2}).isApprox(Eigen::Vector3d(1000, 0, 8), 1e-7));
  EXPECT_TRUE(upper.near({1000, 0, 2}, 1).empty());
  EXPECT_EQ(upper.near({1000, 0, 8}, 1).size(), 5U);
  EXPECT_EQ(upper.leavingOut({}).near({1000, 0, 2}, 1).size(), 5U) << "brought back";
  const Eigen::Vector3d place(1, 2, 3);
  EXPECT_EQ(whole.leavingOut(PointSet::firstOf(10)).onPoints(place), place);
}

/// A column of 100 places 0.1 apart, each with so many points.
RawPoints column(int copies) {
  RawPoints raw;
  for (int i = 0; i < 100 * copies; ++i)
    raw.positions.emplace_back(0, 0, 0.1 * (i / copies));
  return raw;
}

TEST(Scan, MeasuresThePointsThatAreNotSetAside) {
  const Scan whole((PointCloud(column(1))));
  EXPECT_NEAR(whole.height(UpAxis::z), 9.9, 1e-5);
  const Scan lower = whole.leavingOut(PointSet::firstOf(100) - PointSet::firstOf(41));
  EXPECT_NEAR(lower.height(UpAxis::z), 4, 1e-5);
  std::vector<Eigen::Index> odd;
  for (Eigen::Index i = 1; i < 100; i += 2)
    odd.push_back(i);
  EXPECT_NEAR(whole.leavingOut(PointSet::of(odd)).spacing(), 0.2, 1e-5);
  EXPECT_NEAR(whole.leavingOut(PointSet::of(odd)).leavingOut({}).spacing(), 0.1, 1e-5);
  EXPECT_NEAR(whole.leavingOut(PointSet::firstOf(99)).spacing(), 0.1, 1e-5)
      << "one point has none: it stays";
}

TEST(Scan, IsNotMeasuredByAPointFarAway) {
  RawPoints raw = column(1);
  raw.positions.emplace_back(0, 0, -5e6);
  const Scan scan((PointCloud(raw)));
  EXPECT_NEAR(scan.height(UpAxis::z), 9.9, 1e-5);
  EXPECT_NEAR(scan.spacing(), 0.1, 1e-5);
}

TEST(Scan, FindsEachPlaceOnce) {
  const Scan scan((PointCloud(column(9))));
  EXPECT_NEAR(scan.spacing(), 0.1, 1e-5);
  EXPECT_EQ(scan.near({0, 0, 1}, 0.15).size(), 3U);
  EXPECT_EQ(scan.leavingOut(PointSet::firstOf(5)).near({0, 0, 0}, 0.15).size(), 2U)
      << "another point of the place is found then";
  EXPECT_TRUE(scan.onPoints({0, 0, 5}).isApprox(Eigen::Vector3d(0, 0, 5), 1e-6));
}

TEST(Scan, KnowsNoPointBehindItsLast) {
  EXPECT_EQ(twoClumps().leavingOut(PointSet::of({9, 10, 500})).leftOut(), PointSet::of({9}));
}

} // namespace
} // namespace espalier
