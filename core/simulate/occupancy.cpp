#include "core/simulate/occupancy.h"

namespace espalier {

void Occupancy::add(const Ball& ball) {
  balls_[keyOf(cellOf(ball.center))].push_back(ball);
}

Occupancy::Cell Occupancy::cellOf(const Eigen::Vector3d& place) const {
  return (place / cell_).array().floor().cast<std::int64_t>();
}

std::uint64_t Occupancy::keyOf(const Cell& cell) {
  constexpr std::uint64_t mask = (1U << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x()) & mask) |
         (static_cast<std::uint64_t>(cell.y()) & mask) << 21 |
         (static_cast<std::uint64_t>(cell.z()) & mask) << 42;
}

} // namespace espalier
