#include "core/evaluate/score_table.h"

#include <algorithm>
#include <cassert>

namespace espalier {

const Measure* measureOf(std::string_view name) {
  const auto found = std::ranges::find(measures(), name, &Measure::name);
  assert(found != measures().end());
  return &*found;
}

const std::vector<Score>& scores() {
  static const std::vector<Score> all = [] {
    std::vector<Score> joined;
    const auto add = [&](ScoreGroup group, const std::vector<Score>& some) {
      for (const Score& score : some) {
        joined.push_back(score);
        joined.back().group = group;
        if (score.symbol.empty()) joined.back().symbol = score.label;
      }
    };
    add(ScoreGroup::segments, segmentScores());
    add(ScoreGroup::capped, cappedSegmentScores());
    add(ScoreGroup::nearness, nearnessScores());
    add(ScoreGroup::landmarks, landmarkScores());
    add(ScoreGroup::architecture, architectureScores());
    add(ScoreGroup::network, networkScores());
    add(ScoreGroup::nearness, distanceScores());
    add(ScoreGroup::radii, radiusScores());
    add(ScoreGroup::edits, editScores());
    add(ScoreGroup::files, fileScores());
    return joined;
  }();
  return all;
}

} // namespace espalier
