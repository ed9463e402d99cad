#include "core/project/corrections.h"

#include <algorithm>

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

void count(const SkeletonDelta::Change& change, Corrections& to) {
  if (!change.before || !change.after) {
    ++(change.before ? to.removed : to.added);
    return;
  }
  const Node& before = *change.before;
  const Node& after = *change.after;
  if (before.position != after.position) ++to.moved;
  if (before.radius != after.radius) ++to.radii;
  if (before.parent != after.parent)
    ++to.reparented;
  else if (after.parent && before.edge != after.edge)
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
    for (const SkeletonDelta::Change& change : done[i].delta.changes)
      count(change, sum);
    if (sum != before) ++sum.edits;
    if (i == 0) continue;
    const std::int64_t gap = done[i].time - done[i - 1].time;
    if (gap > 0 && gap <= longestPause) work.time += gap;
  }
  return work;
}

} // namespace espalier
