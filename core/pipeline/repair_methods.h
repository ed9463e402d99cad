#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

/// All methods of the steps that repair what is attached to what, and space the nodes; the first of
/// each is the default.
[[nodiscard]] std::vector<Method> joinMethods();      // chooses what is attached across gaps
[[nodiscard]] std::vector<Method> insertionMethods(); // attaches branches where they leave
[[nodiscard]] std::vector<Method> nodeMethods();      // spaces nodes

} // namespace espalier
