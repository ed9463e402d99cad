#include "core/evaluate/study/noise_study.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/shown.h"
#include "core/base/text.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/registration/registration.h"

#include <nlohmann/json.hpp>

#include <cassert>
#include <cmath>
#include <span>

namespace espalier {
namespace {

using PlantScores = std::map<std::string, double>; // of one plant, by key

/// One plant to be made and scored.
struct Run {
  Perturbation kind;
  double level;
  std::uint64_t seed;
};

const PerturbationEntry& entryOf(Perturbation kind) {
  return perturbations()[static_cast<std::size_t>(kind)];
}

std::vector<NoiseSeries> wholeSeries(const std::vector<NoiseSeries>& asked) {
  std::vector<NoiseSeries> series = asked;
  if (series.empty())
    for (std::size_t i = 0; i < perturbations().size(); ++i)
      series.push_back({static_cast<Perturbation>(i), {}});
  for (NoiseSeries& each : series) {
    if (each.levels.empty()) each.levels = entryOf(each.kind).levels;
    for (const double level : each.levels)
      requireLevel(each.kind, level);
  }
  return series;
}

PlantScores scoresOf(const Run& run, const Skeleton& reference, const NoiseStudy& study,
                     const Progress& progress) {
  Skeleton plant = perturbed(reference, run.kind, run.level, run.seed);
  try {
    if (study.isRegistered)
      plant = moved(plant, registration(plant, reference, {.goodEnough = 0.5}, progress).motion);
    return studyScores(plant, reference, study.scores, progress);
  } catch (const Error&) {
    throw Error("level " + plainDecimal(run.level) + " of " + entryOf(run.kind).name +
                " leaves nothing to compare: choose a lower one");
  }
}

ScoreSpread spreadOf(const std::string& key, std::span<const PlantScores> runs) {
  const auto plants = static_cast<double>(runs.size());
  ScoreSpread spread;
  for (const PlantScores& scores : runs)
    spread.mean += scores.at(key) / plants;
  double squares = 0;
  for (const PlantScores& scores : runs)
    squares += std::pow(scores.at(key) - spread.mean, 2);
  if (runs.size() > 1) spread.deviation = std::sqrt(squares / (plants - 1));
  return spread;
}

NoisePoint pointOf(double level, std::span<const PlantScores> runs) {
  NoisePoint point{.level = level, .scores = {}};
  for (const Score* score : scoresIn(inStudies))
    point.scores[score->key] = spreadOf(score->key, runs);
  return point;
}

} // namespace

NoiseStudy noiseStudy(const Skeleton& reference, const NoiseOptions& options,
                      const Progress& progress) {
  assert(options.repeats >= 1);
  requireComparable(reference, ComparedAs::reference);
  NoiseStudy study{.repeats = options.repeats,
                   .seed = options.seed,
                   .isRegistered = options.registers,
                   .scores = resolved(options.scores, reference),
                   .curves = {}};
  const std::vector<NoiseSeries> series = wholeSeries(options.series);
  std::vector<Run> runs;
  for (const NoiseSeries& each : series)
    for (const double level : each.levels)
      for (std::size_t i = 0; i < options.repeats; ++i)
        runs.push_back({each.kind, level, options.seed + i});

  std::vector<PlantScores> scores(runs.size());
  const Progress whole = progress.part(0, 1, Shown::tr("Comparing plants"));
  const Progress stopOnly = whole.part(0, 0); // plants come at once: none knows how far all are
  parallelFor(
      static_cast<Eigen::Index>(runs.size()),
      [&](Eigen::Index i) {
        const auto run = static_cast<std::size_t>(i);
        scores[run] = scoresOf(runs[run], reference, study, stopOnly);
      },
      whole, 1);

  std::size_t next = 0;
  for (const NoiseSeries& each : series) {
    study.curves.push_back({each.kind, {}});
    for (const double level : each.levels) {
      study.curves.back().points.push_back(
          pointOf(level, std::span(scores).subspan(next, options.repeats)));
      next += options.repeats;
    }
  }
  return study;
}

nlohmann::ordered_json toJson(const NoiseStudy& study) {
  using Json = nlohmann::ordered_json;
  Json curves = Json::array();
  for (const NoiseCurve& curve : study.curves) {
    Json points = Json::array();
    for (const NoisePoint& point : curve.points) {
      Json scores = Json::object();
      for (const Score* score : scoresIn(inStudies)) {
        const ScoreSpread& spread = point.scores.at(score->key);
        scores[score->key] = {{"mean", spread.mean}, {"deviation", spread.deviation}};
      }
      points.push_back({{"level", point.level}, {"scores", scores}});
    }
    curves.push_back({{"kind", entryOf(curve.kind).name},
                      {"unit", entryOf(curve.kind).unit},
                      {"points", points}});
  }
  return {{"repeats", study.repeats},
          {"seed", study.seed},
          {"registered", study.isRegistered},
          {"distance", study.scores.distance},
          {"landmark_distance", study.scores.landmarkDistance},
          {"curves", curves}};
}

std::vector<std::vector<std::string>> toTable(const NoiseStudy& study) {
  std::vector<std::vector<std::string>> rows = {{"kind", "level", "unit", "repeats"}};
  for (const Score* score : scoresIn(inStudies)) {
    rows.front().push_back(score->key);
    rows.front().push_back(score->key + "_deviation");
  }
  for (const NoiseCurve& curve : study.curves)
    for (const NoisePoint& point : curve.points) {
      rows.push_back({entryOf(curve.kind).name, plainDecimal(point.level), entryOf(curve.kind).unit,
                      std::to_string(study.repeats)});
      for (const Score* score : scoresIn(inStudies)) {
        const ScoreSpread& spread = point.scores.at(score->key);
        rows.back().push_back(plainDecimal(spread.mean));
        rows.back().push_back(plainDecimal(spread.deviation));
      }
    }
  return rows;
}

} // namespace espalier
