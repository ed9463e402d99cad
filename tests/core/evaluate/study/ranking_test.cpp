#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/study/perturbation.h"
#include "core/evaluate/study/ranking.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <stop_token>

namespace espalier {
namespace {

using testing::HasSubstr;

std::vector<Skeleton> threeResults() {
  return {test::jittered(test::bush(), 0.1), test::bush(), test::jittered(test::bush(), 0.02)};
}

TEST(Ranking, PutsTheBestFirst) {
  const Ranking found =
      ranking(threeResults(), test::bush(), {.by = "capped_geometric", .distance = 0.15});
  ASSERT_EQ(found.results.size(), 3U);
  EXPECT_EQ(found.results[0].result, 1U);
  EXPECT_EQ(found.results[1].result, 2U);
  EXPECT_EQ(found.results[2].result, 0U);
  EXPECT_GT(*found.results[1].aboveNext, 0.99);
  EXPECT_FALSE(found.results[2].aboveNext);
}

TEST(Ranking, HasTheScoresOfTheWholePlant) {
  const Skeleton result = threeResults()[0];
  const ScoreOptions lengths{.distance = 0.15};
  const auto scores = studyScores(result, test::bush(), lengths);
  const Ranking found =
      ranking({result}, test::bush(), {.registers = false, .distance = 0.15, .draws = 10});
  EXPECT_EQ(found.results[0].scores.size(), 8U);
  for (const auto& [key, score] : found.results[0].scores)
    EXPECT_NEAR(score.value, scores.at(key), 1e-9) << key;
}

TEST(Ranking, OfTheReferenceItselfIsSure) {
  const Ranking found = ranking({test::bush()}, test::bush());
  for (const auto& [key, score] : found.results[0].scores) {
    EXPECT_NEAR(score.value, 1, 1e-9);
    EXPECT_NEAR(score.low, 1, 1e-9);
    EXPECT_NEAR(score.high, 1, 1e-9);
  }
}

// Of a hundred equal sticks side by side sixty are found: the number found in a draw is binomial,
// and 1.96 of its deviations, sqrt(0.6 * 0.4 / 100), are 0.096.
TEST(Ranking, HasTheIntervalOfABinomialWhereSegmentsAreFoundOrNot) {
  const auto sticks = [](int count) {
    Skeleton plant;
    for (int i = 0; i < count; ++i) {
      const NodeId foot = plant.add({.position = {10.0 * i, 0, 0}});
      plant.add({.position = {10.0 * i, 0, 1}, .parent = foot});
    }
    return plant;
  };
  const Ranking found =
      ranking({sticks(60)}, sticks(100), {.registers = false, .by = "recall", .draws = 4000});
  const ScoreInterval recall = found.results[0].scores.at("recall");
  EXPECT_NEAR(recall.value, 0.6, 1e-9);
  EXPECT_NEAR(recall.low, 0.6 - 0.096, 0.012);
  EXPECT_NEAR(recall.high, 0.6 + 0.096, 0.012);
}

TEST(Ranking, OfTwoEqualResultsIsTheOrderGivenAndUndecided) {
  const Skeleton result = threeResults()[0];
  const Ranking found = ranking({result, result}, test::bush(), {.draws = 50});
  EXPECT_EQ(found.results[0].result, 0U);
  EXPECT_EQ(*found.results[0].aboveNext, 0.5);
}

TEST(Ranking, ReturnsTheShiftOfEachResult) {
  const Ranking found =
      ranking({test::shifted(test::bush(), {0.5, 0, 0})}, test::bush(), {.draws = 10});
  EXPECT_NEAR(found.results[0].registration->shift.x(), -0.5, 1e-4);
  EXPECT_GT(found.results[0].scores.at("f").value, 0.99);
}

TEST(Ranking, FollowsTheSeedOnAnyNumberOfThreads) {
  const std::vector<std::string> names = {"a", "b", "c"};
  const auto table = [&](std::uint64_t seed) {
    return toTable(ranking(threeResults(), test::bush(), {.draws = 100, .seed = seed}), names);
  };
  const auto many = table(1);
  EXPECT_NE(table(2), many);
  const ThreadLimit one(1);
  EXPECT_EQ(table(1), many);
}

TEST(Ranking, IsWrittenWithRanksAndNames) {
  const Ranking found = ranking(threeResults(), test::bush(), {.draws = 10});
  const std::vector<std::string> names = {"a", "b", "c"};
  const auto json = toJson(found, names);
  EXPECT_EQ(json["by"], "f");
  EXPECT_EQ(json["results"][0]["rank"], 1);
  EXPECT_EQ(json["results"][0]["result"], "b");
  EXPECT_NEAR(json["results"][0]["scores"]["f"]["value"].get<double>(), 1, 1e-9);
  EXPECT_TRUE(json["results"][2]["above_next"].is_null());
  const auto table = toTable(found, names);
  ASSERT_EQ(table.size(), 4U);
  for (const auto& row : table)
    EXPECT_EQ(row.size(), table.front().size());
  EXPECT_EQ(table[1][1], "b");
}

TEST(Ranking, RefusesAnEmptyResultByNumberAndStopsWhenAsked) {
  try {
    (void)ranking({test::bush(), {}}, test::bush());
    FAIL() << "ranked nothing";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("result 2 has no nodes"));
  }
  EXPECT_THROW((void)ranking({test::bush()}, {}), Error);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)ranking({test::bush()}, test::bush(), {}, Progress(source.get_token(), {})),
               Cancelled);
}

} // namespace
} // namespace espalier
