#pragma once

#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <vector>

namespace espalier {

/// The points that a growing skeleton has not come to yet. Each belongs to the node nearest to it
/// of those that it is in reach of; points near a node die.
class Attractors {
public:
  /// @param points    3 x N, finite [L]; must outlive this
  /// @param index     of the same points; must outlive this
  /// @param densities N, in [0, 1]; must outlive this
  Attractors(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
             const std::vector<float>& densities);

  /// Density of the point nearest to `place`. pre: N > 0
  [[nodiscard]] double densityAt(const Eigen::Vector3d& place) const;

  /// The living points that a new node would take: those within `kill` [L] of it, and those within
  /// `reach` [L] that are nearer to it than to their own. May run on many threads.
  [[nodiscard]] std::vector<Neighbor> metBy(const Eigen::Vector3d& place, double kill,
                                            double reach) const;

  /// Takes a new node, of what it met: points within `kill` [L] die, the others are its own from
  /// now on; not those that nodes added since have killed, or are nearer to. pre: nodes come in the
  /// order 0, 1, 2, ...
  void meet(std::uint32_t node, const std::vector<Neighbor>& met, double kill);

  /// The living points within `reach` [L], by their number.
  [[nodiscard]] std::vector<std::uint32_t> around(const Eigen::Vector3d& place, double reach) const;

  /// The living points of a node, by their number. Valid until the next call of meet(). May run on
  /// many threads, each for other nodes.
  [[nodiscard]] const std::vector<std::uint32_t>& of(std::uint32_t node);

  [[nodiscard]] bool isOf(std::uint32_t node, std::uint32_t point) const {
    return points_[point].owner == node;
  }
  /// Whether a node has been in reach of it.
  [[nodiscard]] bool isReached(std::uint32_t point) const { return points_[point].owner != none; }
  [[nodiscard]] Eigen::Vector3d position(std::uint32_t point) const {
    return places_.col(point).cast<double>();
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Eigen::Index dead() const { return dead_; }
  [[nodiscard]] Eigen::Index reached() const { return reached_; } // dead or with a node

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Point {
    float squaredDistance = std::numeric_limits<float>::infinity(); // to its node [L^2]; dead: -1
    std::uint32_t owner = none;                                     // its node
    [[nodiscard]] bool isAlive() const { return squaredDistance >= 0; }
  };
  const Eigen::Matrix3Xf& places_;
  const SpatialIndex& index_;
  const std::vector<float>& densities_;
  std::vector<Point> points_;
  std::vector<std::vector<std::uint32_t>> owned_; // by node; some are another's since, or dead
  Eigen::Index dead_ = 0;
  Eigen::Index reached_ = 0;
};

} // namespace espalier
