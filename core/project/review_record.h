#pragma once

#include "core/project/history.h"

#include <cstddef>
#include <span>

namespace espalier {

/// How the marks came about by which nodes are reviewed.
struct ReviewRecord {
  struct Amount {
    std::size_t nodes = 0;
    double length = 0; // [L] of their edges

    bool operator==(const Amount&) const = default;
  };
  Amount lookedAt;          // by steps of no more than one looks at in one go (isOneLook())
  Amount inBulk;            // by larger steps
  Amount before;            // by no step: the plant came with them
  Amount doubted;           // of all these, those that were doubtful at some time
  std::size_t comments = 0; // places with a remark: nodes on end with the same one are one

  bool operator==(const ReviewRecord&) const = default;
};

/// Of each reviewed node of a plant, by which of the steps that led to it: the last one that marked
/// it. What was one look is measured on the plant as it is now. O(all changes + steps nodes).
[[nodiscard]] ReviewRecord reviewRecord(std::span<const HistoryStep> done,
                                        const Skeleton& skeleton);

} // namespace espalier
