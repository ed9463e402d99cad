#pragma once

#include "core/base/progress.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/study/perturbation.h"
#include "core/skeleton/skeleton.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace espalier {

/// A way to make the reference worse, and how much.
struct NoiseSeries {
  Perturbation kind;
  std::vector<double> levels; // empty = those of perturbations()
};

struct NoiseOptions {
  std::vector<NoiseSeries> series; // empty = all kinds
  std::size_t repeats = 5;         // plants per level, >= 1
  std::uint64_t seed = 1;          // of the first; the others follow
  bool registers = false;          // lays each plant on the reference first
  ScoreOptions scores;
};

/// A score over the plants made at one level.
struct ScoreSpread {
  double mean = 0;
  double deviation = 0; // standard deviation of one plant; 0 of a single one
};

struct NoisePoint {
  double level = 0;
  std::map<std::string, ScoreSpread> scores; // by key: those of studyScores()
};

struct NoiseCurve {
  Perturbation kind;
  std::vector<NoisePoint> points; // by the levels
};

struct NoiseStudy {
  std::size_t repeats = 0;
  std::uint64_t seed = 0;
  bool isRegistered = false;
  ScoreOptions scores;            // as used
  std::vector<NoiseCurve> curves; // by the series
};

/// How fast each score falls as a reference is made worse and compared with itself.
///
/// A score that stays high where much is wrong hides it; one that falls where nothing is, as where
/// nodes are merely respaced, measures something else than the plant.
/// @throws Error     if the reference has no nodes, no length, or a position that is no number; if
///                   a level is outside its range, or leaves nothing to compare
/// @throws Cancelled if `progress` asks to stop
/// Deterministic on any number of threads. Cost: levels * repeats * studyScores().
/// Source: the design of the thesis, chapter 5: a reference under increasing noise.
[[nodiscard]] NoiseStudy noiseStudy(const Skeleton& reference, const NoiseOptions& options = {},
                                    const Progress& progress = {});

/// Keys: repeats, seed, registered, distance, landmark_distance, curves[].{kind,unit,points[].{
/// level,scores.KEY.{mean,deviation}}}; the keys are those of scoresIn(inStudies).
[[nodiscard]] nlohmann::ordered_json toJson(const NoiseStudy& study);

/// A table of fields, its first row the names of the columns: kind, level, unit, repeats, and KEY
/// and KEY_deviation of each score.
[[nodiscard]] std::vector<std::vector<std::string>> toTable(const NoiseStudy& study);

} // namespace espalier
