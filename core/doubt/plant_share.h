#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// How much of a plant something is, by what gains are measured.
class PlantShare {
public:
  explicit PlantShare(const Skeleton& plant); // O(N)

  /// Of its length and of its ends, the mean: in [0, 1].
  [[nodiscard]] double of(double length, double ends) const;

private:
  double length_ = 0; // [L]
  double ends_ = 0;
};

/// A node and those above it up to the next branching or the end. pre: contains(id)
[[nodiscard]] std::vector<NodeId> runFrom(const Skeleton& skeleton, NodeId id);

[[nodiscard]] double lengthOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes); // [L]

} // namespace espalier
