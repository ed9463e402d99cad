#include "core/project/history.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

namespace espalier {
namespace {

using Change = SkeletonDelta::Change;
using ChangesById = std::unordered_map<std::uint32_t, const Change*>;

std::uint32_t number(NodeId id) {
  return static_cast<std::uint32_t>(id);
}

bool isAsBefore(const Change& change, const Skeleton& skeleton) {
  if (indexOf(change.id) >= mostIds) return false;
  if (!change.before) return !skeleton.contains(change.id) && change.after.has_value();
  return skeleton.contains(change.id) && skeleton[change.id] == *change.before;
}

/// Whether no node that stays is attached to a removed one.
bool takesAllAbove(const Change& change, const Skeleton& skeleton, const ChangesById& changes) {
  if (change.after) return true;
  return std::ranges::all_of(skeleton.children(change.id),
                             [&](NodeId child) { return changes.contains(number(child)); });
}

/// Whether the links after the delta lead to a root from every changed node.
class Rootedness {
public:
  Rootedness(const Skeleton& skeleton, const ChangesById& changes)
      : skeleton_(skeleton), changes_(changes) {}

  bool holdsFor(NodeId from) {
    std::vector<std::uint32_t> path;
    std::optional<NodeId> at = from;
    bool isRooted = true;
    while (at) {
      const auto [mark, isNew] = marks_.emplace(number(*at), false);
      if (!isNew) {
        isRooted = mark->second; // false: a cycle leads back to the path
        break;
      }
      path.push_back(number(*at));
      const Node* node = nodeAfter(*at);
      if (node == nullptr) return false; // the parent is missing
      at = node->parent;
    }
    for (const std::uint32_t id : path)
      marks_[id] = isRooted;
    return isRooted;
  }

private:
  [[nodiscard]] const Node* nodeAfter(NodeId id) const {
    if (const auto found = changes_.find(number(id)); found != changes_.end())
      return found->second->after ? &*found->second->after : nullptr;
    return skeleton_.contains(id) ? &skeleton_[id] : nullptr;
  }

  const Skeleton& skeleton_;
  const ChangesById& changes_;
  std::unordered_map<std::uint32_t, bool> marks_; // whether it is known to lead to a root
};

bool fits(const SkeletonDelta& delta, const Skeleton& skeleton) {
  ChangesById changes;
  changes.reserve(delta.changes.size());
  for (const Change& change : delta.changes) {
    if (!isAsBefore(change, skeleton)) return false;
    if (change.after && !(change.after->radius >= 0)) return false;
    if (!changes.emplace(number(change.id), &change).second) return false;
  }
  Rootedness rooted(skeleton, changes);
  return std::ranges::all_of(delta.changes, [&](const Change& change) {
    return takesAllAbove(change, skeleton, changes) &&
           (!change.after || rooted.holdsFor(change.id));
  });
}

} // namespace

void growIds(Skeleton& skeleton, std::size_t end) {
  assert(end <= mostIds);
  if (skeleton.idEnd() < end) skeleton.reserve(end); // once: growing copies all there is
  while (skeleton.idEnd() < end)
    skeleton.erase(skeleton.add({}));
}

bool tryToApply(const SkeletonDelta& delta, Skeleton& skeleton) {
  if (!fits(delta, skeleton)) return false;
  std::size_t end = 0;
  for (const Change& change : delta.changes)
    end = std::max(end, indexOf(change.id) + 1);
  growIds(skeleton, end);
  delta.apply(skeleton);
  return true;
}

std::optional<std::string> envelopeAfter(const History& history) {
  for (std::size_t i = history.position; i-- > 0;)
    if (history.steps[i].envelope) return history.steps[i].envelope->after;
  for (std::size_t i = history.position; i < history.steps.size(); ++i)
    if (history.steps[i].envelope) return history.steps[i].envelope->before;
  return std::nullopt;
}

Skeleton skeletonAt(const History& history, std::size_t position) {
  assert(position <= history.position);
  Skeleton skeleton = history.skeleton;
  for (std::size_t i = history.position; i-- > position;)
    history.steps[i].delta.inverse().apply(skeleton);
  return skeleton;
}

std::vector<std::size_t> endsOfDays(std::span<const HistoryStep> done,
                                    const std::function<std::int64_t(std::int64_t)>& dayOf) {
  std::map<std::int64_t, std::size_t> ends; // by day
  for (std::size_t i = 0; i < done.size(); ++i)
    ends[dayOf(done[i].time)] = i + 1;
  std::vector<std::size_t> result;
  for (const auto& [day, end] : ends)
    if (end < done.size()) result.push_back(end);
  return result;
}

History beginningOf(const History& history) {
  History beginning{
      .skeleton = history.skeleton, .leftOut = history.leftOut, .organs = history.organs};
  for (std::size_t i = history.position; i-- > 0;) {
    history.steps[i].delta.inverse().apply(beginning.skeleton);
    beginning.leftOut = beginning.leftOut ^ history.steps[i].points;
    beginning.organs = beginning.organs ^ history.steps[i].organs;
  }
  return beginning;
}

} // namespace espalier
