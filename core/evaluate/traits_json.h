#pragma once

#include "core/evaluate/plant_measures.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace espalier {

// What is measured on one plant, with the keys that comparison_json.h lists. Angles in degrees.
[[nodiscard]] nlohmann::ordered_json toJson(const Traits& traits);
[[nodiscard]] nlohmann::ordered_json toJson(const LightInterception& light);
[[nodiscard]] nlohmann::ordered_json toJson(const WoodAmounts& wood);

/// All that is measured on one plant: traits, wood and light, as there of one of the two;
/// wood.volume_interval.{least,most} or null, wood.volume_of_unknown_error as there;
/// breast_height.{diameter,missing}; biomass.{density,whole,by_order[],by_radius[],by_class[]} in
/// kg, null where the density of the wood is not known; warnings[].
[[nodiscard]] nlohmann::ordered_json toJson(const PlantMeasures& measures);

/// The same numbers as a table, a line each: "traits.length,12.5".
[[nodiscard]] std::vector<std::vector<std::string>> tableOf(const nlohmann::ordered_json& json);

} // namespace espalier
