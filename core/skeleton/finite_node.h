#pragma once

#include "core/skeleton/skeleton.h"

#include <cmath>

namespace espalier {

/// Whether a node is what files and projects can keep: its place is finite, its radius too and not
/// below 0. (A place that is no number is not equal to itself: an edit of it could not be undone.)
[[nodiscard]] inline bool isFinite(const Node& node) {
  return node.position.allFinite() && std::isfinite(node.radius) && node.radius >= 0;
}

} // namespace espalier
