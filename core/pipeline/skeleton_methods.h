#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the step "skeleton", which finds nodes and what is attached to what; the first is
/// the default.
[[nodiscard]] std::vector<Method> skeletonMethods();

} // namespace espalier
