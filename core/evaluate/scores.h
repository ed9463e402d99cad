#pragma once

#include "core/evaluate/match/segment_shares.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

class ComparedPlants;

enum class ScoreUnit : std::uint8_t { share, length, count, degrees };

/// Which side of a score is the good one.
enum class Better : std::uint8_t { less, more, neither };

/// What scores are shown together.
enum class ScoreGroup : std::uint8_t {
  nearness,
  segments,
  capped,
  landmarks,
  network,
  architecture,
  edits,
  radii,
  files // of the two as they were given; in no group where there are titles
};

/// Where a score is shown. Those of `everywhere` show any number of scores, the others a choice.
enum ScoreUse : unsigned {
  inPanel = 1,
  inMethods = 2, // the table of methods
  inStudies = 4, // files of the noise study and of sweeps
  inReport = 8,  // tables of the report; there are others for scores that take a distance
  inText = 16,   // `evaluate` prints a line of its own; off for those in its sentences
  everywhere = inPanel | inMethods | inStudies | inReport | inText,
  inNoiseText = 32,   // what `noise` prints unless asked for others
  inRankingText = 64, // what a ranking prints beside the score that it ranks by
  inBrief = 128,      // a few numbers of many plants: `batch`, `sweep`, preview in numbers
  inKeyNumbers = 256, // large, at the top of a report
  onCards = 512       // of a sweep in the window
};

/// A way to compare that scores come from, as a report explains it.
struct Measure {
  std::string name;
  std::string text; // in two lines; empty: the helps of its scores say all
  std::string source;
  ScoreGroup group; // which scores it is explained with
};

/// A number that says how a plant agrees with its reference: all that is known of it.
struct Score {
  std::string key;                  // everywhere the same: in files, projects and flags
  std::string label;                // under the title of its group; small letters first
  std::string symbol = {};          // short, by itself: heads of columns, rows of the panel
  std::string help;                 // what it is, in a line
  ScoreGroup group = {};            // of the list that it stands in
  const Measure* measure = nullptr; // with the source
  ScoreUnit unit = ScoreUnit::share;
  Better better = Better::more;
  unsigned uses = everywhere;
  /// None: it cannot be computed for these two.
  std::function<std::optional<double>(ComparedPlants&)> compute = {};
  bool takesDistance = false; // what is near counts: tables show it at several distances
  /// From sums over the segments of the reference, which can be drawn again; null: it is no such.
  std::function<double(const ShareSums&)> ofShares = {};
};

/// All of them, in the order of files. To add one is to add it there.
[[nodiscard]] const std::vector<Score>& scores();
[[nodiscard]] const std::vector<Measure>& measures();

/// The score that others follow: plants are ranked by it unless it is said otherwise.
inline constexpr std::string_view leadingScore = "f";

/// pre: there is one of this key
[[nodiscard]] const Score& scoreOf(std::string_view key);

using ScoreList = std::vector<const Score*>;
[[nodiscard]] ScoreList scoresIn(ScoreUse use);         // in the order of files
[[nodiscard]] ScoreList rankedScores();                 // those with `ofShares`, likewise
[[nodiscard]] ScoreList scoresByDistance();             // those with `takesDistance`, by groups
[[nodiscard]] ScoreList leadingFirst(ScoreList scores); // then by groups: as people read them
[[nodiscard]] std::vector<std::string> keysOf(const ScoreList& scores);

using ScoreValues = std::map<std::string, std::optional<double>>; // by key; none: not known

[[nodiscard]] ScoreValues valuesOf(const ScoreList& scores, ComparedPlants& plants);

} // namespace espalier
