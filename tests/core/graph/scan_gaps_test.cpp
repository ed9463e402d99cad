#include "core/base/random.h"
#include "core/graph/scan_gaps.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// An upright cylinder of radius 2, a point per unit of its surface, without what lies in a gap.
Eigen::Matrix3Xf cylinderWithGaps(const std::vector<std::pair<double, double>>& gaps) {
  constexpr double height = 400;
  Random random(1);
  std::vector<Eigen::Vector3f> kept;
  for (int i = 0; i < static_cast<int>(4 * std::numbers::pi * height); ++i) {
    const double at = 2 * std::numbers::pi * random.uniform();
    const double z = height * random.uniform();
    bool isInGap = false;
    for (const auto& [from, to] : gaps)
      isInGap = isInGap || (z > from && z < to);
    if (!isInGap)
      kept.push_back(Eigen::Vector3d(2 * std::cos(at), 2 * std::sin(at), z).cast<float>());
  }
  Eigen::Matrix3Xf points(3, std::ssize(kept));
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = kept[static_cast<std::size_t>(i)];
  return points;
}

TEST(ScanGaps, AreWhereAndAsWideAsPointsAreMissing) {
  const std::vector<ScanGap> gaps = scanGaps(cylinderWithGaps({{100, 120}, {250, 264}}), 1);
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_NEAR(gaps[0].width, 14, 3);
  EXPECT_NEAR(static_cast<double>(gaps[0].middle.z()), 257, 3);
  EXPECT_NEAR(gaps[1].width, 20, 3);
  EXPECT_NEAR(static_cast<double>(gaps[1].middle.z()), 110, 3);
}

TEST(ScanGaps, AreNoneInWholeWoodNorWhereItIsNarrow) {
  EXPECT_TRUE(scanGaps(cylinderWithGaps({}), 1).empty());
  EXPECT_TRUE(scanGaps(cylinderWithGaps({{100, 103}}), 1).empty());
}

TEST(ScanGaps, AreNoneBesideAFewStrays) {
  const Eigen::Matrix3Xf whole = cylinderWithGaps({});
  Eigen::Matrix3Xf points(3, whole.cols() + 4);
  points.leftCols(whole.cols()) = whole;
  for (Eigen::Index i = 0; i < 4; ++i)
    points.col(whole.cols() + i) = Eigen::Vector3f(30, 0, 10.0F * static_cast<float>(i));
  EXPECT_TRUE(scanGaps(points, 1).empty());
}

TEST(ScanGaps, AreNoneOfFewPoints) {
  EXPECT_TRUE(scanGaps(Eigen::Matrix3Xf(3, 0), 1).empty());
  EXPECT_TRUE(scanGaps(Eigen::Matrix3Xf::Zero(3, 1), 1).empty());
  EXPECT_TRUE(scanGaps(Eigen::Matrix3Xf::Ones(3, 50), 1).empty());
}

TEST(ScanGaps, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked(
      [](const Progress& progress) { (void)scanGaps(cylinderWithGaps({}), 1, progress); }));
}

} // namespace
} // namespace espalier
