#pragma once

#include "core/graph/geodesic_balls.h"

#include <Eigen/Core>

#include <span>

namespace espalier {

/// The length of links as each of several centers sees it, by its own direction: the root of
/// along a^2 + across b^2, for a link of a along the direction and b across.
class StretchedLength {
public:
  using Lanes = GeodesicBalls::Lanes;

  /// @param directions one per center, unit; a center without one (zero) stretches nothing
  StretchedLength(const Eigen::Matrix3Xf& points, std::span<const Eigen::Vector3f> directions,
                  double along, double across)
      : points_(points), x_(Lanes::Zero()), y_(Lanes::Zero()), z_(Lanes::Zero()),
        along_(Lanes::Ones()), across_(Lanes::Ones()) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto lane = static_cast<Eigen::Index>(i);
      if (directions[i].isZero()) continue; // it knows no along
      x_[lane] = directions[i].x();
      y_[lane] = directions[i].y();
      z_[lane] = directions[i].z();
      along_[lane] = static_cast<float>(along);
      across_[lane] = static_cast<float>(across);
    }
  }

  Lanes operator()(std::uint32_t from, const NeighborhoodGraph::Link& link) const {
    const Eigen::Vector3f d = points_.col(link.to) - points_.col(from);
    const Lanes along = (x_ * d.x() + y_ * d.y() + z_ * d.z()).square();
    const Lanes across = (link.length * link.length - along).max(0.0F);
    return (along_ * along + across_ * across).sqrt();
  }

private:
  const Eigen::Matrix3Xf& points_;
  Lanes x_;
  Lanes y_;
  Lanes z_;
  Lanes along_;
  Lanes across_;
};

} // namespace espalier
