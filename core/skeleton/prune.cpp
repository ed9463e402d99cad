#include "core/skeleton/prune.h"

#include <queue>

#include <optional>
#include <tuple>
#include <vector>

namespace espalier {
namespace {

/// An unbranched end of the plant.
struct Spur {
  double excess; // of its length over what a spur may have; negative: it goes
  double length; // [L]
  NodeId tip;
  NodeId foot;

  bool operator>(const Spur& other) const {
    return std::tuple(length, tip) > std::tuple(other.length, other.tip);
  }
};

std::optional<Spur> spurAt(const Skeleton& skeleton, NodeId tip, const SpurOptions& options) {
  double length = 0;
  NodeId at = tip;
  while (skeleton[at].parent) {
    const NodeId parent = *skeleton[at].parent;
    length += (skeleton[at].position - skeleton[parent].position).norm();
    at = parent;
    if (skeleton.children(at).size() > 1)
      return Spur{length - options.length - options.radiusShare * skeleton[at].radius, length, tip,
                  at};
  }
  return std::nullopt; // unbranched down to the root
}

} // namespace

Skeleton withoutSpurs(const Skeleton& skeleton, const SpurOptions& options,
                      const Progress& progress) {
  Skeleton result = skeleton;
  std::priority_queue<Spur, std::vector<Spur>, std::greater<>> queue;
  for (const NodeId id : result.ids())
    if (result.children(id).empty())
      if (const auto spur = spurAt(result, id, options); spur && spur->excess < 0)
        queue.push(*spur);
  while (!queue.empty()) {
    progress.check();
    const Spur spur = queue.top();
    queue.pop();
    const auto now = spurAt(result, spur.tip, options);
    if (!now || now->excess >= 0) continue;
    if (now->length > spur.length) { // its foot went: it takes its turn again
      queue.push(*now);
      continue;
    }
    NodeId at = spur.tip;
    while (at != now->foot) {
      const NodeId parent = *result[at].parent;
      result.erase(at);
      at = parent;
    }
  }
  progress.update(1);
  return result;
}

} // namespace espalier
