#include "core/project/review_record.h"

#include "core/skeleton/length_along.h"
#include "core/skeleton/review_walk.h"

#include <algorithm>
#include <vector>

namespace espalier {
namespace {

bool isReviewed(const std::optional<Node>& node) {
  return node && node->review.state == ReviewState::reviewed;
}

/// A remark that is not that of the parent.
bool beginsComment(const Skeleton& skeleton, NodeId id) {
  const std::string& comment = skeleton[id].review.comment;
  const std::optional<NodeId> parent = skeleton[id].parent;
  return !comment.empty() && (!parent || skeleton[*parent].review.comment != comment);
}

} // namespace

ReviewRecord reviewRecord(std::span<const HistoryStep> done, const Skeleton& skeleton) {
  ReviewRecord record;
  const auto add = [&](ReviewRecord::Amount& amount, NodeId id) {
    ++amount.nodes;
    amount.length += edgeLength(skeleton, id);
  };
  std::vector<bool> isOpen(skeleton.idEnd(), false); // reviewed, by a step before those looked at
  std::vector<bool> wasDoubted(skeleton.idEnd(), false);
  for (const NodeId id : skeleton.ids())
    isOpen[indexOf(id)] = skeleton[id].review.state == ReviewState::reviewed;
  std::vector<NodeId> marked;
  for (auto step = done.rbegin(); step != done.rend(); ++step) {
    marked.clear();
    for (const SkeletonDelta::Change& change : step->delta.changes) {
      const std::size_t at = indexOf(change.id);
      if (!skeleton.contains(change.id)) continue;
      for (const std::optional<Node>& node : {change.before, change.after})
        if (node && node->review.state == ReviewState::doubtful) wasDoubted[at] = true;
      if (isReviewed(change.after) && !isReviewed(change.before)) marked.push_back(change.id);
    }
    if (marked.empty()) continue;
    const bool isLook = isOneLook(skeleton, marked);
    for (const NodeId id : marked) // but what a later step marked
      if (isOpen[indexOf(id)]) {
        isOpen[indexOf(id)] = false;
        add(isLook ? record.lookedAt : record.inBulk, id);
      }
  }
  for (const NodeId id : skeleton.ids()) {
    if (beginsComment(skeleton, id)) ++record.comments;
    if (isOpen[indexOf(id)]) add(record.before, id);
    if (wasDoubted[indexOf(id)] && skeleton[id].review.state == ReviewState::reviewed)
      add(record.doubted, id);
  }
  return record;
}

} // namespace espalier
