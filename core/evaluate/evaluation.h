#pragma once

#include "core/base/progress.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/differences/differences.h"
#include "core/evaluate/registration/registration.h"
#include "core/skeleton/skeleton.h"

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

struct EvaluationOptions {
  bool registers = true; // lays the reference on the result before anything is measured
  bool turns = true;     // turns it, too, where that fits clearly better
  UpAxis up = UpAxis::z; // all angles about it are tried; heights are along it
  std::optional<Eigen::Isometry3d> motion; // of the reference, found before; none: it is found
  /// Since `motion` was found: it is found again, and kept unless the reference would lie elsewhere
  /// by over half of the finest default tolerance, so that small edits do not make it tremble.
  bool isResultEdited = false;
  EditOptions edit;        // what the edit distance counts
  double tolerance = 0;    // [L], what is called near; 0 = usualTolerance()
  double breastHeight = 0; // [L], as breastHeightIn(); 0: its diameter is not measured
  EvaluatedScan scan;      // without points: no errors by the arc that was seen
  /// By id of the reference, found before from that scan, where `motion` laid it if there is one;
  /// null: they are found.
  std::shared_ptr<const std::vector<double>> coverages;
};

/// What an editor shows of a comparison. All places are in the frame of the result: it is the
/// reference that is laid on it, since the result lies on its scan.
struct Evaluation {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // of the reference
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); // of the middle of the reference under it [L]
  bool isShiftLarge = false;                       // it is more than the finest default tolerance
  /// Of the result on the reference, as reports show it; none if the two are compared as they lie.
  std::optional<Registration> registration;
  Skeleton reference;                // moved, under its own ids
  double tolerance = 0;              // [L], as used
  ToleranceScore score{};            // at the tolerance
  std::vector<ToleranceScore> curve; // at even distances from 0 on
  Comparison comparison;             // both lie as they are compared; capped at the tolerance
  Differences differences;
};

/// Even distances for a smooth curve: from 0 to twice the tolerance at least, and to `coarsest`.
[[nodiscard]] std::vector<double> curveDistances(double tolerance, double coarsest); // [L]

/// Where evaluate() lays the reference. @throws as it does
[[nodiscard]] Eigen::Isometry3d referenceMotion(const Skeleton& result, const Skeleton& reference,
                                                const EvaluationOptions& options,
                                                const Progress& progress = {});

/// Lays a reference on a result, and compares both in every way that an editor shows.
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see compare() and differences().
[[nodiscard]] Evaluation evaluate(const Skeleton& result, const Skeleton& reference,
                                  const EvaluationOptions& options = {},
                                  const Progress& progress = {});

} // namespace espalier
