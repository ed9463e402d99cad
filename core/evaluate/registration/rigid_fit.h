#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/even_samples.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Geometry>

#include <vector>

namespace espalier {

/// One of two skeletons that are laid on each other: samples of it, and what finds places on it.
struct FitSide {
  const EdgeIndex& index; // outlives it
  std::vector<EvenSample> samples;
};

/// The two, and what counts as near.
struct FitPair {
  FitSide result;
  FitSide reference;
  Eigen::Vector3d center; // of the reference: what turns go about [L]
  double size;            // of the reference [L]
  double reach;           // [L]: distances above it count as this, they are no pairs
};

/// @param samples about as many of either, evenly along it
[[nodiscard]] std::vector<EvenSample> samplesOf(const Skeleton& skeleton, std::size_t samples);

/// A motion of the result, and how well it lays it on the reference.
struct RigidFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double residual = 0; // [L], mean distance in both directions, each up to reach
  double near = 0;     // share of the length of both within a fourth of that: harmonic mean
};

struct FitSteps {
  int most = 40;
  bool turns = false; // about any axis; else the result is shifted only
  double width = 0;   // [L], up to which pairs pull at first; it shrinks to the reach of the pair
};

/// How well a motion fits. @throws Cancelled if `progress` asks to stop
[[nodiscard]] RigidFit fitAt(const Eigen::Isometry3d& motion, const FitPair& pair,
                             const Progress& progress = {});

/// The best motion met while stepping from `start`: iterated closest points, where distances are
/// measured across the edges and far pairs fade out.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] RigidFit refined(const Eigen::Isometry3d& start, const FitPair& pair,
                               const FitSteps& steps, const Progress& progress = {});

} // namespace espalier
