#pragma once

#include "core/base/progress.h"
#include "core/base/sparse_ldlt.h"
#include "core/graph/neighborhoods.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// The Laplacian of a cloud by the triangles about each point, for points that move.
class RingLaplacian {
public:
  /// Rings are found once, among the `neighbors` nearest of each point.
  /// @throws Cancelled if `progress` asks to stop
  RingLaplacian(const Eigen::Matrix3Xf& points, int neighbors, const Progress& progress = {});

  /// Mean distance of each point to its ring [L]; 0 where it has none.
  [[nodiscard]] std::vector<double> extents(const Eigen::Matrix3Xd& places,
                                            const Progress& progress = {}) const;

  /// Square root of the area of the triangles about each point [L]: a line has none, however far
  /// its points are apart. The extent of its ring where there are no triangles.
  [[nodiscard]] std::vector<double> sizes(const Eigen::Matrix3Xd& places,
                                          const Progress& progress = {}) const;

  /// Where the normal equations have entries.
  [[nodiscard]] const SymmetricPattern& pattern() const { return pattern_; }

  /// The entries of the normal equations with cotangents at `places`:
  /// weight^2 L^T L + diagonal(holds^2).
  [[nodiscard]] Eigen::VectorXd normalEquations(const Eigen::Matrix3Xd& places, double weight,
                                                const std::vector<double>& holds,
                                                const Progress& progress = {}) const;

private:
  struct Use { // of a point, in the ring of another
    std::uint32_t row;
    std::uint32_t place; // in that ring
  };

  /// Cotangent weights of the rings, by place in rings_.members; between 1/1000 and 1000.
  [[nodiscard]] Eigen::VectorXd cotangents(const Eigen::Matrix3Xd& places,
                                           const Progress& progress) const;
  void findUses(const Progress& progress);
  void findPattern(const Progress& progress);
  [[nodiscard]] std::span<const Use> usesOf(Eigen::Index point) const {
    const auto i = static_cast<std::size_t>(point);
    return {uses_.data() + usesBegin_[i], uses_.data() + usesBegin_[i + 1]};
  }

  Neighborhoods rings_;                // with noNeighbor for gaps
  std::vector<std::size_t> usesBegin_; // by point: places in uses_
  std::vector<Use> uses_;
  SymmetricPattern pattern_; // of L^T L
};

} // namespace espalier
