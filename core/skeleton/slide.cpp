#include "core/skeleton/slide.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr double clearance = 0.05; // of an edge, from its other end
constexpr double outreach = 10;    // lengths of the edge, beyond an end of the axis

/// The paths from a node: each straight, from the node by a vector [L].
std::vector<Vector3d> pathsFrom(const Vector3d& from, const std::vector<Vector3d>& neighbors) {
  std::vector<Vector3d> paths;
  for (const Vector3d& neighbor : neighbors)
    if (neighbor != from) paths.emplace_back((1 - clearance) * (neighbor - from));
  if (neighbors.size() == 1 && !paths.empty())
    paths.emplace_back(outreach * (from - neighbors.front()));
  return paths;
}

} // namespace

std::optional<Vector3d> slidAlongAxis(const Skeleton& skeleton, NodeId id, const Vector3d& from,
                                      const Eigen::ParametrizedLine<double, 3>& sight) {
  std::vector<Vector3d> neighbors;
  if (const auto parent = skeleton[id].parent) neighbors.push_back(skeleton[*parent].position);
  if (const auto next = nextOnAxis(skeleton, id)) neighbors.push_back(skeleton[*next].position);
  const auto aside = [&](const Vector3d& path) -> Vector3d { // as the eye sees it
    return path - path.dot(sight.direction()) * sight.direction();
  };
  const Vector3d off = aside(sight.origin() - from);
  std::optional<Vector3d> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3d& path : pathsFrom(from, neighbors)) {
    const Vector3d seen = aside(path);
    const double length = seen.squaredNorm();
    const double share = length > 0 ? std::clamp(off.dot(seen) / length, 0.0, 1.0) : 0;
    const double distance = (off - share * seen).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = from + share * path;
  }
  return best;
}

} // namespace espalier
