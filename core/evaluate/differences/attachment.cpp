#include "core/evaluate/differences/attachment.h"

#include "core/skeleton/edge_index.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
Attachments::Attachments(const Skeleton& result, const Skeleton& reference,
                         const std::vector<Difference>& kinds, double tolerance)
    : result_(result), reference_(reference), tolerance_(tolerance), slack_(4 * tolerance),
      height_(reference.idEnd(), 0), first_(reference.idEnd(), 0), last_(reference.idEnd(), 0),
      places_(result.idEnd()), standing_(reference.idEnd()) {
  measureReference();
  placeNodes(kinds);
}

void Attachments::measureReference() {
  for (const NodeId id : reference_.ids())
    if (const auto parent = reference_[id].parent)
      height_[indexOf(id)] = height_[indexOf(*parent)] + edgeLength(reference_, id);
  std::size_t number = 0; // depth first, so that what a node carries is one range
  struct Visit {
    NodeId id;
    bool isLeft;
  };
  std::vector<Visit> open;
  for (const NodeId root : reference_.roots())
    open.push_back({root, false});
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    if (visit.isLeft) {
      last_[indexOf(visit.id)] = number;
      continue;
    }
    first_[indexOf(visit.id)] = number++;
    open.push_back({visit.id, true});
    for (const NodeId child : reference_.children(visit.id))
      open.push_back({child, false});
  }
}

bool Attachments::isAncestor(NodeId ancestor, NodeId of) const {
  return first_[indexOf(ancestor)] <= first_[indexOf(of)] &&
         first_[indexOf(of)] < last_[indexOf(ancestor)];
}

bool Attachments::leadsTo(const Place& above, const Place& below) const {
  NodeId edge = below.edge;
  double down = 0;
  while (!isAncestor(edge, above.edge)) {
    const auto parent = reference_[edge].parent;
    if (!parent) return false; // of another tree
    down = below.height - height_[indexOf(*parent)];
    // Where on thick wood a branch sits is not known better than the wood is thick.
    if (down > slack_ + 2 * reference_[below.edge].radius) return false;
    edge = *parent;
  }
  return true;
}

void Attachments::placeNodes(const std::vector<Difference>& kinds) {
  const EdgeIndex edges(reference_);
  std::vector<Places> carried(result_.idEnd()); // of the node, or of the next below that stands
  std::vector<NodeId> suspects;
  const auto isAtMatch = [&](NodeId id) {
    const auto isMatch = [&](NodeId edge) { return kinds[indexOf(edge)] == Difference::matched; };
    return isMatch(id) || std::ranges::any_of(result_.children(id), isMatch);
  };
  for (const NodeId id : result_.ids()) {
    const Node& node = result_[id];
    const Places* below = node.parent ? &carried[indexOf(*node.parent)] : nullptr;
    Places near;
    if (isAtMatch(id))
      edges.within(Eigen::AlignedBox3d(node.position), tolerance_, [&](const EdgeBody& edge) {
        const double share = edge.body.nearestShare(node.position);
        const Eigen::Vector3d place = edge.body.at(share);
        if ((place - node.position).norm() > tolerance_) return;
        near.push_back(
            {edge.node, place, height_[indexOf(edge.node)] - (1 - share) * edge.body.length()});
      });
    std::ranges::sort(near, {}, [&](const Place& place) {
      return std::pair((place.position - node.position).norm(), place.edge);
    });
    if (near.empty()) {
      if (below != nullptr) carried[indexOf(id)] = *below;
      continue;
    }
    Places kept;
    if (below != nullptr && !below->empty())
      std::ranges::copy_if(near, std::back_inserter(kept), [&](const Place& place) {
        return std::ranges::any_of(*below, [&](const Place& from) { return leadsTo(place, from); });
      });
    if (kept.empty()) {
      suspects.push_back(id);
      kept = near;
    }
    if (node.parent && kinds[indexOf(id)] != Difference::matched) leaps_.push_back(id);
    places_[indexOf(id)] = carried[indexOf(id)] = kept;
    for (const Place& place : kept)
      standing_[indexOf(place.edge)].push_back({id, place.height, place.position});
  }
  findWrong(suspects);
}

/// Does the result have what is next below a node in the reference, yet bears the node far lower?
bool Attachments::leapsOver(NodeId id, const Attachment& right) const {
  std::optional<NodeId> below = result_[id].parent;
  while (below && places_[indexOf(*below)].empty())
    below = result_[*below].parent;
  if (!below || !right.host || *right.host == *below) return false;
  const Place& place = places_[indexOf(id)].front();
  double height = -std::numeric_limits<double>::infinity();
  for (const Place& each : places_[indexOf(*below)])
    if (each.height <= place.height && isAncestor(each.edge, place.edge))
      height = std::max(height, each.height);
  if (std::isinf(height)) return false; // it stands beside the path down, as near as is allowed
  return right.height - height > slack_ + 2 * reference_[place.edge].radius;
}

/// Of those that keep no place of what is below them, these are wrongly attached: those for which
/// there is something else to be attached to.
void Attachments::findWrong(const std::vector<NodeId>& suspects) {
  for (const NodeId id : suspects) {
    const Attachment right = below(places_[indexOf(id)].front(), id);
    if (right.host && right.host != result_[id].parent) wrong_.push_back({id, right});
  }
  for (const NodeId id : leaps_) {
    const auto isOf = [&](const WrongAttachment& each) { return each.node == id; };
    const Attachment right = below(places_[indexOf(id)].front(), id);
    if (std::ranges::none_of(wrong_, isOf) && leapsOver(id, right)) wrong_.push_back({id, right});
  }
}

/// What of the result stands next below a place of the reference, other than what `attached`
/// carries.
Attachment Attachments::below(const Place& place, NodeId attached) const {
  Attachment found{
      .host = std::nullopt, .place = place.position, .edge = reference_[place.edge].edge};
  for (std::optional<NodeId> edge = place.edge; edge; edge = reference_[*edge].parent) {
    const Standing* highest = nullptr;
    for (const Standing& standing : standing_[indexOf(*edge)])
      if (standing.height <= place.height &&
          (highest == nullptr || standing.height > highest->height) &&
          !result_.isAncestor(attached, standing.node))
        highest = &standing;
    const auto parent = reference_[*edge].parent;
    if (highest != nullptr) {
      found.host = highest->node;
      found.height = highest->height;
      if (*edge != place.edge) return found; // it leaves that edge at its upper end
      found.place = highest->position;
      if (parent && highest->height > height_[indexOf(*parent)] + tolerance_)
        found.edge = EdgeType::successor; // amid the edge that goes on
      return found;
    }
    found.edge = reference_[*edge].edge;
    if (parent) found.place = reference_[*parent].position;
  }
  return found;
}

Attachment Attachments::on(NodeId edge) const {
  const Eigen::Vector3d& place = reference_[edge].position;
  Attachment found{.host = std::nullopt, .place = place, .edge = EdgeType::branching};
  for (std::optional<NodeId> next = edge; next && !found.host; next = reference_[*next].parent) {
    double least = std::numeric_limits<double>::infinity();
    for (const Standing& standing : standing_[indexOf(*next)]) {
      const double distance = (result_[standing.node].position - place).norm();
      if (distance >= least) continue;
      least = distance;
      found.host = standing.node;
    }
  }
  return found;
}

std::vector<std::vector<NodeId>> Attachments::standsOn() const {
  std::vector<std::vector<NodeId>> edges(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (const Place& place : places_[i])
      edges[i].push_back(place.edge);
  return edges;
}

} // namespace espalier
