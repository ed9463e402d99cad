#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the step "clean", which leaves out points that are no plant; the first is the
/// default.
[[nodiscard]] std::vector<Method> cleanMethods();

} // namespace espalier
