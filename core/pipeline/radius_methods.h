#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the step "radius", which gives each node its radius; the first is the default.
[[nodiscard]] std::vector<Method> radiusMethods();

} // namespace espalier
