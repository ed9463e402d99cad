#include "core/doubt/oracle.h"

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

std::size_t firstOf(const Doubt& doubt, Alternative::Kind kind) {
  const auto found = std::ranges::find(doubt.alternatives, kind, &Alternative::kind);
  return found == doubt.alternatives.end()
             ? doubt.present
             : static_cast<std::size_t>(found - doubt.alternatives.begin());
}

/// The path from the foot of a branch that would be added to its farthest tip.
std::vector<Eigen::Vector3d> longestPath(const Skeleton& part) {
  std::vector<double> depth(part.idEnd(), 0);
  NodeId tip = part.roots().front();
  for (const NodeId id : part.ids()) {
    if (const auto parent = part[id].parent)
      depth[indexOf(id)] = depth[indexOf(*parent)] + edgeLength(part, id);
    if (depth[indexOf(id)] > depth[indexOf(tip)]) tip = id;
  }
  std::vector<Eigen::Vector3d> places;
  for (std::optional<NodeId> at = tip; at; at = part[*at].parent)
    places.push_back(part[*at].position);
  std::ranges::reverse(places);
  return places;
}

} // namespace

Agreement agreementWith(const Skeleton& reference, const Skeleton& plant, double tolerance,
                        const Progress& progress) {
  const Differences found = differences(plant, reference, tolerance, progress);
  Agreement agreement{.missed = found.missed};
  for (const NodeId id : plant.ids())
    (found.ofResult[indexOf(id)] == Difference::matched ? agreement.right : agreement.wrong) +=
        edgeLength(plant, id);
  return agreement;
}

Oracle::Oracle(const Skeleton& reference, double tolerance)
    : known_(reference), tolerance_(tolerance) {}

std::size_t Oracle::answer(const Skeleton& plant, const Doubt& doubt) const {
  std::vector<Eigen::Vector3d> places; // from the foot on
  const std::size_t add = firstOf(doubt, Alternative::Kind::add);
  const bool isMissing = doubt.kind == Doubt::Kind::missing;
  if (isMissing) {
    places = longestPath(doubt.alternatives[add].branch->part);
  } else {
    if (const auto foot = plant[doubt.node].parent) places.push_back(plant[*foot].position);
    for (const NodeId id : doubt.nodes)
      places.push_back(plant[id].position);
  }
  std::vector<bool> isInDoubt(plant.idEnd(), false);
  for (const NodeId id : doubt.nodes)
    isInDoubt[indexOf(id)] = true;
  std::vector<EdgeBody> bodies;
  for (const NodeId id : plant.ids())
    if (!isInDoubt[indexOf(id)]) bodies.push_back({id, centerLine(plant, id)});
  const bool isThere = isWood(EdgeIndex(std::move(bodies)), places);
  if (isMissing) return isThere ? add : doubt.present;
  if (!isThere) return firstOf(doubt, Alternative::Kind::remove);
  return attachment(plant, doubt);
}

bool Oracle::isWood(const EdgeIndex& others, const std::vector<Eigen::Vector3d>& places) const {
  double length = 0;
  double near = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double edge = (places[i] - places[i - 1]).norm();
    const Eigen::Vector3d middle = (places[i] + places[i - 1]) / 2;
    const ReferencePlace place = known_.nearest(middle);
    length += edge;
    const bool isNear = place.distance < tolerance_ + 0.5 * known_.radiusAt(place);
    const auto other = others.nearest(place.position);
    if (isNear && (!other || other->distance > place.distance)) near += edge;
  }
  const ReferencePlace tip = known_.nearest(places.back());
  const double along = tip.depth - known_.below(tip, places.front()).depth;
  return near > 0.5 * length && along > 0.5 * length;
}

std::size_t Oracle::attachment(const Skeleton& plant, const Doubt& doubt) const {
  const NodeId up = doubt.nodes[std::min<std::size_t>(doubt.nodes.size() - 1, 2)];
  std::vector<WoodFrom> links;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < doubt.alternatives.size(); ++i) {
    const Alternative& one = doubt.alternatives[i];
    std::optional<NodeId> from = one.onto;
    if (one.kind == Alternative::Kind::asItIs) from = plant[doubt.node].parent;
    if (!from) continue;
    links.push_back({plant[*from].position, plant[up].position});
    which.push_back(i);
  }
  const std::vector<double> detour = detours(links, known_, tolerance_);
  const auto best = std::ranges::min_element(detour) - detour.begin();
  for (std::size_t i = 0; i < detour.size(); ++i)
    if (which[i] == doubt.present && !(detour[i] > tolerance_ / 2)) return doubt.present;
  return std::isfinite(detour[static_cast<std::size_t>(best)])
             ? which[static_cast<std::size_t>(best)]
             : doubt.present;
}

} // namespace espalier
