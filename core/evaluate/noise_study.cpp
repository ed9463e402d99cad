#include "core/evaluate/noise_study.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/evaluate/comparable.h"
#include "core/evaluate/registration.h"

#include <nlohmann/json.hpp>

#include <cassert>
#include <cmath>

namespace espalier {
namespace {

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

std::vector<double> scoresOf(const Run& run, const Skeleton& reference, const NoiseStudy& study,
                             const Progress& progress) {
  Skeleton plant = perturbed(reference, run.kind, run.level, run.seed);
  try {
    if (study.isRegistered)
      plant = moved(plant, registration(plant, reference, {.goodEnough = 0.5}, progress).motion);
    return agreementScores(plant, reference, study.scores, progress);
  } catch (const Error&) {
    throw Error("level " + plainDecimal(run.level) + " of " + entryOf(run.kind).name +
                " leaves nothing to compare: choose a lower one");
  }
}

/// Mean and deviation of the scores of runs [begin, begin + count).
NoisePoint pointOf(double level, const std::vector<std::vector<double>>& scores, std::size_t begin,
                   std::size_t count) {
  const std::size_t kinds = scoreNames().size();
  NoisePoint point{level, std::vector<double>(kinds, 0), std::vector<double>(kinds, 0)};
  const auto plants = static_cast<double>(count);
  for (std::size_t score = 0; score < kinds; ++score) {
    for (std::size_t i = begin; i < begin + count; ++i)
      point.mean[score] += scores[i][score] / plants;
    double squares = 0;
    for (std::size_t i = begin; i < begin + count; ++i)
      squares += std::pow(scores[i][score] - point.mean[score], 2);
    if (count > 1) point.deviation[score] = std::sqrt(squares / (plants - 1));
  }
  return point;
}

} // namespace

NoiseStudy noiseStudy(const Skeleton& reference, const NoiseOptions& options,
                      const Progress& progress) {
  assert(options.repeats >= 1);
  requireComparable(reference, "the reference");
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

  std::vector<std::vector<double>> scores(runs.size());
  const Progress whole = progress.part(0, 1, "Comparing plants");
  const Progress stopOnly = whole.part(0, 0); // plants come at once: none tells how far all are
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
      study.curves.back().points.push_back(pointOf(level, scores, next, options.repeats));
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
      for (std::size_t i = 0; i < scoreNames().size(); ++i)
        scores[scoreNames()[i]] = {{"mean", point.mean[i]}, {"deviation", point.deviation[i]}};
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
  for (const std::string& name : scoreNames()) {
    rows.front().push_back(name);
    rows.front().push_back(name + "_deviation");
  }
  for (const NoiseCurve& curve : study.curves)
    for (const NoisePoint& point : curve.points) {
      rows.push_back({entryOf(curve.kind).name, plainDecimal(point.level), entryOf(curve.kind).unit,
                      std::to_string(study.repeats)});
      for (std::size_t i = 0; i < scoreNames().size(); ++i) {
        rows.back().push_back(plainDecimal(point.mean[i]));
        rows.back().push_back(plainDecimal(point.deviation[i]));
      }
    }
  return rows;
}

} // namespace espalier
