#pragma once

#include "core/evaluate/light_interception.h"
#include "core/evaluate/traits.h"

#include <nlohmann/json_fwd.hpp>

namespace espalier {

// What is measured on one plant, with the keys that comparison_json.h lists. Angles in degrees.
[[nodiscard]] nlohmann::ordered_json toJson(const Traits& traits);
[[nodiscard]] nlohmann::ordered_json toJson(const LightInterception& light);

} // namespace espalier
