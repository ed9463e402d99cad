#include "core/skeleton/skeleton.h"

#include "core/base/shown_message.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace espalier {
namespace {

/// Whether a parent is known, without a walk to the root, to be none of what a node carries: it is
/// the node's own, that one's, or a sibling.
bool isBelowOrBeside(const Node& node, NodeId parent, const Skeleton& skeleton) {
  return node.parent && (node.parent == parent || skeleton[*node.parent].parent == parent ||
                         skeleton[parent].parent == node.parent);
}

} // namespace

std::vector<NodeId> Skeleton::ids() const {
  std::vector<NodeId> order = roots();
  order.reserve(size_);
  for (std::size_t next = 0; next < order.size(); ++next) {
    const std::vector<NodeId>& below = children(order[next]);
    order.insert(order.end(), below.begin(), below.end());
  }
  return order;
}

std::vector<NodeId> Skeleton::roots() const {
  std::vector<NodeId> result;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i] && !nodes_[i]->parent) result.push_back(NodeId{static_cast<std::uint32_t>(i)});
  return result;
}

bool Skeleton::contains(NodeId id) const {
  return indexOf(id) < nodes_.size() && nodes_[indexOf(id)].has_value();
}

const Node& Skeleton::operator[](NodeId id) const {
  assert(contains(id));
  return *nodes_[indexOf(id)];
}

const std::vector<NodeId>& Skeleton::children(NodeId id) const {
  assert(contains(id));
  return children_[indexOf(id)];
}

void Skeleton::reserve(std::size_t nodes) {
  nodes_.reserve(nodes);
  children_.reserve(nodes);
}

NodeId Skeleton::add(const Node& node) {
  if (node.parent && !contains(*node.parent))
    throw ShownError({Shown::tr("the parent, node %1, does not exist: choose another"),
                      {std::to_string(indexOf(*node.parent))}});
  const NodeId id{static_cast<std::uint32_t>(nodes_.size())};
  nodes_.emplace_back(node);
  children_.emplace_back();
  ++size_;
  link(id);
  return id;
}

void Skeleton::setPosition(NodeId id, const Eigen::Vector3d& position) {
  assert(contains(id));
  nodes_[indexOf(id)]->position = position;
}

void Skeleton::setRadius(NodeId id, double radius, const RadiusOrigin& origin) {
  assert(contains(id) && radius >= 0);
  nodes_[indexOf(id)]->radius = radius;
  nodes_[indexOf(id)]->origin = origin;
}

void Skeleton::setEdge(NodeId id, EdgeType edge) {
  assert(contains(id));
  unlink(id);
  nodes_[indexOf(id)]->edge = edge;
  link(id);
}

void Skeleton::setEntities(NodeId id, std::vector<Entity> entities) {
  assert(contains(id));
  nodes_[indexOf(id)]->entities = std::move(entities);
}

void Skeleton::setMarked(NodeId id, bool isMarked) {
  assert(contains(id));
  nodes_[indexOf(id)]->isMarked = isMarked;
}

void Skeleton::setReview(NodeId id, ReviewMark review) {
  assert(contains(id));
  nodes_[indexOf(id)]->review = std::move(review);
}

void Skeleton::reparent(NodeId id, NodeId parent, EdgeType edge) {
  assert(contains(id));
  if (!contains(parent))
    throw ShownError({Shown::tr("node %1 does not exist: choose another parent"),
                      {std::to_string(indexOf(parent))}});
  const bool isFree = children(id).empty() || isBelowOrBeside((*this)[id], parent, *this);
  if (id == parent || (!isFree && isAncestor(id, parent)))
    throw ShownError({Shown::tr("cannot attach node %1 to node %2, which it carries itself: choose "
                                "a parent outside its branch"),
                      {std::to_string(indexOf(id)), std::to_string(indexOf(parent))}});
  unlink(id);
  nodes_[indexOf(id)]->parent = parent;
  nodes_[indexOf(id)]->edge = edge;
  link(id);
}

void Skeleton::makeRoot(NodeId id) {
  assert(contains(id));
  unlink(id);
  nodes_[indexOf(id)]->parent.reset();
  nodes_[indexOf(id)]->edge = EdgeType::successor;
}

void Skeleton::erase(NodeId id) {
  assert(contains(id) && children(id).empty());
  unlink(id);
  nodes_[indexOf(id)].reset();
  --size_;
}

void Skeleton::restore(NodeId id, const Node& node) {
  assert(indexOf(id) < nodes_.size() && !contains(id));
  assert(!node.parent || contains(*node.parent));
  nodes_[indexOf(id)] = node;
  ++size_;
  link(id);
}

bool Skeleton::isAncestor(NodeId ancestor, NodeId of) const {
  for (std::optional<NodeId> at = of; at; at = (*this)[*at].parent)
    if (*at == ancestor) return true;
  return false;
}

bool Skeleton::operator==(const Skeleton& other) const {
  if (size_ != other.size_) return false;
  const std::size_t end = std::min(nodes_.size(), other.nodes_.size());
  return std::equal(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(end),
                    other.nodes_.begin()); // nodes past `end` would make the sizes differ
}

void Skeleton::link(NodeId id) {
  const Node& node = *nodes_[indexOf(id)];
  if (!node.parent) return;
  std::vector<NodeId>& siblings = children_[indexOf(*node.parent)];
  const auto comesFirst = [this](NodeId a, NodeId b) {
    const bool aContinues = nodes_[indexOf(a)]->edge == EdgeType::successor;
    const bool bContinues = nodes_[indexOf(b)]->edge == EdgeType::successor;
    return aContinues != bContinues ? aContinues : a < b;
  };
  siblings.insert(std::lower_bound(siblings.begin(), siblings.end(), id, comesFirst), id);
}

void Skeleton::unlink(NodeId id) {
  const Node& node = *nodes_[indexOf(id)];
  if (!node.parent) return;
  std::erase(children_[indexOf(*node.parent)], id);
}

std::string nameOf(NodeId id) {
  return "node " + std::to_string(indexOf(id));
}

} // namespace espalier
