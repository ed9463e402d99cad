#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the steps that repair what hangs on what, and space the nodes; the first of each
/// is the default.
[[nodiscard]] std::vector<Method> joinMethods();      // chooses across gaps what hangs on what
[[nodiscard]] std::vector<Method> insertionMethods(); // hangs branches where they leave their wood
[[nodiscard]] std::vector<Method> nodeMethods();      // spaces nodes

} // namespace espalier
