#pragma once

#include <Eigen/Core>

namespace espalier {

/// How many points fit into a frame, learned from how long the last frames took.
class DetailBudget {
public:
  /// Points that can be drawn in a frame of this length; so many at least, however short.
  [[nodiscard]] Eigen::Index points(double milliseconds, Eigen::Index atLeast = 20'000) const;
  void measured(Eigen::Index points, double milliseconds);

private:
  double base_ = 8;        // [ms], a frame without points
  double perPoint_ = 3e-4; // [ms]
};

} // namespace espalier
