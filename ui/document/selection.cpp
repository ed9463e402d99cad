#include "ui/document/selection.h"

#include <algorithm>
#include <utility>

namespace espalier {

bool Selection::contains(NodeId id) const {
  return indexOf(id) < isChosen_.size() && isChosen_[indexOf(id)];
}

std::optional<NodeId> Selection::current() const {
  if (nodes_.empty()) return std::nullopt;
  return nodes_.back();
}

void Selection::set(std::vector<NodeId> nodes) {
  note(nodes_, false);
  std::erase_if(nodes, [this](NodeId id) {
    const bool isThere = contains(id);
    note({&id, 1}, true);
    return isThere;
  });
  if (nodes == nodes_) return;
  nodes_ = std::move(nodes);
  emit changed();
}

void Selection::toggle(NodeId id) {
  const bool wasChosen = contains(id);
  if (wasChosen)
    std::erase(nodes_, id);
  else
    nodes_.push_back(id);
  note({&id, 1}, !wasChosen);
  emit changed();
}

void Selection::keepThoseIn(const Skeleton& skeleton) {
  const auto isGone = [&](NodeId id) {
    if (skeleton.contains(id)) return false;
    note({&id, 1}, false);
    return true;
  };
  if (std::erase_if(nodes_, isGone) > 0) emit changed();
}

void Selection::note(std::span<const NodeId> nodes, bool areChosen) {
  for (const NodeId id : nodes) {
    if (indexOf(id) >= isChosen_.size()) isChosen_.resize(indexOf(id) + 1, false);
    isChosen_[indexOf(id)] = areChosen;
  }
}

} // namespace espalier
