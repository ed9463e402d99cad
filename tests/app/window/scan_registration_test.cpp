#include "app/window/align/scan_registration.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

const Eigen::Isometry3d shift(Eigen::Translation3d(1, 2, 3));

/// Targets that the moved scan shows where the shift has yet to bring them; the last one is off.
ScanRegistration withPairs(std::size_t count, double off = 0) {
  const std::vector<Vector3d> places = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  ScanRegistration registration;
  for (std::size_t i = 0; i < count; ++i) {
    registration.addFixed(shift * places[i]);
    registration.addMoved(places[i] + Vector3d(0, 0, i == 3 ? off : 0));
  }
  return registration;
}

TEST(ScanRegistration, HasAMotionFromThreePairsOn) {
  EXPECT_FALSE(withPairs(2).isPlaced());
  EXPECT_TRUE(withPairs(2).residuals().empty());
  const ScanRegistration three = withPairs(3);
  ASSERT_TRUE(three.isPlaced());
  EXPECT_LT((three.motion().matrix() - shift.matrix()).norm(), 1e-9);
  EXPECT_LT(three.rms(), 1e-9);
}

TEST(ScanRegistration, NamesTheWorstOfFourPairs) {
  EXPECT_FALSE(withPairs(3).worst());
  const ScanRegistration four = withPairs(4, 1);
  EXPECT_EQ(four.worst(), 3U);
  EXPECT_GT(four.residuals()[3], four.rms());
}

TEST(ScanRegistration, TakesBackAPlaceThenPairs) {
  ScanRegistration registration = withPairs(3);
  registration.addFixed({9, 9, 9});
  EXPECT_FALSE(registration.wantsFixed());
  registration.removeLast();
  EXPECT_TRUE(registration.wantsFixed());
  EXPECT_TRUE(registration.isPlaced());
  registration.removeLast();
  EXPECT_EQ(registration.pairs().size(), 2U);
  EXPECT_FALSE(registration.isPlaced());
}

TEST(ScanRegistration, SaysWhyPairsOnALineGiveNoMotion) {
  ScanRegistration registration;
  for (int i = 0; i < 3; ++i) {
    registration.addFixed(Vector3d(i, 0, 0));
    registration.addMoved(Vector3d(i, 0, 0));
  }
  EXPECT_FALSE(registration.isPlaced());
  EXPECT_FALSE(registration.refusal().empty());
  registration.removeLast();
  EXPECT_TRUE(registration.refusal().empty());
}

TEST(ScanRegistration, KeepsAFitByPointsUntilPairsSayOtherwise) {
  ScanRegistration registration = withPairs(2);
  CloudFit fit;
  fit.motion = Eigen::Translation3d(0, 0, 9);
  registration.setFit(fit);
  EXPECT_EQ(registration.motion().translation().z(), 9);
  EXPECT_EQ(registration.residuals().size(), 2U);
  registration.addFixed(shift * Vector3d(0, 4, 0));
  registration.addMoved({0, 4, 0});
  EXPECT_LT((registration.motion().matrix() - shift.matrix()).norm(), 1e-9);
  EXPECT_FALSE(registration.byPoints());
}

TEST(ScanRegistration, TakesBackAFitByPointsInItsTurn) {
  ScanRegistration registration = withPairs(3);
  ASSERT_TRUE(registration.rmsByPairs());
  CloudFit fit;
  fit.motion = Eigen::Translation3d(0, 0, 9);
  registration.setFit(fit);
  EXPECT_GT(registration.rms(), 1);
  EXPECT_LT(*registration.rmsByPairs(), 1e-9);
  registration.addFixed({9, 9, 9});
  registration.removeLast(); // the place that came after it
  EXPECT_TRUE(registration.byPoints());
  registration.removeLast();
  EXPECT_FALSE(registration.byPoints());
  EXPECT_EQ(registration.pairs().size(), 3U);
  EXPECT_LT(registration.rms(), 1e-9);

  ScanRegistration early; // before any pair
  early.setFit(fit);
  early.addFixed({0, 0, 0});
  early.addMoved({0, 0, 0});
  early.removeLast();
  EXPECT_TRUE(early.byPoints());
  early.removeLast();
  EXPECT_FALSE(early.hasWork());
}

TEST(ScanRegistration, GoesBackToWhereTheScanLayAtFirst) {
  ScanRegistration registration(shift);
  registration.setFit({});
  EXPECT_TRUE(registration.hasWork());
  registration.reset();
  EXPECT_FALSE(registration.hasWork());
  EXPECT_EQ(registration.motion().matrix(), shift.matrix());
}

} // namespace
} // namespace espalier
