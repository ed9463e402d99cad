#pragma once

#include "core/skeleton/axes.h"

#include <array>
#include <cstddef>

namespace espalier {

/// How much has been looked at: nodes, and length, each edge with the node it leads to.
struct ReviewCoverage {
  std::array<double, 3> length = {};     // [L], by ReviewState
  std::array<std::size_t, 3> nodes = {}; // likewise

  [[nodiscard]] double totalLength() const { return length[0] + length[1] + length[2]; } // [L]
  [[nodiscard]] std::size_t totalNodes() const { return nodes[0] + nodes[1] + nodes[2]; }
  /// Share of the length, or of the nodes if there is no length; in [0, 1], 0 of nothing.
  [[nodiscard]] double share(ReviewState state) const;
  /// Reviewed if all of it is, doubtful if any of it is, else to do.
  [[nodiscard]] ReviewState state() const;
  [[nodiscard]] bool isComplete() const { return totalNodes() > 0 && nodes[2] == totalNodes(); }

  bool operator==(const ReviewCoverage&) const = default;
};

/// Of all nodes. O(N).
[[nodiscard]] ReviewCoverage coverage(const Skeleton& skeleton);

/// Of some nodes, as those of an axis. pre: all are contained
[[nodiscard]] ReviewCoverage coverage(const Skeleton& skeleton, const std::vector<NodeId>& nodes);

} // namespace espalier
