#include "core/base/parallel.h"
#include "core/contract/euclidean_ball.h"
#include "core/evaluate/study/contraction_quality.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

/// Points 1 apart on the line from `from` to `to`.
Eigen::Matrix3Xf line(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  const auto count = static_cast<Eigen::Index>(std::lround((to - from).norm()));
  Eigen::Matrix3Xf points(3, count + 1);
  for (Eigen::Index i = 0; i <= count; ++i)
    points.col(i) = from + static_cast<float>(i) / static_cast<float>(count) * (to - from);
  return points;
}

/// Points 1 apart on a cylinder along z.
Eigen::Matrix3Xf uprightCylinder(double radius, int length) {
  const auto around = static_cast<int>(std::lround(2 * std::numbers::pi * radius));
  Eigen::Matrix3Xf points(3, around * length);
  for (int z = 0; z < length; ++z)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      points.col(z * around + i) =
          Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z).cast<float>();
    }
  return points;
}

/// `points` drawn onto the z axis.
Eigen::Matrix3Xf onAxis(Eigen::Matrix3Xf points) {
  points.topRows(2).setZero();
  return points;
}

ContractionQuality qualityOf(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& contracted) {
  return contractionQuality(points, contracted,
                            {.spacing = 1, .root = Eigen::Vector3f(Eigen::Vector3f::Zero())});
}

TEST(ContractionQuality, OfALineIsPerfect) {
  const Eigen::Matrix3Xf points = line({0, 0, 0}, {0, 0, 100});
  const ContractionQuality quality = qualityOf(points, points);
  EXPECT_NEAR(quality.residualThickness, 0, 1e-6);
  EXPECT_EQ(quality.shareOnLine, 1);
  EXPECT_EQ(quality.tips, 1);
  EXPECT_EQ(quality.lostTips, 0);
  EXPECT_EQ(quality.bridgedJunctions, 0);
  ASSERT_EQ(quality.residuals.size(), 101U);
  for (const float residual : quality.residuals)
    EXPECT_NEAR(residual, 0, 1e-5);
}

TEST(ContractionQuality, IsTheRadiusOfACylinderThatWasNotContracted) {
  const Eigen::Matrix3Xf points = uprightCylinder(3, 100);
  const ContractionQuality asScanned = qualityOf(points, points);
  EXPECT_NEAR(asScanned.residualThickness, 3, 0.15);
  EXPECT_LT(asScanned.shareOnLine, 0.1);
  EXPECT_EQ(asScanned.tips, 1);
  EXPECT_EQ(asScanned.bridgedJunctions, 0);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (points(2, i) < 15 || points(2, i) > 85) continue; // the axis of an end is askew
    EXPECT_NEAR(asScanned.residuals[static_cast<std::size_t>(i)], 3, 1)
        << "what is near reaches farther on this side than around the cylinder";
    EXPECT_NEAR(asScanned.thicknesses[static_cast<std::size_t>(i)], 3, 0.15);
  }
  const ContractionQuality drawn = qualityOf(points, onAxis(points));
  EXPECT_NEAR(drawn.residualThickness, 0, 1e-6);
  EXPECT_EQ(drawn.shareOnLine, 1);
}

// A point alone is nearer to the axis, or farther from it, than those near it are on the mean.
TEST(ContractionQuality, IsTheMedianOfWhatIsNearThePointsNotOfTheirDistances) {
  Eigen::Matrix3Xf points = uprightCylinder(3, 100);
  Eigen::Matrix3Xf flat = points;
  flat.row(1).setZero(); // a band, in which points lie up to 3 off the axis
  const ContractionQuality quality = qualityOf(points, flat);
  const auto median = [](std::vector<float> values) {
    std::erase_if(values, [](float value) { return std::isnan(value); });
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return static_cast<double>(*middle);
  };
  const double rootMeanSquare = 3 / std::sqrt(2.0);
  EXPECT_NEAR(quality.residualThickness, rootMeanSquare, 0.15);
  EXPECT_NEAR(median(quality.thicknesses), quality.residualThickness, 0.05);
  EXPECT_GT(quality.residualThickness - *std::ranges::min_element(quality.residuals), 2);
}

