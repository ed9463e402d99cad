#include "core/cloud/sight_grid.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr int mostCells = 160; // along a side: 16 MB

} // namespace

SightGrid::SightGrid(const Eigen::AlignedBox3d& box, double cell)
    : low_(box.min()), cell_(std::max(cell, box.sizes().maxCoeff() / mostCells)) {
  cells_ = (box.sizes() / cell_).array().ceil().cast<int>().max(1);
  covered_.resize(std::size_t(cells_.x()) * std::size_t(cells_.y()) * std::size_t(cells_.z()));
}

const float* SightGrid::at(const Eigen::Vector3d& place) const {
  const Eigen::Array3d from = (place - low_).array() / cell_;
  if (!(from >= 0).all() || !(from < cells_.cast<double>().array()).all()) return nullptr;
  const Eigen::Array3i in = from.cast<int>();
  return &covered_[std::size_t(in.x()) +
                   std::size_t(cells_.x()) *
                       (std::size_t(in.y()) + std::size_t(cells_.y()) * std::size_t(in.z()))];
}

void SightGrid::add(const Eigen::Vector3d& place, double width) {
  const float* found = at(place);
  if (found == nullptr) return;
  covered_[std::size_t(found - covered_.data())] += float(width * width / (cell_ * cell_));
}

double SightGrid::seen(const Eigen::Vector3d& from, const Eigen::Vector3d& eye,
                       double beyond) const {
  const double away = (eye - from).norm();
  double seen = 1;
  if (away <= 0) return seen;
  const Eigen::Vector3d step = (eye - from) / away;
  constexpr double dark = 0.01;
  for (double along = beyond; along < away && seen > dark; along += cell_) {
    const float* covered = at(from + along * step);
    if (covered == nullptr) break; // nothing covers anything beyond the box
    seen *= 1 - std::min(1.0F, *covered);
  }
  return seen;
}

} // namespace espalier
