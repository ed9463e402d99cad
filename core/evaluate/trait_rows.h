#pragma once

#include "core/evaluate/plant_measures.h"

#include <string>
#include <vector>

namespace espalier {

/// How a trait is to be written.
enum class TraitKind { count, share, length, area, volume, angle };

/// One number of a plant with its name, as panels, tables and reports show it.
struct TraitRow {
  std::string group; // "Stem"
  std::string label; // in the group, and by itself: "stem length"
  std::string help;  // what it is, a sentence without its end
  TraitKind kind;
  double value; // [L], [L^2], [L^3]; angles in [rad]
};

/// Size, stem, crown and branching; what the plant has not (a divergence of one branch) is left
/// out.
[[nodiscard]] std::vector<TraitRow> traitRows(const Traits& traits);

/// The same, and its wood and light, as far as they are there.
[[nodiscard]] std::vector<TraitRow> traitRows(const PlantMeasures& measures);

} // namespace espalier
