#include "core/skeleton/short_foot.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// Where a stem leads to below its root, by a stretch as long as it is thick; none without length.
std::optional<Eigen::Vector3d> downward(const Skeleton& skeleton, NodeId root, double reach) {
  Eigen::Vector3d back = Eigen::Vector3d::Zero();
  for (auto at = nextOnAxis(skeleton, root); at && back.norm() < reach;
       at = nextOnAxis(skeleton, *at))
    back = skeleton[root].position - skeleton[*at].position;
  return back.isZero(0) ? std::nullopt : std::optional(back.normalized());
}

/// The points at each root and at the edges that begin there, by id of the root.
std::map<NodeId, std::vector<Eigen::Index>> pointsAtRoots(const Skeleton& skeleton,
                                                          const PointDistances& distances) {
  std::map<NodeId, std::vector<Eigen::Index>> points;
  for (const NodeId root : skeleton.roots())
    points[root]; // also those without
  for (std::size_t i = 0; i < distances.nearest().size(); ++i) {
    const NodeId owner = distances.nearest()[i];
    const NodeId root = skeleton[owner].parent.value_or(owner);
    if (!skeleton[root].parent) points[root].push_back(static_cast<Eigen::Index>(i));
  }
  return points;
}

} // namespace

std::vector<Finding> shortFeet(const Skeleton& skeleton, const PointDistances& distances,
                               double spacing, const CheckOptions& options,
                               const Progress& progress) {
  std::vector<Finding> findings;
  if (skeleton.isEmpty()) return findings;
  const PointCloud& cloud = *distances.cloud();
  for (const auto& [root, points] : pointsAtRoots(skeleton, distances)) {
    progress.check();
    const auto first = nextOnAxis(skeleton, root);
    if (!first) continue;
    const double radius = std::max(skeleton[root].radius, skeleton[*first].radius);
    const auto along = downward(skeleton, root, std::max(4 * radius, 8 * spacing));
    if (!along) continue;
    std::vector<std::pair<double, Eigen::Index>> below; // how far, and which point
    for (const Eigen::Index i : points) {
      const Eigen::Vector3d offset = cloud.position(i) - skeleton[root].position;
      const double depth = offset.dot(*along);
      const double aside = (offset - depth * *along).norm();
      if (depth > 0 && aside < 2 * radius + 4 * spacing) below.emplace_back(depth, i);
    }
    std::ranges::sort(below);
    const double gap = options.clusterGap * spacing;
    Finding finding{.kind = Finding::Kind::shortFoot, .node = root};
    for (const auto& [depth, point] : below) {
      if (depth > finding.amount + gap) break;
      finding.amount = depth;
      finding.points.push_back(point);
    }
    if (finding.points.size() < static_cast<std::size_t>(options.clusterSize)) continue;
    if (finding.amount <= std::max(options.footSpacings * spacing, options.footRadii * radius))
      continue;
    std::ranges::sort(finding.points);
    place(finding, cloud);
    findings.push_back(std::move(finding));
  }
  return findings;
}

} // namespace espalier
