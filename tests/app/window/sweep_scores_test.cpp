#include "app/window/preview/sweep_scores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace espalier {
namespace {

Judgment judgment(double thickness, Eigen::Index lost, Eigen::Index webbed) {
  ContractionQuality quality;
  quality.residualThickness = thickness;
  quality.shareOnLine = 0.5;
  quality.tips = 1093;
  quality.lostTips = lost;
  quality.bridgedJunctions = webbed;
  quality.nodes = 5;
  return {.quality = std::make_shared<const ContractionQuality>(quality), .scores = std::nullopt};
}

Judgment scored(double f) {
  Judgment judged = judgment(1, 2, 3);
  judged.scores = ScoreValues();
  for (const Score& score : scores())
    (*judged.scores)[score.key] = std::nullopt;
  (*judged.scores)["f"] = f;
  return judged;
}

const SweepScore& named(const std::vector<SweepScore>& scores, const QString& name) {
  return *std::ranges::find(scores, name, &SweepScore::name);
}

TEST(SweepScores, MarkTheBestUnlessHalfOfTheValuesShareIt) {
  const auto scores = sweepScores({judgment(3, 9, 0), judgment(1, 7, 0), judgment(2, 9, 4)});
  ASSERT_EQ(scores.size(), 3U);
  EXPECT_FALSE(named(scores[0], "Thickness").isBest);
  EXPECT_TRUE(named(scores[1], "Thickness").isBest);
  EXPECT_EQ(named(scores[1], "Lost ends").text, QString::fromUtf8("7 of 1\u202f093"));
  EXPECT_TRUE(named(scores[1], "Lost ends").isBest);
  EXPECT_FALSE(named(scores[0], "Lost ends").isBest);
  EXPECT_EQ(named(scores[0], "On a line").text, QString::fromUtf8("50.0\u202f%"));
  for (const auto& each : scores)
    EXPECT_FALSE(named(each, "Bridged").isBest) << "two of three are bridged nowhere";
}

// Wider means thinner: that the widest is thinnest does not make it the best.
TEST(SweepScores, CrownNoEndByANumberThatLeadsThereByItself) {
  const auto scores = sweepScores({judgment(3, 7, 0), judgment(2, 9, 0), judgment(1, 9, 4)});
  for (const auto& each : scores) {
    EXPECT_FALSE(named(each, "Thickness").isBest);
    EXPECT_FALSE(named(each, "Lost ends").isBest);
  }
  EXPECT_TRUE(named(scores[2], "Thickness").tip.contains("No star"));
  EXPECT_TRUE(named(scores[2], "Thickness").tip.contains("[spacings]"));
  EXPECT_FALSE(named(scores[2], "Bridged").tip.contains("No star")) << "no best to begin with";
}

TEST(SweepScores, CrownAnEndThatAgreesBestWithTheReference) {
  const auto scores = sweepScores({scored(0.5), scored(0.6), scored(0.7)});
  EXPECT_TRUE(named(scores[2], "F").isBest);
  EXPECT_EQ(named(scores[2], "F").text, "0.700");
}

TEST(SweepScores, SayNothingOfWhatIsNotKnown) {
  const auto scores = sweepScores({Judgment(), judgment(1, 2, 3)});
  EXPECT_TRUE(scores[0].empty());
  EXPECT_EQ(scores[1].size(), 5U) << "there is no reference";
}

} // namespace
} // namespace espalier
