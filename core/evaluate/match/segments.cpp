#include "core/evaluate/match/segments.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

void append(Segment& segment, const Eigen::Vector3d& position) {
  if (!segment.polyline.empty()) segment.length += (position - segment.polyline.back()).norm();
  segment.polyline.push_back(position);
  segment.box.extend(position);
}

/// Greatest squared distance from a vertex of `from` to its nearest of `to`, or `atLeast`.
double directedSquared(const std::vector<Eigen::Vector3d>& from,
                       const std::vector<Eigen::Vector3d>& to, double atLeast) {
  double greatest = atLeast;
  for (const Eigen::Vector3d& place : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& other : to) {
      nearest = std::min(nearest, (place - other).squaredNorm());
      if (nearest <= greatest) break; // this vertex cannot raise the greatest any more
    }
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

} // namespace

std::vector<Segment> unbranchedSegments(const Skeleton& skeleton) {
  std::vector<Segment> segments;
  std::vector<std::size_t> segmentOf(skeleton.idEnd());
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    std::size_t& segment = segmentOf[indexOf(id)];
    if (node.parent && skeleton.children(*node.parent).size() == 1) {
      segment = segmentOf[indexOf(*node.parent)];
    } else {
      segment = segments.size();
      segments.emplace_back();
      if (node.parent) {
        segments.back().parent = segmentOf[indexOf(*node.parent)];
        append(segments.back(), skeleton[*node.parent].position);
      }
    }
    segments[segment].nodes.push_back(id);
    append(segments[segment], node.position);
  }
  return segments;
}

double vertexHausdorff(const std::vector<Eigen::Vector3d>& a,
                       const std::vector<Eigen::Vector3d>& b) {
  assert(!a.empty() && !b.empty());
  return std::sqrt(directedSquared(b, a, directedSquared(a, b, 0)));
}

} // namespace espalier
