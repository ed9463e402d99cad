#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the steps that mend a skeleton; the first of each is the default.
[[nodiscard]] std::vector<Method> pruneMethods();    // removes what is no branch
[[nodiscard]] std::vector<Method> axesMethods();     // chooses which child continues the axis
[[nodiscard]] std::vector<Method> recenterMethods(); // moves nodes into the middle of the wood
[[nodiscard]] std::vector<Method> endsMethods();     // gives tips and roots their full length

} // namespace espalier
