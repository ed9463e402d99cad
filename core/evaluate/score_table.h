#pragma once

#include "core/evaluate/scores.h"

#include <string_view>
#include <vector>

namespace espalier {

// The table of scores by its lists, each in one source; scores() joins them.
// A score is one entry of a list. Where its symbol is left out, it is its label.

inline constexpr unsigned inWindow = inPanel | inMethods;

[[nodiscard]] const Measure* measureOf(std::string_view name); // pre: there is one

// core/evaluate/segment_scores.cpp
[[nodiscard]] std::vector<Score> segmentScores();
[[nodiscard]] std::vector<Score> cappedSegmentScores();
[[nodiscard]] std::vector<Score> nearnessScores();
[[nodiscard]] std::vector<Score> distanceScores();

// core/evaluate/structure_scores.cpp
[[nodiscard]] std::vector<Score> landmarkScores();
[[nodiscard]] std::vector<Score> architectureScores();
[[nodiscard]] std::vector<Score> networkScores();
[[nodiscard]] std::vector<Score> editScores();

// core/evaluate/radius_scores.cpp
[[nodiscard]] std::vector<Score> radiusScores();
[[nodiscard]] std::vector<Score> fileScores(); // of the two as they were given

} // namespace espalier
