#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Points by the cubes of an even grid that they lie in.
///
/// Deterministic. Build O(N log N) on all threads; memory 16 bytes a point.
class Voxels {
public:
  using Place = Eigen::Matrix<std::int32_t, 3, 1>; // of a cube, in cubes from the least corner

  /// @param edge  of a cube [L] > 0; made larger if the points are over 10^6 cubes wide
  /// @throws Cancelled if `progress` asks to stop
  Voxels(const Eigen::Matrix3Xf& points, double edge, const Progress& progress = {});

  [[nodiscard]] double edge() const { return edge_; }              // [L]
  [[nodiscard]] std::size_t count() const { return keys_.size(); } // cubes that hold points
  /// The points of a cube, ascending.
  [[nodiscard]] std::span<const std::uint32_t> members(std::size_t cube) const {
    return {members_.data() + begin_[cube], members_.data() + begin_[cube + 1]};
  }
  [[nodiscard]] Place place(std::size_t cube) const;
  [[nodiscard]] std::optional<std::size_t> find(const Place& place) const; // O(log count)
  /// The cube of each point.
  [[nodiscard]] std::vector<std::uint32_t> ofPoints() const;
  /// The mean of the points in each cube [L].
  /// @throws Cancelled if `progress` asks to stop, which it is asked alone
  [[nodiscard]] Eigen::Matrix3Xf means(const Eigen::Matrix3Xf& points,
                                       const Progress& progress = {}) const;

private:
  double edge_;
  std::vector<std::uint64_t> keys_; // ascending
  std::vector<std::size_t> begin_;  // count() + 1
  std::vector<std::uint32_t> members_;
};

} // namespace espalier
