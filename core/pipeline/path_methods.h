#pragma once

#include "core/pipeline/registry.h"

namespace espalier {

// Methods of the step "skeleton" that simplify a tree of shortest paths over the points.

[[nodiscard]] Method shortestPathMethod();
[[nodiscard]] Method branchStructureMethod();

} // namespace espalier
