#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace espalier {

/// How much of what lies behind is seen through the surroundings of a place, cell by cell.
///
/// Each thing that is added covers a part of its cell. Lines of sight go through cells, so that
/// thousands of them cost no more than one look at the points. Deterministic.
class SightGrid {
public:
  /// @param box  that lines of sight run in [L], not empty; nothing beyond it covers anything
  SightGrid(const Eigen::AlignedBox3d& box, double cell);

  /// @param width  of what it covers across a line of sight [L]; of points, their spacing
  void add(const Eigen::Vector3d& place, double width);

  /// The share of a thing at `from` that is seen from `eye`, in [0, 1].
  /// @param beyond  nothing that near to it hides it [L]
  [[nodiscard]] double seen(const Eigen::Vector3d& from, const Eigen::Vector3d& eye,
                            double beyond) const;

  [[nodiscard]] double cell() const { return cell_; } // [L]

private:
  [[nodiscard]] const float* at(const Eigen::Vector3d& place) const; // null: outside

  Eigen::Vector3d low_;
  double cell_;
  Eigen::Vector3i cells_;
  std::vector<float> covered_; // by cell, x first; 1 and more: nothing is seen through it
};

} // namespace espalier
