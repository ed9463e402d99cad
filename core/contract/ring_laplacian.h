#pragma once

#include "core/base/progress.h"
#include "core/base/sparse_ldlt.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

/// The Laplacian of a cloud by the triangles about each point, for points that move.
class RingLaplacian {
public:
  /// Rings are found once, among the `neighbors` nearest of each point.
  /// @throws Cancelled if `progress` asks to stop
  RingLaplacian(const Eigen::Matrix3Xf& points, int neighbors, const Progress& progress = {});

  /// Mean distance of each point to its ring [L]; 0 where it has none.
  [[nodiscard]] std::vector<double> extents(const Eigen::Matrix3Xd& places) const;

  /// Square root of the area of the triangles about each point [L]: a line has none, however far
  /// its points are apart. The extent of its ring where there are no triangles.
  [[nodiscard]] std::vector<double> sizes(const Eigen::Matrix3Xd& places) const;

  /// The matrix of the normal equations with cotangents at `places`:
  /// weight^2 L^T L + diagonal(holds^2).
  [[nodiscard]] SymmetricMatrix normalEquations(const Eigen::Matrix3Xd& places, double weight,
                                                const std::vector<double>& holds,
                                                const Progress& progress = {}) const;

private:
  /// Cotangent weights of a ring, by place in rings_; between 1/1000 and 1000.
  [[nodiscard]] std::vector<double> cotangents(const Eigen::Matrix3Xd& places,
                                               const Progress& progress) const;
  void findPattern(const Progress& progress);

  struct Use { // of a point, in the ring of another
    std::uint32_t row;
    std::uint32_t place; // in rings_
  };

  std::vector<std::vector<std::uint32_t>> rings_; // with noNeighbor for gaps
  std::vector<std::vector<Use>> uses_;            // by point
  SymmetricMatrix pattern_;                       // of L^T L; its values mean nothing
};

} // namespace espalier
