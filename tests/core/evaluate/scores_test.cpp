#include "core/evaluate/compared_plants.h"
#include "core/evaluate/comparison_json.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/manual.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

namespace espalier {
namespace {

/// With radii that fall with the height.
Skeleton thickBush() {
  Skeleton plant = test::bush();
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0.2 - 0.01 * plant[id].position.z());
  return plant;
}

TEST(Scores, HaveAKeyOfTheirOwnWordsAndASource) {
  std::set<std::string> keys;
  for (const Score& score : scores()) {
    EXPECT_TRUE(keys.insert(score.key).second) << score.key << " is there twice";
    EXPECT_EQ(score.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string::npos)
        << score.key;
    EXPECT_FALSE(score.label.empty() || score.symbol.empty() || score.help.empty()) << score.key;
    ASSERT_NE(score.measure, nullptr) << score.key;
    EXPECT_FALSE(score.measure->source.empty()) << score.key;
    EXPECT_NE(score.compute, nullptr) << score.key;
    EXPECT_EQ(&scoreOf(score.key), &score);
  }
}

TEST(Scores, OfAPlantWithItselfAreAsGoodAsTheyGet) {
  const Skeleton plant = thickBush();
  ComparedPlants plants(plant, plant);
  for (const Score& score : scores()) {
    const std::optional<double> value = score.compute(plants);
    if (!value || score.better == Better::neither) continue;
    EXPECT_NEAR(*value, score.better == Better::more ? 1 : 0, 1e-12) << score.key;
  }
}

TEST(Scores, OfAComparisonAreThoseOfPlantsComparedOnDemand) {
  const Skeleton plant = test::jittered(thickBush(), 0.05);
  const Skeleton reference = thickBush();
  const Comparison comparison = compare(plant, reference, {.registers = false});
  ComparedPlants plants(plant, reference);
  EXPECT_EQ(comparison.scores.size(), scores().size());
  for (auto score = scores().rbegin(); score != scores().rend(); ++score) // in any order
    EXPECT_EQ(comparison.scores.at(score->key), score->compute(plants)) << score->key;
  for (const auto& [key, value] : studyScores(plant, reference))
    EXPECT_EQ(comparison.scores.at(key).value_or(0), value) << key;
}

TEST(Scores, ThatTakeADistanceAreGivenAtEach) {
  const Skeleton reference = test::bush();
  const Comparison comparison =
      compare(test::jittered(reference, 0.05), reference,
              {.registers = false, .tolerance = {.distances = {0, 0.05, 0.2}}});
  ASSERT_EQ(comparison.scoresAt.size(), 3U);
  EXPECT_FALSE(comparison.scoresAt[0].values.at("capped_geometric")) << "nothing is capped at none";
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(comparison.scoresAt[k].values.at("f"), comparison.tolerance.scores[k].f());
  EXPECT_EQ(comparison.scoresAt[2].values.at("capped_geometric"), comparison.capped[1].geometric);
}

TEST(Scores, AreWrittenByTheirKeys) {
  const auto json = toJson(compare(test::bush(), test::bush()));
  EXPECT_EQ(json["scores"].size(), scores().size());
  for (const Score& score : scores())
    EXPECT_TRUE(json["scores"].contains(score.key)) << score.key;
  EXPECT_EQ(json["scores"]["structural"], json["authors"]["structural"]);
}

TEST(Scores, StandFirstAsTheLeadingOneThenByGroups) {
  const ScoreList all = leadingFirst(scoresIn(inPanel));
  EXPECT_EQ(all.front()->key, leadingScore);
  std::set<ScoreGroup> ended;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i]->group != all[i - 1]->group) ended.insert(all[i - 1]->group);
    EXPECT_FALSE(ended.contains(all[i]->group)) << all[i]->key << " is apart from its group";
  }
}

/// "F" of "f": how panels and the manual write it.
std::string titled(std::string text) {
  if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

// The manual has a row for each score, by groups: its symbol, key and help.
TEST(Scores, AreThoseOfTheManual) {
  std::istringstream manual(test::manualText());
  std::string line;
  while (std::getline(manual, line) && line != "| score | key | is |") {
  }
  ASSERT_TRUE(std::getline(manual, line)) << "the line under the head";
  ScoreList all;
  for (const Score& score : scores())
    all.push_back(&score);
  for (const Score* score : leadingFirst(all)) {
    std::getline(manual, line);
    EXPECT_EQ(line,
              "| " + titled(score->symbol) + " | `" + score->key + "` | " + score->help + " |");
  }
  std::getline(manual, line);
  EXPECT_EQ(line, "") << "the manual has more scores than there are";
}

} // namespace
} // namespace espalier
