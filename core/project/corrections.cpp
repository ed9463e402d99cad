#include "core/project/corrections.h"

#include <algorithm>
#include <unordered_map>

namespace espalier {
namespace {

std::size_t countAdded(const SkeletonDelta& delta) {
  return static_cast<std::size_t>(std::ranges::count_if(
      delta.changes, [](const SkeletonDelta::Change& change) { return !change.before; }));
}

std::size_t countRemoved(const SkeletonDelta& delta) {
  return static_cast<std::size_t>(std::ranges::count_if(
      delta.changes, [](const SkeletonDelta::Change& change) { return !change.after; }));
}

/// The place behind the last step that made the whole plant anew. 0: none did.
std::size_t firstCorrection(std::span<const HistoryStep> done, std::size_t size) {
  for (std::size_t i = done.size(); i-- > 0;) {
    if (madePlantAnew(done[i], size)) return i + 1;
    size = size + countRemoved(done[i].delta) - countAdded(done[i].delta);
  }
  return 0;
}

/// What an edit did to nodes, by id.
using Changes = std::unordered_map<NodeId, const SkeletonDelta::Change*>;

/// The nearest node up from `parent`, by one side of the edit, that the edit has neither added nor
/// removed.
std::optional<NodeId> keptAbove(std::optional<NodeId> parent,
                                std::optional<Node> SkeletonDelta::Change::*side,
                                const Changes& changes) {
  while (parent) {
    const auto found = changes.find(*parent);
    if (found == changes.end() || (found->second->before && found->second->after)) break;
    parent = (found->second->*side)->parent;
  }
  return parent;
}

/// Whether a node grows from another than before: one that is put into its edge, or taken out of
/// it, attaches it nowhere else.
bool isReparented(const SkeletonDelta::Change& change, const Changes& changes) {
  using Change = SkeletonDelta::Change;
  if (change.before->parent == change.after->parent) return false;
  return keptAbove(change.before->parent, &Change::before, changes) !=
         keptAbove(change.after->parent, &Change::after, changes);
}

void count(const SkeletonDelta::Change& change, const Changes& changes, Corrections& to) {
  if (!change.before || !change.after) {
    ++(change.before ? to.removed : to.added);
    return;
  }
  const Node& before = *change.before;
  const Node& after = *change.after;
  if (before.position != after.position) ++to.moved;
  if (before.radius != after.radius) ++to.radii;
  if (isReparented(change, changes))
    ++to.reparented;
  else if (before.parent == after.parent && after.parent && before.edge != after.edge)
    ++to.retyped;
}

} // namespace

bool madePlantAnew(const HistoryStep& step, std::size_t size) {
  const std::size_t added = countAdded(step.delta);
  return added == size && added > 0 && (step.replacesContracted || countRemoved(step.delta) > 0);
}

PlantBeginning beginningOfHandWork(const History& history) {
  const auto done = std::span(history.steps).first(history.position);
  const std::size_t first = firstCorrection(done, history.skeleton.size());
  return {.skeleton = skeletonAt(history, first), .isReconstructed = first > 0};
}

HandWork handWork(std::span<const HistoryStep> done, const Skeleton& skeleton) {
  const std::size_t first = firstCorrection(done, skeleton.size());
  HandWork work;
  Corrections& sum = work.corrections;
  for (std::size_t i = first; i < done.size(); ++i) {
    const Corrections before = sum;
    Changes changes;
    for (const SkeletonDelta::Change& change : done[i].delta.changes)
      changes.emplace(change.id, &change);
    for (const SkeletonDelta::Change& change : done[i].delta.changes)
      count(change, changes, sum);
    if (sum != before) ++sum.edits;
    if (i == 0) continue;
    const std::int64_t gap = done[i].time - done[i - 1].time;
    if (gap > 0 && gap <= longestPause) work.time += gap;
  }
  return work;
}

} // namespace espalier
