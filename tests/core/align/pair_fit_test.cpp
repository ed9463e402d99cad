#include "core/align/pair_fit.h"
#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <string>

namespace espalier {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::HasSubstr;

const std::vector<Vector3d> corners = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1.5}};

Isometry3d someMotion() {
  return Eigen::Translation3d(0.3, -2, 5) *
         Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()) * Isometry3d::Identity();
}

std::vector<TargetPair> pairsUnder(const Isometry3d& motion, const std::vector<Vector3d>& places) {
  std::vector<TargetPair> pairs;
  for (const Vector3d& place : places)
    pairs.push_back({.moved = place, .fixed = motion * place});
  return pairs;
}

std::string refusalOf(const std::vector<TargetPair>& pairs) {
  try {
    static_cast<void>(fitPairs(pairs));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(PairFit, FindsTheMotionOfExactPairs) {
  const PairFit fit = fitPairs(pairsUnder(someMotion(), corners));
  EXPECT_TRUE(fit.motion.isApprox(someMotion(), 1e-12));
  EXPECT_EQ(fit.residuals.size(), 4U);
  EXPECT_LT(fit.rms, 1e-12);
}

TEST(PairFit, NeedsNoMoreThanThreePairs) {
  const std::vector<Vector3d> three(corners.begin(), corners.begin() + 3);
  EXPECT_TRUE(fitPairs(pairsUnder(someMotion(), three)).motion.isApprox(someMotion(), 1e-12));
}

// Two targets 2 apart are measured 2.2 apart: 0.1 remains at either, none at one between them.
TEST(PairFit, SharesOutWhatDoesNotFit) {
  std::vector<TargetPair> pairs =
      pairsUnder(Isometry3d::Identity(), {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  pairs[0].fixed.x() = -1.1;
  pairs[1].fixed.x() = 1.1;
  const PairFit fit = fitPairs(pairs);
  EXPECT_TRUE(fit.motion.isApprox(Isometry3d::Identity(), 1e-12));
  EXPECT_NEAR(fit.residuals[0], 0.1, 1e-12);
  EXPECT_NEAR(fit.residuals[1], 0.1, 1e-12);
  EXPECT_NEAR(fit.residuals[2], 0, 1e-12);
  EXPECT_NEAR(fit.rms, std::sqrt(0.02 / 3), 1e-12);
}

TEST(PairFit, MakesNoMirrorImage) {
  std::vector<TargetPair> pairs = pairsUnder(Isometry3d::Identity(), corners);
  for (TargetPair& pair : pairs)
    pair.fixed.x() *= -1;
  EXPECT_NEAR(fitPairs(pairs).motion.linear().determinant(), 1, 1e-12);
}

TEST(PairFit, KeepsMillimetersInCoordinatesOfMaps) {
  std::vector<Vector3d> far = corners;
  for (Vector3d& place : far)
    place += Vector3d(500'000, 5'400'000, 300);
  const PairFit fit = fitPairs(pairsUnder(Isometry3d::Identity(), far));
  for (const Vector3d& place : far)
    EXPECT_LT((fit.motion * place - place).norm(), 1e-6);
  EXPECT_LT(fit.rms, 1e-9);
}

TEST(PairFit, FollowsUnitAndFrame) {
  std::vector<TargetPair> rough = pairsUnder(someMotion(), corners);
  rough[2].fixed += Vector3d(0.05, 0.02, -0.04);
  const PairFit before = fitPairs(rough);
  const Isometry3d turn = someMotion().inverse() * Eigen::Translation3d(7, 8, 9);
  for (TargetPair& pair : rough) {
    pair.moved = 1000 * pair.moved;
    pair.fixed = turn * Vector3d(1000 * pair.fixed);
  }
  const PairFit after = fitPairs(rough);
  for (std::size_t i = 0; i < rough.size(); ++i)
    EXPECT_NEAR(after.residuals[i], 1000 * before.residuals[i], 1e-6);
  Isometry3d expected = before.motion;
  expected.translation() *= 1000;
  EXPECT_TRUE(after.motion.isApprox(turn * expected, 1e-9));
}

TEST(PairFit, RefusesWhatLeavesTheMotionOpen) {
  const auto refusal = [](const std::vector<Vector3d>& places) {
    return refusalOf(pairsUnder(someMotion(), places));
  };
  EXPECT_THAT(refusal({}), HasSubstr("0 pairs of targets leave open"));
  EXPECT_THAT(refusal({corners[0], corners[1]}), HasSubstr("2 pairs"));
  EXPECT_THAT(refusal({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), HasSubstr("at one place"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), HasSubstr("on a line"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0.001}, {3, 0, 0}}), HasSubstr("on a line"));
}

TEST(PairFit, RefusesWhatIsNoPair) {
  std::vector<TargetPair> pairs = pairsUnder(someMotion(), corners);
  pairs[1].fixed.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusalOf(pairs), HasSubstr("pair 2: a coordinate is no number"));
  pairs = pairsUnder(someMotion(), corners);
  for (TargetPair& pair : pairs)
    pair.fixed *= 1000;
  EXPECT_THAT(refusalOf(pairs), HasSubstr("in one unit"));
  pairs = pairsUnder(someMotion(), corners);
  for (TargetPair& pair : pairs)
    pair.fixed = {pair.fixed.x(), 0, 0};
  EXPECT_THAT(refusalOf(pairs), HasSubstr("of the fixed scan lie on a line"));
}

TEST(DistancesApart, AreThoseUnderTheMotion) {
  const std::vector<TargetPair> pairs = {{{1, 0, 0}, {1, 0, 2}}, {{0, 2, 0}, {0, 2, 5}}};
  Eigen::Isometry3d up = Eigen::Isometry3d::Identity();
  up.translation() = Eigen::Vector3d(0, 0, 1);
  EXPECT_EQ(distancesApart(pairs, up), (std::vector<double>{1, 4}));
  EXPECT_DOUBLE_EQ(rmsOf({1, 7}), 5);
  EXPECT_EQ(rmsOf({}), 0);
}

TEST(TookTargetsApart, IsSaidOfWhatPairsHadCloserAndPointsShow) {
  EXPECT_TRUE(tookTargetsApart(0.02, 1e-15, 0.005));
  EXPECT_FALSE(tookTargetsApart(0.004, 1e-15, 0.005)) << "within the spacing";
  EXPECT_FALSE(tookTargetsApart(0.02, 0.01, 0.005)) << "the pairs were rough";
}

} // namespace
} // namespace espalier
