#include "ui/view/skeleton_glyphs.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

NodeShape shapeOf(const Skeleton& skeleton, NodeId id) {
  if (!skeleton.contains(id)) return NodeShape::none;
  if (!skeleton[id].parent) return NodeShape::root;
  const std::vector<NodeId>& children = skeleton.children(id);
  if (children.empty()) return NodeShape::apex;
  const bool branches =
      children.size() > 1 || skeleton[children.front()].edge == EdgeType::branching;
  return branches ? NodeShape::branching : NodeShape::plain;
}

EdgeShape shapeOf(EdgeType type) {
  return type == EdgeType::successor ? EdgeShape::successor : EdgeShape::branching;
}

double medianLength(const std::vector<EdgeGlyph>& edges) {
  std::vector<float> lengths;
  for (const EdgeGlyph& edge : edges)
    if (edge.shape != EdgeShape::none)
      lengths.push_back(
          (Eigen::Vector3f(edge.child.data()) - Eigen::Vector3f(edge.parent.data())).norm());
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Which slots are those of these nodes.
std::vector<bool> flagsOf(const std::vector<NodeId>& nodes) {
  std::vector<bool> flags;
  for (const NodeId id : nodes) {
    if (indexOf(id) >= flags.size()) flags.resize(indexOf(id) + 1);
    flags[indexOf(id)] = true;
  }
  return flags;
}

} // namespace

void SlotRange::add(std::size_t slot) {
  begin = std::min(begin, slot);
  end = std::max(end, slot + 1);
}

void SkeletonGlyphs::rebuild(const Skeleton& skeleton, const Eigen::Vector3d& origin) {
  origin_ = origin;
  bounds_.setEmpty();
  nodes_.assign(skeleton.idEnd(), {});
  edges_.assign(skeleton.idEnd(), {});
  slots_.assign(skeleton.idEnd(), {});
  hidden_.clear();
  vivid_.reset();
  whole_.clear();
  colors_.reset();
  colorMap_.reset();
  selected_.assign(skeleton.idEnd(), false);
  for (const NodeId id : std::exchange(selection_, {})) {
    if (!skeleton.contains(id)) continue;
    selection_.push_back(id);
    selected_[indexOf(id)] = true;
  }
  for (const NodeId id : skeleton.ids()) {
    place(skeleton, id);
    shapeNode(skeleton, id);
    drawEdge(skeleton, id);
  }
  typicalLength_ = medianLength(edges_);
  changedNodes_ = changedEdges_ = {0, skeleton.idEnd()};
}

void SkeletonGlyphs::update(const Skeleton& skeleton, const SkeletonDelta& delta) {
  nodes_.resize(skeleton.idEnd());
  edges_.resize(skeleton.idEnd());
  slots_.resize(skeleton.idEnd());
  selected_.resize(skeleton.idEnd());
  for (const SkeletonDelta::Change& change : delta.changes) {
    if (vivid_ && !change.before && change.after) {
      vivid_->resize(std::max(vivid_->size(), nodes_.size()));
      const auto& parent = change.after->parent;
      if (!parent || !isFadedSlot(indexOf(*parent))) (*vivid_)[indexOf(change.id)] = true;
    }
    if (!whole_.empty() && !change.before && change.after && change.after->parent) {
      whole_.resize(std::max(whole_.size(), nodes_.size()));
      whole_[indexOf(change.id)] = whole_[indexOf(*change.after->parent)];
    }
    if (skeleton.contains(change.id)) place(skeleton, change.id);
    shapeNode(skeleton, change.id);
    // Whether a parent is an apex or branches depends on the edge that came or went.
    if (change.before && change.before->parent) shapeNode(skeleton, *change.before->parent);
    if (change.after && change.after->parent) shapeNode(skeleton, *change.after->parent);
  }
  for (const SkeletonDelta::Change& change : delta.changes) {
    drawEdge(skeleton, change.id);
    if (!skeleton.contains(change.id)) continue;
    for (const NodeId child : skeleton.children(change.id))
      drawEdge(skeleton, child);
  }
  // An edit of much of the plant, as a reconstruction is, may change what is typical of it.
  if (4 * delta.changes.size() > nodes_.size()) typicalLength_ = medianLength(edges_);
}

