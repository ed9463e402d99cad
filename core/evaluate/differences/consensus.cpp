#include "core/evaluate/differences/consensus.h"

#include "core/evaluate/differences/near_edges.h"
#include "core/evaluate/match/comparable.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// By id of the first skeleton: which edges all others have, and where these attach what is there
/// as the first does. An edge goes by the node at its upper end.
struct Agreement {
  std::vector<bool> isThere;
  std::vector<bool> isAttached;
};

void restrictTo(Agreement& agreement, const Differences& found) {
  for (std::size_t id = 0; id < found.ofResult.size(); ++id)
    if (found.ofResult[id] == Difference::invented) agreement.isThere[id] = false;
  for (const DifferingPart& part : found.parts) {
    if (part.kind != Difference::wronglyAttached) continue;
    agreement.isAttached[indexOf(part.attached)] = false;
    for (const NodeId id : part.nodes) // what leads there may be of none of the others
      if (found.standsOn[indexOf(id)].empty()) agreement.isThere[indexOf(id)] = false;
  }
}

/// Wood that both have, each from its other end up: their roots are elsewhere, or a branch is
/// attached by its apex. Turns that are shorter than three tolerances do not count: whose wood runs
/// there is not known better.
std::vector<DifferingPart> turnedParts(const Skeleton& first, const Skeleton& other,
                                       const Differences& found) {
  const EdgeIndex edges(other);
  std::vector<bool> isTurned(first.idEnd(), false);
  for (const NodeId id : first.ids()) {
    const auto parent = first[id].parent;
    if (!parent || found.ofResult[indexOf(id)] == Difference::invented) continue;
    const Eigen::Vector3d& start = first[*parent].position;
    const Eigen::Vector3d& end = first[id].position;
    const std::optional<NearestPlace> near = edges.nearest((start + end) / 2);
    const auto below = near ? other[near->node].parent : std::nullopt;
    if (below)
      isTurned[indexOf(id)] =
          (end - start).dot(other[near->node].position - other[*below].position) < 0;
  }
  std::vector<DifferingPart> parts;
  for (std::vector<NodeId>& nodes : stretches(first, isTurned, true)) {
    DifferingPart part{
        .kind = Difference::wronglyAttached, .nodes = std::move(nodes), .at = {}, .attached = {}};
    part.attached = part.nodes.front();
    part.at = first[part.attached].position;
    for (const NodeId id : part.nodes)
      part.length += edgeLength(first, id);
    if (part.length > 3 * found.tolerance) parts.push_back(std::move(part));
  }
  return parts;
}

Skeleton agreedWood(const Skeleton& first, const Agreement& agreement) {
  const std::vector<NodeId> ids = first.ids();
  std::vector<bool> isNeeded(first.idEnd(), false); // a node at an end of an edge that is there
  for (const NodeId id : ids) {
    if (!first[id].parent || !agreement.isThere[indexOf(id)]) continue;
    isNeeded[indexOf(id)] = true;
    if (agreement.isAttached[indexOf(id)]) isNeeded[indexOf(*first[id].parent)] = true;
  }
  Skeleton agreed;
  std::vector<std::optional<NodeId>> copies(first.idEnd());
  for (const NodeId id : ids) { // parents before their children
    if (!isNeeded[indexOf(id)]) continue;
    const Node& node = first[id];
    Node copy{.position = node.position, .radius = node.radius, .edge = node.edge};
    if (node.parent && agreement.isThere[indexOf(id)] && agreement.isAttached[indexOf(id)])
      copy.parent = copies[indexOf(*node.parent)];
    copies[indexOf(id)] = agreed.add(copy);
  }
  return agreed;
}

/// Of the length of a skeleton, that which is near another; 0 where that has no length.
double shareNear(const Skeleton& skeleton, const Skeleton& other, double tolerance,
                 const Progress& progress) {
  if (!(totalLength(other) > 0)) return 0;
  const Differences found = differences(skeleton, other, tolerance, progress);
  const double length = totalLength(skeleton);
  return length > 0 ? 1 - found.invented / length : 0;
}

} // namespace

Consensus consensusOf(std::span<const Skeleton> plants, double tolerance,
                      const Progress& progress) {
  assert(plants.size() >= 2);
  const Skeleton& first = plants.front();
  const double steps = 2 * static_cast<double>(plants.size()) - 1;
  double step = 0;
  const auto next = [&] {
    const double begun = step++;
    return progress.part(begun / steps, step / steps);
  };
  Agreement agreement{std::vector<bool>(first.idEnd(), true),
                      std::vector<bool>(first.idEnd(), true)};
  Consensus consensus;
  for (std::size_t i = 1; i < plants.size(); ++i) {
    const Differences found = differences(first, plants[i], tolerance, next());
    restrictTo(agreement, found);
    std::vector<DifferingPart> parts = found.parts;
    for (DifferingPart& part : turnedParts(first, plants[i], found)) {
      for (const NodeId id : part.nodes)
        agreement.isThere[indexOf(id)] = false;
      parts.push_back(std::move(part));
    }
    std::ranges::stable_sort(parts, std::greater(), &DifferingPart::length);
    for (DifferingPart& part : parts)
      consensus.places.push_back({.with = i, .part = std::move(part)});
  }
  consensus.agreed = agreedWood(first, agreement);
  for (const Skeleton& plant : plants)
    consensus.shares.push_back(shareNear(plant, consensus.agreed, tolerance, next()));
  return consensus;
}

} // namespace espalier
