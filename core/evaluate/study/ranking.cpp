#include "core/evaluate/study/ranking.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/shown.h"
#include "core/base/text.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segment_shares.h"
#include "core/evaluate/match/tolerance_curve.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace espalier {
namespace {

/// The middle share of the values.
ScoreInterval intervalOf(double value, std::vector<double> values, double confidence) {
  std::ranges::sort(values);
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * last))];
  };
  return {value, at((1 - confidence) / 2), at((1 + confidence) / 2)};
}

struct Candidate {
  RankedResult ranked;
  SegmentShares shares;
  std::map<std::string, std::vector<double>> drawn; // by key, in each draw
};

/// Draws the segments again and again, the same for all candidates.
void drawAll(std::vector<Candidate>& candidates, const RankingOptions& options,
             const Progress& progress) {
  const ScoreList scores = rankedScores();
  Random random(options.seed);
  const auto segments = static_cast<std::size_t>(candidates.front().shares.cols());
  for (std::size_t draw = 0; draw < options.draws; ++draw) {
    if (draw % 16 == 0)
      progress.update(static_cast<double>(draw) / static_cast<double>(options.draws));
    Eigen::VectorXd often = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(segments));
    for (std::size_t i = 0; i < segments; ++i)
      often(static_cast<Eigen::Index>(random.below(segments))) += 1;
    for (Candidate& candidate : candidates) {
      const ShareSums sums = candidate.shares * often;
      for (const Score* score : scores)
        candidate.drawn[score->key].push_back(score->ofShares(sums));
    }
  }
  for (Candidate& candidate : candidates) {
    const ShareSums plain = candidate.shares.rowwise().sum();
    for (const Score* score : scores)
      candidate.ranked.scores[score->key] =
          intervalOf(score->ofShares(plain), candidate.drawn[score->key], options.confidence);
  }
}

/// The shares of a result where it lies, or once it is laid on the reference.
Candidate candidateOf(const Skeleton& result, const Skeleton& reference,
                      const RankingOptions& options, double distance, const Progress& progress) {
  const double step = defaultTolerances(reference).front();
  Candidate candidate;
  if (!options.registers) {
    candidate.shares = segmentShares(result, reference, distance, step, progress);
    return candidate;
  }
  const Registration lay =
      registration(result, reference, options.registration, progress.part(0, 0.6));
  candidate.ranked.registration = lay;
  candidate.shares =
      segmentShares(moved(result, lay.motion), reference, distance, step, progress.part(0.6, 1));
  return candidate;
}

/// In how many of the draws the first is above the second; a tie counts half.
double shareAbove(const std::vector<double>& first, const std::vector<double>& second) {
  double above = 0;
  for (std::size_t k = 0; k < first.size(); ++k)
    above += first[k] > second[k] ? 1 : first[k] == second[k] ? 0.5 : 0;
  return above / static_cast<double>(first.size());
}

} // namespace

Ranking ranking(const std::vector<Skeleton>& results, const Skeleton& reference,
                const RankingOptions& options, const Progress& progress) {
  assert(options.draws >= 1 && scoreOf(options.by).ofShares != nullptr);
  requireComparable(reference, ComparedAs::reference);
  for (std::size_t i = 0; i < results.size(); ++i)
    requireComparable(results[i], "result " + std::to_string(i + 1));
  Ranking found{.by = options.by,
                .distance = options.distance > 0 ? options.distance : usualTolerance(reference),
                .draws = options.draws,
                .confidence = options.confidence,
                .seed = options.seed,
                .results = {}};
  if (results.empty()) return found;
  const auto all = static_cast<double>(results.size());
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto part = static_cast<double>(i);
    const Progress mine =
        progress.part(0.9 * part / all, 0.9 * (part + 1) / all, Shown::tr("Comparing results"));
    candidates.push_back(candidateOf(results[i], reference, options, found.distance, mine));
    candidates.back().ranked.result = i;
  }
  drawAll(candidates, options, progress.part(0.9, 1, Shown::tr("Drawing")));
  std::ranges::stable_sort(candidates, [&](const Candidate& a, const Candidate& b) {
    return a.ranked.scores.at(options.by).value > b.ranked.scores.at(options.by).value;
  });
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i + 1 < candidates.size())
      candidates[i].ranked.aboveNext =
          shareAbove(candidates[i].drawn[options.by], candidates[i + 1].drawn[options.by]);
    found.results.push_back(candidates[i].ranked);
  }
  return found;
}

nlohmann::ordered_json toJson(const Ranking& ranking, const std::vector<std::string>& names) {
  using Json = nlohmann::ordered_json;
  Json results = Json::array();
  for (const RankedResult& result : ranking.results) {
    Json scores = Json::object();
    for (const Score* score : rankedScores()) {
      const ScoreInterval& found = result.scores.at(score->key);
      scores[score->key] = {{"value", found.value}, {"low", found.low}, {"high", found.high}};
    }
    const Registration lay = result.registration.value_or(Registration());
    const auto listed = [](const Eigen::Vector3d& vector) {
      return Json::array({vector.x(), vector.y(), vector.z()});
    };
    results.push_back({{"rank", results.size() + 1},
                       {"result", names.at(result.result)},
                       {"shift", listed(lay.shift)},
                       {"rotation", lay.angle() * 180 / std::numbers::pi},
                       {"axis", lay.angle() > 0 ? listed(lay.axis()) : Json()},
                       {"near_share", result.registration ? Json(lay.near) : Json()},
                       {"scores", scores},
                       {"above_next", result.aboveNext ? Json(*result.aboveNext) : Json()}});
  }
  return {{"by", ranking.by},       {"distance", ranking.distance},
          {"draws", ranking.draws}, {"confidence", ranking.confidence},
          {"seed", ranking.seed},   {"results", results}};
}

std::vector<std::vector<std::string>> toTable(const Ranking& ranking,
                                              const std::vector<std::string>& names) {
  std::vector<std::vector<std::string>> rows = {{"rank", "result"}};
  for (const Score* score : rankedScores())
    for (const char* ending : {"", "_low", "_high"})
      rows.front().push_back(score->key + ending);
  rows.front().emplace_back("above_next");
  for (const RankedResult& result : ranking.results) {
    rows.push_back({std::to_string(rows.size()), names.at(result.result)});
    for (const Score* score : rankedScores()) {
      const ScoreInterval& found = result.scores.at(score->key);
      for (const double value : {found.value, found.low, found.high})
        rows.back().push_back(plainDecimal(value));
    }
    rows.back().push_back(result.aboveNext ? plainDecimal(*result.aboveNext) : "");
  }
  return rows;
}

} // namespace espalier
