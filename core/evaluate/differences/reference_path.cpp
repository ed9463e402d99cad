#include "core/evaluate/differences/reference_path.h"

#include <cmath>
#include <optional>

namespace espalier {

std::vector<NodeId> referencePath(const Differences& found, const Skeleton& reference,
                                  const DifferingPart& part) {
  if (part.kind != Difference::wronglyAttached) return {};
  const std::vector<NodeId>& edges = found.standsOn[indexOf(part.attached)];
  if (edges.empty()) return {};
  std::vector<NodeId> path;
  for (std::optional<NodeId> edge = edges.front(); edge; edge = reference[*edge].parent) {
    path.push_back(*edge);
    const auto& parent = reference[*edge].parent;
    if (!parent) break;
    const Eigen::Vector3d& start = reference[*parent].position;
    const Eigen::Vector3d along = reference[*edge].position - start;
    const double rest = along.norm() - (part.place - start).norm() -
                        (part.place - reference[*edge].position).norm();
    if (std::abs(rest) <= 1e-9 * (along.norm() + start.norm())) break; // the place is on the edge
  }
  return path;
}

} // namespace espalier