void SkeletonGlyphs::moveOrigin(const Eigen::Vector3d& origin) {
  if (origin == origin_) return;
  const Eigen::Vector3d shift = std::exchange(origin_, origin) - origin;
  const auto moved = [&](const std::array<float, 3>& place) {
    const Eigen::Vector3d at = Eigen::Vector3f(place.data()).cast<double>() + shift;
    const Eigen::Vector3f rounded = at.cast<float>();
    return std::array<float, 3>{rounded.x(), rounded.y(), rounded.z()};
  };
  for (NodeGlyph& node : nodes_)
    node.position = moved(node.position);
  for (EdgeGlyph& edge : edges_) {
    edge.parent = moved(edge.parent);
    edge.child = moved(edge.child);
  }
  changedNodes_ = changedEdges_ = {0, nodes_.size()};
}

void SkeletonGlyphs::place(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  bounds_.extend(node.position);
  const Eigen::Vector3f local = (node.position - origin_).cast<float>();
  NodeGlyph& glyph = nodes_[indexOf(id)];
  glyph.position = {local.x(), local.y(), local.z()};
  glyph.radius = static_cast<float>(node.radius);
  changedNodes_.add(indexOf(id));
}

void SkeletonGlyphs::shapeNode(const Skeleton& skeleton, NodeId id) {
  NodeGlyph& glyph = nodes_[indexOf(id)];
  if (!skeleton.contains(id)) glyph = {};
  slots_[indexOf(id)].node = shapeOf(skeleton, id);
  glyph.isUnitStart = skeleton.contains(id) && skeleton[id].isMarked;
  glyph.mark = skeleton.contains(id) ? markOf(indexOf(id)) : Mark::none;
  dressNode(indexOf(id));
}

void SkeletonGlyphs::drawEdge(const Skeleton& skeleton, NodeId id) {
  EdgeGlyph& edge = edges_[indexOf(id)];
  edge = {};
  slots_[indexOf(id)].edge = EdgeShape::none;
  changedEdges_.add(indexOf(id));
  if (!skeleton.contains(id) || !skeleton[id].parent) return;
  const NodeGlyph& child = nodes_[indexOf(id)];
  const NodeGlyph& parent = nodes_[indexOf(*skeleton[id].parent)];
  edge.parent = parent.position;
  // A twig is as thick as itself where it leaves the trunk, not as the trunk
  // (core/skeleton/frustum.h); by the radii that are shown.
  const bool isCylinder = skeleton[id].edge == EdgeType::branching || parent.radius == 0;
  edge.parentRadius = isCylinder ? child.radius : parent.radius;
  edge.child = child.position;
  edge.childRadius = child.radius;
  edge.mark = hoveredEdge_ == id ? Mark::hovered : Mark::none;
  slots_[indexOf(id)].edge = shapeOf(skeleton[id].edge);
  slots_[indexOf(id)].parent = indexOf(*skeleton[id].parent);
  dressEdge(indexOf(id));
}

void SkeletonGlyphs::dressNode(std::size_t slot) {
  NodeGlyph& node = nodes_[slot];
  node.shape = isHiddenSlot(slot) ? NodeShape::none : slots_[slot].node;
  node.fading = fadingOf(slot);
  node.color = colorOf(slot);
  changedNodes_.add(slot);
}

void SkeletonGlyphs::dressEdge(std::size_t slot) {
  EdgeGlyph& edge = edges_[slot];
  const bool isHidden = isHiddenSlot(slot) || isHiddenSlot(slots_[slot].parent);
  edge.shape = isHidden ? EdgeShape::none : slots_[slot].edge;
  edge.fading = fadingOf(slot);
  edge.color = colorOf(slot);
  changedEdges_.add(slot);
}

