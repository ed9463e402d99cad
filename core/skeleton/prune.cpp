#include "core/skeleton/prune.h"

#include "core/skeleton/branch_end.h"

#include <queue>

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// An end, and whether it goes.
struct Spur {
  BranchEnd end;
  double excess; // of its length over what a spur may have; negative: it goes

  bool operator>(const Spur& other) const {
    return std::tuple(end.length, end.nodes.front()) >
           std::tuple(other.end.length, other.end.nodes.front());
  }
};

std::optional<Spur> spurAt(const Skeleton& skeleton, NodeId tip, const SpurOptions& options) {
  auto end = branchEndAt(skeleton, tip);
  if (!end) return std::nullopt;
  const double excess =
      end->length - options.length - options.radiusShare * skeleton[end->foot].radius;
  return Spur{std::move(*end), excess};
}

} // namespace

Skeleton withoutSpurs(const Skeleton& skeleton, const SpurOptions& options,
                      const Progress& progress) {
  Skeleton result = skeleton;
  std::priority_queue<Spur, std::vector<Spur>, std::greater<>> queue;
  for (const NodeId id : result.ids())
    if (result.children(id).empty())
      if (auto spur = spurAt(result, id, options); spur && spur->excess < 0)
        queue.push(std::move(*spur));
  while (!queue.empty()) {
    progress.check();
    const Spur spur = queue.top();
    queue.pop();
    auto now = spurAt(result, spur.end.nodes.front(), options);
    if (!now || now->excess >= 0) continue;
    if (now->end.length > spur.end.length) { // its foot went: it takes its turn again
      queue.push(std::move(*now));
      continue;
    }
    for (const NodeId id : now->end.nodes)
      result.erase(id);
  }
  progress.update(1);
  return result;
}

} // namespace espalier
