#include "core/evaluate/scores.h"

#include "core/evaluate/compared_plants.h"

#include <algorithm>
#include <cassert>

namespace espalier {
namespace {

template <class Test> ScoreList where(const Test& test) {
  ScoreList found;
  for (const Score& score : scores())
    if (test(score)) found.push_back(&score);
  return found;
}

ScoreList byGroups(ScoreList scores) {
  std::ranges::stable_sort(scores, {}, &Score::group);
  return scores;
}

} // namespace

const Score& scoreOf(std::string_view key) {
  const auto found = std::ranges::find(scores(), key, &Score::key);
  assert(found != scores().end());
  return *found;
}

ScoreList scoresIn(ScoreUse use) {
  return where([use](const Score& score) { return (score.uses & use) != 0; });
}

ScoreList rankedScores() {
  return where([](const Score& score) { return score.ofShares != nullptr; });
}

ScoreList scoresByDistance() {
  return byGroups(where([](const Score& score) { return score.takesDistance; }));
}

ScoreList leadingFirst(ScoreList scores) {
  scores = byGroups(std::move(scores));
  std::ranges::stable_partition(scores,
                                [](const Score* score) { return score->key == leadingScore; });
  return scores;
}

std::vector<std::string> keysOf(const ScoreList& scores) {
  std::vector<std::string> keys;
  for (const Score* score : scores)
    keys.push_back(score->key);
  return keys;
}

ScoreValues valuesOf(const ScoreList& scores, ComparedPlants& plants) {
  ScoreValues values;
  for (const Score* score : scores)
    values[score->key] = score->compute(plants);
  return values;
}

} // namespace espalier
