#include "ui/document/selection.h"

#include <algorithm>
#include <utility>

namespace espalier {

bool Selection::contains(NodeId id) const {
  return std::ranges::find(nodes_, id) != nodes_.end();
}

std::optional<NodeId> Selection::current() const {
  if (nodes_.empty()) return std::nullopt;
  return nodes_.back();
}

void Selection::set(std::vector<NodeId> nodes) {
  if (nodes == nodes_) return;
  nodes_ = std::move(nodes);
  emit changed();
}

void Selection::toggle(NodeId id) {
  if (std::erase(nodes_, id) == 0) nodes_.push_back(id);
  emit changed();
}

void Selection::keepThoseIn(const Skeleton& skeleton) {
  if (std::erase_if(nodes_, [&](NodeId id) { return !skeleton.contains(id); }) > 0) emit changed();
}

} // namespace espalier
