#include "core/project/corrections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
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

using StepAt = std::function<const HistoryStep&(std::size_t)>;

/// The place behind the last of some steps that made the whole plant anew. 0: none did.
std::size_t firstCorrection(const StepAt& stepAt, std::size_t count, std::size_t size) {
  for (std::size_t i = count; i-- > 0;) {
    const HistoryStep& step = stepAt(i);
    if (madePlantAnew(step, size)) return i + 1;
    size = size + countRemoved(step.delta) - countAdded(step.delta);
  }
  return 0;
}

std::size_t firstCorrection(std::span<const HistoryStep> done, std::size_t size) {
  return firstCorrection([done](std::size_t i) -> const HistoryStep& { return done[i]; },
                         done.size(), size);
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

Changes changesOf(const SkeletonDelta& delta) {
  Changes changes;
  for (const SkeletonDelta::Change& change : delta.changes)
    changes.emplace(change.id, &change);
  return changes;
}

/// The nodes that a step drew, where they are one branch. Those that it put into an edge are none
/// of it: they have a child that was there before.
std::vector<NodeId> drawnBy(const SkeletonDelta& delta) {
  if (countAdded(delta) == 0 || countRemoved(delta) > 0) return {};
  std::set<NodeId> drawn;
  for (const SkeletonDelta::Change& change : delta.changes)
    if (!change.before) drawn.insert(change.id);
  for (const SkeletonDelta::Change& change : delta.changes)
    if (change.before && change.after->parent) drawn.erase(*change.after->parent);
  const auto isFoot = [&](const SkeletonDelta::Change& change) {
    return drawn.contains(change.id) &&
           !(change.after->parent && drawn.contains(*change.after->parent));
  };
  if (std::ranges::count_if(delta.changes, isFoot) != 1) return {};
  return {drawn.begin(), drawn.end()};
}

/// The only node that a step attached elsewhere.
std::optional<NodeId> attachedBy(const SkeletonDelta& delta) {
  const auto hasOtherParent = [](const SkeletonDelta::Change& change) {
    return change.before && change.after && change.before->parent != change.after->parent;
  };
  if (std::ranges::none_of(delta.changes, hasOtherParent)) return std::nullopt;
  const Changes changes = changesOf(delta);
  std::optional<NodeId> attached;
  for (const SkeletonDelta::Change& change : delta.changes) {
    if (!hasOtherParent(change) || !isReparented(change, changes)) continue;
    if (attached) return std::nullopt;
    attached = change.id;
  }
  return attached;
}

/// How a step moved the whole plant, turned or scaled it, which corrects nothing of it.
/// @param size  nodes of the plant after it
/// @return none if it changed the shape, or anything else
std::optional<Eigen::Affine3d> motionBy(const SkeletonDelta& delta, std::size_t size) {
  constexpr std::size_t fewest = 3; // fewer have no shape
  if (size < fewest || delta.changes.size() != size) return std::nullopt;
  const auto isMovedAlone = [](const SkeletonDelta::Change& change) {
    return change.before && change.after && change.before->position != change.after->position &&
           change.before->parent == change.after->parent &&
           change.before->edge == change.after->edge;
  };
  if (!std::ranges::all_of(delta.changes, isMovedAlone)) return std::nullopt;
  Eigen::Matrix3Xd before(3, size), after(3, size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    before.col(column) = delta.changes[i].before->position;
    after.col(column) = delta.changes[i].after->position;
  }
  // About the middle: far from 0 little is left of the digits.
  const Eigen::Vector3d from = before.rowwise().mean();
  const Eigen::Vector3d to = after.rowwise().mean();
  before.colwise() -= from;
  after.colwise() -= to;
  const Eigen::Affine3d turn(Eigen::umeyama(before, after));
  const double exactness = 1e-6 * after.colwise().norm().maxCoeff();
  const double error = (turn * before - after).colwise().norm().maxCoeff();
  if (!(error <= exactness)) return std::nullopt; // nor where all nodes lie at one place
  return Eigen::Translation3d(to) * turn * Eigen::Translation3d(-from);
}

/// The nodes of a plant after each of its steps.
/// @param size  after the last
std::vector<std::size_t> sizesAfter(std::span<const HistoryStep> steps, std::size_t size) {
  std::vector<std::size_t> sizes(steps.size());
  for (std::size_t i = steps.size(); i-- > 0;) {
    sizes[i] = size;
    size = size + countRemoved(steps[i].delta) - countAdded(steps[i].delta);
  }
  return sizes;
}

void move(Skeleton& skeleton, const Eigen::Affine3d& motion) {
  const double scale = std::cbrt(std::abs(motion.linear().determinant()));
  for (const NodeId id : skeleton.ids()) {
    skeleton.setPosition(id, motion * skeleton[id].position);
    skeleton.setRadius(id, scale * skeleton[id].radius, skeleton[id].origin);
  }
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
  PlantBeginning beginning{.skeleton = skeletonAt(history, first), .isReconstructed = first > 0};
  const std::vector<std::size_t> sizes = sizesAfter(done, history.skeleton.size());
  for (std::size_t i = first; i < done.size(); ++i)
    if (const auto motion = motionBy(done[i].delta, sizes[i])) move(beginning.skeleton, *motion);
  return beginning;
}

MadeByHand madeByHand(const StepAt& stepAt, std::size_t count, const Skeleton& skeleton) {
  MadeByHand made{.isDrawn = std::vector<bool>(skeleton.idEnd(), false),
                  .isAttached = std::vector<bool>(skeleton.idEnd(), false)};
  for (std::size_t i = firstCorrection(stepAt, count, skeleton.size()); i < count; ++i) {
    const SkeletonDelta& delta = stepAt(i).delta;
    for (const NodeId id : drawnBy(delta))
      if (skeleton.contains(id)) made.isDrawn[indexOf(id)] = true;
    const std::optional<NodeId> attached = attachedBy(delta);
    if (attached && skeleton.contains(*attached)) made.isAttached[indexOf(*attached)] = true;
  }
  return made;
}

HandWork handWork(std::span<const HistoryStep> done, const Skeleton& skeleton) {
  const std::size_t first = firstCorrection(done, skeleton.size());
  const std::vector<std::size_t> sizes = sizesAfter(done, skeleton.size());
  HandWork work;
  Corrections& sum = work.corrections;
  for (std::size_t i = first; i < done.size(); ++i) {
    const Corrections before = sum;
    const SkeletonDelta& delta = done[i].delta;
    const Changes changes = changesOf(delta);
    if (!motionBy(delta, sizes[i]))
      for (const SkeletonDelta::Change& change : delta.changes)
        count(change, changes, sum);
    if (sum != before) ++sum.edits;
    if (i == 0) continue;
    const std::int64_t gap = done[i].time - done[i - 1].time;
    if (gap > 0 && gap <= longestPause) work.time += gap;
  }
  return work;
}

} // namespace espalier