void SkeletonGlyphs::dressAll() {
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    dressNode(slot);
    dressEdge(slot);
  }
}

bool SkeletonGlyphs::isHiddenSlot(std::size_t slot) const {
  return slot < hidden_.size() && hidden_[slot];
}

bool SkeletonGlyphs::isFadedSlot(std::size_t slot) const {
  return vivid_ && !(slot < vivid_->size() && (*vivid_)[slot]);
}

Fading SkeletonGlyphs::fadingOf(std::size_t slot) const {
  if (isFadedSlot(slot)) return Fading::faded;
  return slot < whole_.size() && whole_[slot] ? Fading::whole : Fading::byDepth;
}

std::array<std::uint8_t, 4> SkeletonGlyphs::colorOf(std::size_t slot) const {
  if (!colors_ || !colorMap_) return {};
  if (slot >= colors_->values.size() || std::isnan(colors_->values[slot])) return {};
  const Color color = (*colorMap_)(colors_->values[slot]);
  return {color[0], color[1], color[2], 255};
}

bool SkeletonGlyphs::isHidden(NodeId id) const {
  return isHiddenSlot(indexOf(id));
}

void SkeletonGlyphs::setHidden(const std::vector<NodeId>& nodes) {
  hidden_ = flagsOf(nodes);
  dressAll();
}

void SkeletonGlyphs::setFaded(const std::optional<std::vector<NodeId>>& allBut) {
  vivid_.reset();
  if (allBut) vivid_ = flagsOf(*allBut);
  dressAll();
}

void SkeletonGlyphs::setWhole(const std::vector<NodeId>& nodes) {
  whole_ = flagsOf(nodes);
  dressAll();
}

void SkeletonGlyphs::setColorMap(std::optional<LegendColors> map) {
  colorMap_ = std::move(map);
  dressAll();
}

Mark SkeletonGlyphs::markOf(std::size_t slot) const {
  if (hoveredNode_ && indexOf(*hoveredNode_) == slot)
    return selected_[slot] ? Mark::both : Mark::hovered;
  return selected_[slot] ? Mark::selected : Mark::none;
}

void SkeletonGlyphs::mark(std::size_t slot, Mark mark) {
  if (slot >= nodes_.size() || slots_[slot].node == NodeShape::none) return;
  nodes_[slot].mark = mark;
  changedNodes_.add(slot);
}

void SkeletonGlyphs::select(const std::vector<NodeId>& nodes) {
  const std::vector<NodeId> before = std::exchange(selection_, nodes);
  for (const NodeId id : before)
    selected_[indexOf(id)] = false;
  std::erase_if(selection_, [&](NodeId id) { return indexOf(id) >= nodes_.size(); });
  for (const NodeId id : selection_)
    selected_[indexOf(id)] = true;
  for (const NodeId id : before)
    mark(indexOf(id), markOf(indexOf(id)));
  for (const NodeId id : selection_)
    mark(indexOf(id), markOf(indexOf(id)));
}

bool SkeletonGlyphs::hover(const Pick& pick) {
  const auto oldNode = std::exchange(hoveredNode_, pick.node);
  const auto oldEdge =
      std::exchange(hoveredEdge_, pick.edge ? std::optional(pick.edge->child) : std::nullopt);
  for (const auto& node : {oldNode, hoveredNode_})
    if (node && indexOf(*node) < nodes_.size()) mark(indexOf(*node), markOf(indexOf(*node)));
  for (const auto& edge : {oldEdge, hoveredEdge_}) {
    if (!edge || indexOf(*edge) >= edges_.size()) continue;
    edges_[indexOf(*edge)].mark = hoveredEdge_ == edge ? Mark::hovered : Mark::none;
    changedEdges_.add(indexOf(*edge));
  }
  return oldNode != hoveredNode_ || oldEdge != hoveredEdge_;
}

Eigen::Vector3d SkeletonGlyphs::position(std::size_t slot) const {
  return origin_ + Eigen::Vector3f(nodes_[slot].position.data()).cast<double>();
}

} // namespace espalier
