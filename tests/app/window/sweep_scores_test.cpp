#include "app/window/sweep_scores.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

Judgment judgment(double thickness, Eigen::Index lost, Eigen::Index webbed) {
  ContractionQuality quality;
  quality.residualThickness = thickness;
  quality.tips = 1093;
  quality.lostTips = lost;
  quality.webbedJunctions = webbed;
  return {.quality = std::make_shared<const ContractionQuality>(quality), .scores = std::nullopt};
}

TEST(SweepScores, MarkTheBestUnlessHalfOfTheValuesShareIt) {
  const auto scores = sweepScores({judgment(3, 7, 0), judgment(2, 9, 0), judgment(1, 9, 4)});
  ASSERT_EQ(scores.size(), 3U);
  EXPECT_EQ(scores[0][0].name, "Residual");
  EXPECT_FALSE(scores[0][0].isBest);
  EXPECT_TRUE(scores[2][0].isBest);
  EXPECT_EQ(scores[0][1].text, QString::fromUtf8("7 of 1\u202f093"));
  EXPECT_TRUE(scores[0][1].isBest);
  EXPECT_FALSE(scores[1][1].isBest);
  for (const auto& each : scores)
    EXPECT_FALSE(each[2].isBest) << "two of three are webbed nowhere";
}

TEST(SweepScores, TellNothingOfWhatIsNotKnown) {
  const auto scores = sweepScores({Judgment(), judgment(1, 2, 3)});
  EXPECT_TRUE(scores[0].empty());
  EXPECT_EQ(scores[1].size(), 4U) << "there is no reference";
}

} // namespace
} // namespace espalier
