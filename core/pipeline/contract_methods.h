#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the step "contract", which pulls the points towards the axes of the plant; the
/// first is the default.
[[nodiscard]] std::vector<Method> contractMethods();

} // namespace espalier
