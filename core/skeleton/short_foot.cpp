#include "core/skeleton/short_foot.h"

#include "core/skeleton/axes.h"

#include <algorithm>
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

} // namespace

std::vector<Finding> shortFeet(const Skeleton& skeleton, const PointDistances& distances,
                               double spacing, const CheckOptions& options) {
  std::vector<Finding> findings;
  const PointCloud& cloud = *distances.cloud();
  for (const NodeId root : skeleton.roots()) {
    const auto first = nextOnAxis(skeleton, root);
    if (!first) continue;
    const double radius = std::max(skeleton[root].radius, skeleton[*first].radius);
    const auto along = downward(skeleton, root, std::max(4 * radius, 8 * spacing));
    if (!along) continue;
    std::vector<std::pair<double, Eigen::Index>> below; // how far, and which point
    for (Eigen::Index i = 0; i < cloud.size(); ++i) {
      const NodeId owner = distances.nearest()[static_cast<std::size_t>(i)];
      if (owner != root && skeleton[owner].parent != root) continue;
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