// Halfway to the axis, half of the radius is left.
TEST(ContractionQuality, FallsInProportionToTheThickness) {
  const Eigen::Matrix3Xf points = uprightCylinder(3, 100);
  const Eigen::Matrix3Xf half = (points + onAxis(points)) / 2;
  EXPECT_NEAR(qualityOf(points, half).residualThickness,
              qualityOf(points, points).residualThickness / 2, 0.1);
}

/// Two twigs 12 apart, 60 long, on a foot 6 below them.
Eigen::Matrix3Xf twoTwigs() {
  const auto arm = [](float x) {
    return test::both(line({0, 0, 6}, {x, 0, 12}), line({x, 0, 12}, {x, 0, 72}));
  };
  return test::both(line({0, 0, 0}, {0, 0, 6}), test::both(arm(6), arm(-6)));
}

TEST(ContractionQuality, FindsTwigsThatWereDrawnTogether) {
  const Eigen::Matrix3Xf points = twoTwigs();
  EXPECT_EQ(qualityOf(points, points).bridgedJunctions, 0);
  EXPECT_EQ(qualityOf(points, points).tips, 2);
  Eigen::Matrix3Xf ends = points;
  for (Eigen::Index i = 0; i < ends.cols(); ++i)
    if (ends(2, i) > 50) ends(0, i) = 0;
  EXPECT_EQ(qualityOf(points, ends).bridgedJunctions, 1) << "all along is one place";
  for (Eigen::Index i = 0; i < ends.cols(); ++i)
    if (points(2, i) > 58 && points(2, i) < 66) ends(0, i) = points(0, i);
  EXPECT_EQ(qualityOf(points, ends).bridgedJunctions, 2);
}

TEST(ContractionQuality, TakesNoForkForABridge) {
  const Eigen::Matrix3Xf points =
      test::both(line({0, 0, 0}, {0, 0, 40}),
                 test::both(line({0, 0, 40}, {30, 0, 70}), line({0, 0, 40}, {-30, 0, 70})));
  EXPECT_EQ(qualityOf(points, contractedToBallMeans(points, 5)).bridgedJunctions, 0);
}

TEST(ContractionQuality, CountsTipsThatWereEaten) {
  const Eigen::Matrix3Xf points = twoTwigs();
  Eigen::Matrix3Xf eaten = points;
  for (Eigen::Index i = 0; i < eaten.cols(); ++i)
    if (eaten(0, i) > 0) eaten(2, i) = std::min(eaten(2, i), 60.0F);
  const ContractionQuality quality = qualityOf(points, eaten);
  EXPECT_EQ(quality.tips, 2);
  EXPECT_EQ(quality.lostTips, 1);
  for (Eigen::Index i = 0; i < eaten.cols(); ++i)
    eaten(2, i) = std::min(points(2, i), 68.0F);
  EXPECT_EQ(qualityOf(points, eaten).lostTips, 0) << "4 spacings are less than half of a spur";
}

TEST(ContractionQuality, DoesNotCountWhatIsShorterThanASpurAsATip) {
  const Eigen::Matrix3Xf stem = line({0, 0, 0}, {0, 0, 100});
  const Eigen::Matrix3Xf spur = test::both(stem, line({1, 0, 50}, {12, 0, 50}));
  EXPECT_EQ(qualityOf(spur, spur).tips, 1);
  const Eigen::Matrix3Xf twig = test::both(stem, line({1, 0, 50}, {25, 0, 50}));
  EXPECT_EQ(qualityOf(twig, twig).tips, 2);
}

TEST(ContractionQuality, LeavesOutDust) {
  const Eigen::Matrix3Xf stem = line({0, 0, 0}, {0, 0, 100});
  const Eigen::Matrix3Xf points = test::both(stem, line({40, 0, 0}, {43, 0, 0}));
  const ContractionQuality quality = qualityOf(points, points);
  EXPECT_EQ(quality.tips, 1);
  EXPECT_EQ(quality.shareOnLine, 1);
  EXPECT_TRUE(std::isnan(quality.residuals.back()));
}

