#pragma once

#include "core/base/progress.h"
#include "core/evaluate/evaluation.h"
#include "core/project/corrections.h"
#include "core/project/seal.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"

#include <memory>
#include <string>
#include <vector>

namespace espalier {

/// What a seal is to state beside the work: all that it is found from.
struct ToSeal {
  Skeleton plant;
  PlantBeginning beginning;
  std::shared_ptr<const PointCloud> points = nullptr; // in use; null: there is no scan
  double spacing = 0;                                 // of these [L]
  CheckOptions limits = {};
  std::shared_ptr<const Skeleton> reference = nullptr;
  std::string referenceName = {};
  EvaluationOptions how = {}; // the reference is laid on the plant
};

struct SealedFacts {
  std::vector<Finding> findings; // with those that are ignored
  SealedState state;             // but for its findings, which are ignored by the one who signs
};

/// Checks the plant, against its points too, and compares it with what it began as and with the
/// reference.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] SealedFacts sealedFacts(const ToSeal& from, const Progress& progress);

/// How a structure agrees with another, both as they lie.
/// @param tolerance  what is called near [L]; 0: as `reference` suggests
/// pre: both have a length
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] SealedAgreement agreement(const std::string& with, const Skeleton& result,
                                        const Skeleton& reference, double tolerance,
                                        const Progress& progress);

} // namespace espalier
