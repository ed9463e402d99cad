#include "core/cloud/voxels.h"

#include "core/base/paced_check.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr int bitsPerAxis = 21;
constexpr std::int32_t mostCubes = 1'000'000; // along an axis

std::uint64_t keyOf(const Voxels::Place& place) {
  std::uint64_t key = 0;
  for (int axis = 2; axis >= 0; --axis)
    key = (key << bitsPerAxis) | static_cast<std::uint64_t>(place[axis] + 1); // -1 is outside
  return key;
}

} // namespace

Voxels::Voxels(const Eigen::Matrix3Xf& points, double edge, const Progress& progress)
    : edge_(edge) {
  if (points.cols() == 0) {
    begin_ = {0};
    return;
  }
  const Eigen::Vector3d least = points.rowwise().minCoeff().cast<double>();
  const Eigen::Vector3d size = points.rowwise().maxCoeff().cast<double>() - least;
  edge_ = std::max(edge, size.maxCoeff() / (mostCubes - 1));
  struct Keyed {
    std::uint64_t key;
    std::uint32_t point;
  };
  std::vector<Keyed> all(static_cast<std::size_t>(points.cols()));
  parallelFor(
      points.cols(),
      [&](Eigen::Index i) {
        const Place at =
            ((points.col(i).cast<double>() - least) / edge_).array().floor().cast<std::int32_t>();
        all[static_cast<std::size_t>(i)] = {keyOf(at), static_cast<std::uint32_t>(i)};
      },
      progress.part(0, 0.2), 4096);
  parallelSort(all.begin(), all.end(), [&](const Keyed& a, const Keyed& b) {
    progress.check();
    return a.key != b.key ? a.key < b.key : a.point < b.point;
  });
  progress.update(0.9);
  members_.reserve(all.size());
  PacedCheck check(progress);
  for (const Keyed& one : all) {
    if (keys_.empty() || keys_.back() != one.key) {
      keys_.push_back(one.key);
      begin_.push_back(members_.size());
    }
    members_.push_back(one.point);
    check.after(4);
  }
  begin_.push_back(members_.size());
}

Voxels::Place Voxels::place(std::size_t cube) const {
  constexpr std::uint64_t mask = (std::uint64_t{1} << bitsPerAxis) - 1;
  Place result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = static_cast<std::int32_t>((keys_[cube] >> (bitsPerAxis * axis)) & mask) - 1;
  return result;
}

std::optional<std::size_t> Voxels::find(const Place& place) const {
  if (place.minCoeff() < 0 || place.maxCoeff() > mostCubes) return std::nullopt;
  const std::uint64_t key = keyOf(place);
  const auto found = std::ranges::lower_bound(keys_, key);
  if (found == keys_.end() || *found != key) return std::nullopt;
  return static_cast<std::size_t>(found - keys_.begin());
}

std::vector<std::uint32_t> Voxels::ofPoints() const {
  std::vector<std::uint32_t> result(members_.size());
  for (std::size_t cube = 0; cube < count(); ++cube)
    for (const std::uint32_t point : members(cube))
      result[point] = static_cast<std::uint32_t>(cube);
  return result;
}

Eigen::Matrix3Xf Voxels::means(const Eigen::Matrix3Xf& points, const Progress& progress) const {
  PacedCheck check(progress);
  Eigen::Matrix3Xf result(3, static_cast<Eigen::Index>(count()));
  for (std::size_t cube = 0; cube < count(); ++cube) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t point : members(cube))
      sum += points.col(point).cast<double>();
    check.after(10 * members(cube).size());
    result.col(static_cast<Eigen::Index>(cube)) =
        (sum / static_cast<double>(members(cube).size())).cast<float>();
  }
  return result;
}

} // namespace espalier
