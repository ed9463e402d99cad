#pragma once

#include "core/base/progress.h"
#include "core/clean/plant_kind.h"
#include "core/pipeline/pipeline_options.h"
#include "core/pipeline/presets.h"

#include <array>
#include <memory>
#include <optional>

namespace espalier {

/// What the plant of a scan probably is.
struct KindOfScan {
  LikelyKind likely;
  std::array<double, allOrgans.size()> shares = {}; // of its points, in the order of allOrgans

  bool operator==(const KindOfScan&) const = default;
};

/// Guesses what the plant of a scan is, from what its points lie on. The scan is taken for one
/// plant, as it lies but for a few far points: ground and neighbors lead it astray. Of a large scan
/// evenly chosen points are looked at, at most 100 000.
/// @param options  up, the root, and what was set aside; steps are not run
/// @param metersInUnit  of the scan: trees are taller than herbs; 0: not known
/// @return none of fewer than 200 places, and of what is wider than any crown
/// @throws Cancelled if `progress` asks to stop
/// Deterministic for any number of threads.
[[nodiscard]] std::optional<KindOfScan> kindOfScan(const std::shared_ptr<const PointCloud>& cloud,
                                                   const PipelineOptions& options = {},
                                                   double metersInUnit = 0,
                                                   const Progress& progress = {});

/// The settings for plants of this kind.
[[nodiscard]] const NamedPreset& presetFor(PlantKind kind);

} // namespace espalier