TEST(ContractionQuality, JudgesASkeleton) {
  const Eigen::Matrix3Xf points = twoTwigs();
  Skeleton skeleton;
  const Eigen::Vector3d origin(100, 200, 300);
  const NodeId root = skeleton.add({.position = origin});
  const NodeId fork = skeleton.add({.position = origin + Eigen::Vector3d(0, 0, 6), .parent = root});
  const NodeId arm = skeleton.add({.position = origin + Eigen::Vector3d(6, 0, 12), .parent = fork});
  (void)skeleton.add({.position = origin + Eigen::Vector3d(6, 0, 72), .parent = arm});
  const ContractionQuality quality =
      contractionQuality(points, points, skeleton, origin,
                         {.spacing = 1, .root = Eigen::Vector3f(Eigen::Vector3f::Zero())});
  EXPECT_NEAR(quality.skeletonLength, 6 + std::sqrt(72.0) + 60, 1e-9);
  EXPECT_EQ(quality.nodes, 4);
  EXPECT_EQ(quality.tips, 2);
  EXPECT_EQ(quality.lostTips, 1) << "it has one of the twigs";
  EXPECT_NEAR(static_cast<double>(quality.unexplainedPoints), 67, 3)
      << "of the other, all but what is within 3 of the first";
}

TEST(ContractionQuality, TakesPointsOfAnyKind) {
  const Eigen::Matrix3Xf none(3, 0);
  EXPECT_EQ(qualityOf(none, none).tips, 0);
  const Eigen::Matrix3Xf one = Eigen::Matrix3Xf::Ones(3, 1);
  EXPECT_EQ(qualityOf(one, one).tips, 0);
  const Eigen::Matrix3Xf same = Eigen::Matrix3Xf::Ones(3, 100);
  EXPECT_EQ(qualityOf(same, same).residualThickness, 0);
  const Eigen::Matrix3Xf points = twoTwigs();
  const Eigen::Matrix3Xf shrunk = Eigen::Matrix3Xf::Zero(3, points.cols());
  EXPECT_EQ(qualityOf(points, shrunk).shareOnLine, 0) << "a point is no line";
  EXPECT_EQ(qualityOf(points, shrunk).lostTips, 2);
  EXPECT_EQ(contractionQuality(points, points, Skeleton(), {0, 0, 0}, {.spacing = 1}).lostTips,
            contractionQuality(points, points, {.spacing = 1}).tips)
      << "a skeleton without nodes has no tips";
}

TEST(ContractionQuality, KnowsNoUnit) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const auto inUnits = [&](float unit) {
    const Eigen::Matrix3Xf scaled = unit * points;
    return contractionQuality(scaled, contractedToBallMeans(scaled, 0.1 * unit),
                              {.spacing = 0.015 * static_cast<double>(unit)});
  };
  const ContractionQuality meters = inUnits(1);
  const ContractionQuality other = inUnits(1024); // exact in binary
  EXPECT_NEAR(meters.residualThickness, other.residualThickness, 1e-3);
  EXPECT_EQ(meters.tips, other.tips);
}

TEST(ContractionQuality, IsTheSameOnAnyNumberOfThreadsAndStopsWhenAsked) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const ContractionQualityOptions options{.spacing = 0.015};
  const ContractionQuality onMany = contractionQuality(points, points, options);
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)contractionQuality(points, points, options, progress);
  }));
  const ThreadLimit limit(1);
  const ContractionQuality onOne = contractionQuality(points, points, options);
  EXPECT_EQ(onMany.residualThickness, onOne.residualThickness);
  EXPECT_EQ(onMany.residuals, onOne.residuals);
  EXPECT_EQ(onMany.thicknesses, onOne.thicknesses);
}

} // namespace
} // namespace espalier
