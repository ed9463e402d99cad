#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace espalier {

/// The space that wood has taken so far while a plant grows: a sparse grid of balls along its axes.
class Occupancy {
public:
  struct Ball {
    Eigen::Vector3d center; // [L]
    double radius = 0;      // [L]
  };

  explicit Occupancy(double cell) : cell_(cell) {} // [L], pre: > 0

  void add(const Ball& ball);

  /// Calls visit(ball) for each ball whose center is within one cell of `place`, and maybe others.
  template <class Visit> void visitNear(const Eigen::Vector3d& place, const Visit& visit) const {
    const Cell center = cellOf(place);
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto found = balls_.find(keyOf(center + Cell(dx, dy, dz)));
          if (found == balls_.end()) continue;
          for (const Ball& ball : found->second)
            visit(ball);
        }
  }

private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;
  [[nodiscard]] Cell cellOf(const Eigen::Vector3d& place) const;
  [[nodiscard]] static std::uint64_t keyOf(const Cell& cell);

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Ball>> balls_;
};

} // namespace espalier
