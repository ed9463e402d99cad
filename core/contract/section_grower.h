#pragma once

#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace espalier {

/// Grows cross-sections of wood from points, again and again, without new memory. One per thread.
class SectionGrower {
public:
  SectionGrower(const Eigen::Matrix3Xf& points, const NeighborhoodGraph& graph)
      : points_(points), graph_(graph), isMet_(static_cast<std::size_t>(points.cols()), 0) {}

  /// The points that links lead to from `center` within `width` of it along `direction` and
  /// `radius` across, itself first. Valid until the next call. Time O(k m) for m points.
  const std::vector<std::uint32_t>& around(std::uint32_t center, const Eigen::Vector3f& direction,
                                           float width, float radius) {
    for (const std::uint32_t point : members_)
      isMet_[point] = 0;
    members_.assign(1, center);
    isMet_[center] = 1;
    const Eigen::Vector3f origin = points_.col(center);
    for (std::size_t next = 0; next < members_.size(); ++next)
      for (const NeighborhoodGraph::Link& link : graph_.links(members_[next])) {
        if (isMet_[link.to] != 0) continue;
        const Eigen::Vector3f d = points_.col(link.to) - origin;
        const float along = d.dot(direction);
        if (std::abs(along) >= width || d.squaredNorm() - along * along >= radius * radius)
          continue;
        isMet_[link.to] = 1;
        members_.push_back(link.to);
      }
    return members_;
  }

private:
  const Eigen::Matrix3Xf& points_;
  const NeighborhoodGraph& graph_;
  std::vector<char> isMet_; // by point
  std::vector<std::uint32_t> members_;
};

} // namespace espalier
