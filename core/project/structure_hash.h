#pragma once

#include "core/skeleton/skeleton.h"
#include "core/skeleton/skeleton_delta.h"

#include <cstdint>

namespace espalier {

/// 64 bits that distinguish a reviewed structure from any other: ids, positions, radii, links, what
/// MTGs say of the nodes, and the states of the review; not its comments, its reviewers,
/// unit marks.
///
/// The sum of a hash per node, so that an edit costs what it changes and undo comes back to the
/// same value. Separates structures that differ by accident, not those made to deceive.
class StructureHash {
public:
  explicit StructureHash(const Skeleton& skeleton); // O(N)

  void apply(const SkeletonDelta& delta); // pre: as SkeletonDelta::apply
  [[nodiscard]] std::uint64_t value() const { return sum_; }

private:
  std::uint64_t sum_ = 0;
};

} // namespace espalier
