#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

/// Sums up the points in balls without a look at each of them.
///
/// A k-d tree whose parts know the sum of their points: parts that lie in the ball as a whole are
/// added as a whole. Build O(N log N); a query takes as long as the surface of the ball is large,
/// not its inside. Queries are const and may run on many threads.
class BallSums {
public:
  struct Sum {
    Eigen::Vector3d positions = Eigen::Vector3d::Zero(); // [L]
    std::int64_t count = 0;

    void operator+=(const Sum& other) {
      positions += other.positions;
      count += other.count;
    }
  };

  /// @param points 3 x N, finite [L]; copied
  /// @throws Cancelled if `progress` asks to stop
  explicit BallSums(const Eigen::Matrix3Xf& points, const Progress& progress = {});

  /// Of the points within `radius` [L] of `place`.
  [[nodiscard]] Sum within(const Eigen::Vector3f& place, float radius) const;

private:
  struct Part {
    Eigen::Vector3f low;
    Eigen::Vector3f high;
    std::uint32_t begin; // of its points
    std::uint32_t end;
    std::uint32_t left = 0; // first of its two parts, which lie side by side; 0: none
    Sum sum;
  };

  void split(std::uint32_t part, std::vector<std::uint32_t>& order, const Eigen::Matrix3Xf& points);

  std::vector<Part> parts_;
  Eigen::Matrix3Xf points_; // in the order of the parts
};

} // namespace espalier
