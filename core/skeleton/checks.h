#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// What is worth a second look in a skeleton.
struct Finding {
  enum class Kind : std::uint8_t {
    twoSuccessors,    // more than one child continues the axis of the node
    noLength,         // the edge to the parent has no length
    radiusAboveParent // thicker than what the node hangs on
  };
  Kind kind;
  NodeId node;

  bool operator==(const Finding&) const = default;
};

/// All findings, parents before their children. Nothing is changed. Time O(n).
[[nodiscard]] std::vector<Finding> check(const Skeleton& skeleton);

/// "node 12 has 2 successors: an axis continues once"
[[nodiscard]] std::string describe(const Finding& finding, const Skeleton& skeleton);

/// "two_successors", "no_length", "radius_above_parent"
[[nodiscard]] std::string nameOf(Finding::Kind kind);

} // namespace espalier
