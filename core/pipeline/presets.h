#pragma once

#include "core/clean/plant_kind.h"
#include "core/pipeline/pipeline.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// A way from scan to skeleton as a whole, for any plant: its lengths are rules.
struct NamedPreset {
  std::string name;  // on the command line
  std::string label; // in menus
  std::string help;  // one line
  std::string source;
  PipelineOptions options;
  std::optional<PlantKind> kind = {}; // of the plants that it is for; none: any
};

/// The first is the default, in which nothing is chosen.
[[nodiscard]] const std::vector<NamedPreset>& presets();

/// Null if there is none of this name.
[[nodiscard]] const NamedPreset* presetNamed(std::string_view name);

[[nodiscard]] std::string presetNames(); // "default, thesis, ..., plot"

/// The options of a preset, by its name or else of a file (preset.h).
/// @param meters  in the unit of the scan, for lengths as "38 mm" in a file; 0: not known
/// @throws Error naming what there is, or what is wrong in the file
[[nodiscard]] PipelineOptions presetIn(const std::string& nameOrFile, double meters = 0);

} // namespace espalier
