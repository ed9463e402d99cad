#include "core/decide/error_reasons.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

using Kind = ErrorReason::Kind;

/// A piece of a branch as it usually is.
ErrorEvidence usualPiece() {
  return {.length = 20,
          .whole = 40,
          .carried = 20,
          .points = 200,
          .scatter = 0.3,
          .unexplained = 0,
          .beside = 15,
          .radius = 1.5,
          .turn = 0.98};
}

Kind strongest(const ErrorEvidence& evidence) {
  const std::vector<ErrorReason> reasons = reasonsFor(evidence);
  EXPECT_FALSE(reasons.empty());
  return reasons.empty() ? Kind::extent : reasons.front().kind;
}

TEST(ErrorReasons, NameWhatIsUnlikeUsualWood) {
  ErrorEvidence inAir = usualPiece();
  inAir.inAir = 0.8;
  EXPECT_EQ(strongest(inAir), Kind::inAir);
  ErrorEvidence scattered = usualPiece();
  scattered.scatter = 2.5;
  EXPECT_EQ(strongest(scattered), Kind::scatter);
  ErrorEvidence gap = usualPiece();
  gap.gap = 0.4;
  EXPECT_EQ(strongest(gap), Kind::gap);
}

TEST(ErrorReasons, AreWeakWhereAPieceIsAsUsual) {
  const std::vector<ErrorReason> reasons = reasonsFor(usualPiece());
  EXPECT_TRUE(
      std::ranges::all_of(reasons, [](const ErrorReason& each) { return each.effect < 1; }));
}

TEST(ErrorReasons, AreInTheOrderOfTheirEffect) {
  ErrorEvidence bad = usualPiece();
  bad.inAir = 0.8;
  bad.scatter = 2.5;
  bad.gap = 0.2;
  const std::vector<ErrorReason> reasons = reasonsFor(bad);
  ASSERT_GE(reasons.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(reasons, std::greater<>(), &ErrorReason::effect));
}

TEST(ErrorReasons, AddUpToTheOddsOverUsualWood) {
  ErrorEvidence bad = usualPiece();
  bad.inAir = 0.8;
  const double odds = fittedErrorOdds().value(featuresOf(bad));
  ErrorEvidence good = bad;
  good.inAir = usualFeatures()[6];
  const std::vector<ErrorReason> reasons = reasonsFor(bad);
  const auto inAir = std::ranges::find(reasons, Kind::inAir, &ErrorReason::kind);
  ASSERT_NE(inAir, reasons.end());
  EXPECT_NEAR(inAir->effect, odds - fittedErrorOdds().value(featuresOf(good)), 1e-12);
}

} // namespace
} // namespace espalier
