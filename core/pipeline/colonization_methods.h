#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

// Methods of the step "skeleton" that grow a plant into the points, from the root.

[[nodiscard]] Method graphColonizationMethod();
[[nodiscard]] Method pointTrackingMethod();
[[nodiscard]] Method spaceColonizationMethod();

} // namespace espalier
