#pragma once

#include "core/base/progress.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/scores.h"
#include "core/skeleton/skeleton.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

struct RankingOptions {
  bool registers = true; // lays each result on the reference first
  RegistrationOptions registration;
  std::string by = std::string(leadingScore); // the key of one of rankedScores()
  double distance = 0;                        // [L]; 0 = usualTolerance()
  std::size_t draws = 2000;                   // of the bootstrap, >= 1
  double confidence = 0.95;                   // of the intervals, in (0, 1)
  std::uint64_t seed = 1;
};

/// A score with the interval that the draws leave it in.
struct ScoreInterval {
  double value = 0; // of the plant as it is
  double low = 0;
  double high = 0;
};

struct RankedResult {
  std::size_t result = 0;                      // which of those given
  std::optional<Registration> registration;    // none if it was compared where it lay
  std::map<std::string, ScoreInterval> scores; // by key: rankedScores()
  std::optional<double> aboveNext; // share of draws in which it beats the next; none for the last
};

struct Ranking {
  std::string by;      // key of a score
  double distance = 0; // [L], as used
  std::size_t draws = 0;
  double confidence = 0;
  std::uint64_t seed = 0;
  std::vector<RankedResult> results; // the best first; equal ones in the order given
};

/// Ranks results by how well they agree with one reference, and states how sure that is.
///
/// The segments of the reference are drawn again with replacement, all results from the same draws:
/// each segment brings what is matched with it, and what of the result lies nearest to it. The
/// interval holds the middle share of the scores so found. It shows how much the ranking depends on
/// which segments this one plant happens to have, and nothing of other plants or experts.
///
/// @throws Error     if one has no nodes, no length, or a position that is no number; the message
///                   names a result by its number from 1
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time: registration and scores of each result, and draws * segments.
/// Source: B. Efron, "Bootstrap methods: another look at the jackknife", Annals of Statistics 7,
/// 1979; percentile intervals.
[[nodiscard]] Ranking ranking(const std::vector<Skeleton>& results, const Skeleton& reference,
                              const RankingOptions& options = {}, const Progress& progress = {});

/// Keys: by, distance, draws, confidence, seed, results[].{rank,result,shift,rotation,axis,
/// near_share,scores.KEY.{value,low,high},above_next}; `names` are what the results are called.
[[nodiscard]] nlohmann::ordered_json toJson(const Ranking& ranking,
                                            const std::vector<std::string>& names);

/// A table of fields, its first row the names of the columns: rank, result, and KEY, KEY_low and
/// KEY_high of each score, above_next.
[[nodiscard]] std::vector<std::vector<std::string>> toTable(const Ranking& ranking,
                                                            const std::vector<std::string>& names);

} // namespace espalier
