#include "core/skeleton/review_coverage.h"

namespace espalier {

double ReviewCoverage::share(ReviewState state) const {
  const auto at = static_cast<std::size_t>(state);
  if (totalNodes() == 0) return 0;
  if (totalLength() > 0) return length[at] / totalLength();
  return static_cast<double>(nodes[at]) / static_cast<double>(totalNodes());
}

ReviewState ReviewCoverage::state() const {
  if (isComplete()) return ReviewState::reviewed;
  return nodes[static_cast<std::size_t>(ReviewState::doubtful)] > 0 ? ReviewState::doubtful
                                                                    : ReviewState::toDo;
}

ReviewCoverage coverage(const Skeleton& skeleton) {
  return coverage(skeleton, skeleton.ids());
}

ReviewCoverage coverage(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  ReviewCoverage result;
  for (const NodeId id : nodes) {
    const Node& node = skeleton[id];
    const auto at = static_cast<std::size_t>(node.review.state);
    ++result.nodes[at];
    if (node.parent) result.length[at] += (node.position - skeleton[*node.parent].position).norm();
  }
  return result;
}

} // namespace espalier
