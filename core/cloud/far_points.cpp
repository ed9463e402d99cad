#include "core/cloud/far_points.h"

#include "core/cloud/repeated_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <unordered_map>

namespace espalier {
namespace {

using Places = std::function<Eigen::Vector3d(Eigen::Index)>;

/// The box of the points but for the least and greatest sixteenth along each axis.
Eigen::AlignedBox3d middleBox(Eigen::Index count, const Places& place) {
  constexpr Eigen::Index samples = 4096;
  const Eigen::Index taken = std::min(count, samples);
  std::array<std::vector<double>, 3> values;
  for (Eigen::Index i = 0; i < taken; ++i) {
    const Eigen::Vector3d at = place(i * count / taken);
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[axis].push_back(at[static_cast<Eigen::Index>(axis)]);
  }
  const auto at = [](std::vector<double>& of, Eigen::Index rank) {
    std::nth_element(of.begin(), of.begin() + rank, of.end());
    return of[static_cast<std::size_t>(rank)];
  };
  Eigen::AlignedBox3d box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto side = static_cast<Eigen::Index>(axis);
    box.min()[side] = at(values[axis], taken / 16);
    box.max()[side] = at(values[axis], taken - 1 - taken / 16);
  }
  return box;
}

using Cell = std::array<double, 3>; // whole numbers; doubles, for places however far

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const double number : cell)
      hash = (hash ^ std::hash<double>()(number)) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(hash ^ hash >> 32);
  }
};

/// Points by cubes, and the parts that these make: cubes that touch belong together.
class CubeParts {
public:
  CubeParts(double side, const Eigen::AlignedBox3d& around)
      : side_(side), around_(around), corner_(around.min()) {}

  void add(const Eigen::Vector3d& place) {
    if (around_.contains(place)) return addAround(place);
    ++cubes_[cellOf(place)].points;
  }

  /// Marks what belongs to a part of at most `most` points, none of them in the box.
  void markFar(Eigen::Index most) {
    for (auto& [cell, cube] : cubes_)
      if (!cube.isMet) markPart(cell, most);
  }

  /// pre: it was added, and is not in the box
  [[nodiscard]] bool isFar(const Eigen::Vector3d& place) const {
    return cubes_.at(cellOf(place)).isFar;
  }

private:
  struct Cube {
    Eigen::Index points = 0;
    bool isAround = false; // one of them at least is in the box
    bool isMet = false;
    bool isFar = false;
  };

  [[nodiscard]] Cell cellOf(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d in = (place - corner_) / side_;
    return {std::floor(in.x()), std::floor(in.y()), std::floor(in.z())};
  }

  /// Nearly all points lie in the box, which is six cubes wide. How many there are in a cube has no
  /// meaning, so only the first of each is sought in the map.
  void addAround(const Eigen::Vector3d& place) {
    const Eigen::Array<std::size_t, 3, 1> cell =
        ((place - corner_) / side_).cast<std::size_t>(); // none is below 0
    bool& isKnown = isAround_[(cell.x() * wide + cell.y()) * wide + cell.z()];
    if (isKnown) return;
    isKnown = true;
    cubes_[cellOf(place)].isAround = true;
  }

  void markPart(const Cell& first, Eigen::Index most) {
    std::vector<Cell> part = {first};
    cubes_.at(first).isMet = true;
    Eigen::Index points = 0;
    bool isAround = false;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const Cell cell = part[next];
      const Cube& cube = cubes_.at(cell);
      points += cube.points;
      isAround = isAround || cube.isAround;
      for (int side = 0; side < 27; ++side) {
        const std::array<int, 3> steps = {side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1};
        const Cell beside = {cell[0] + steps[0], cell[1] + steps[1], cell[2] + steps[2]};
        const auto found = cubes_.find(beside);
        if (found == cubes_.end() || found->second.isMet) continue;
        found->second.isMet = true;
        part.push_back(beside);
      }
    }
    if (isAround || points > most) return;
    for (const Cell& cell : part)
      cubes_.at(cell).isFar = true;
  }

  static constexpr std::size_t wide = 7; // cubes: the last begins where the box ends
  static constexpr std::size_t all = wide * wide * wide;

  double side_;
  Eigen::AlignedBox3d around_;
  Eigen::Vector3d corner_;
  std::array<bool, all> isAround_ = {};
  std::unordered_map<Cell, Cube, CellHash> cubes_;
};

} // namespace

std::vector<Eigen::Index> farPoints(Eigen::Index count, const Places& place,
                                    const Eigen::AlignedBox3d& bounds) {
  if (count == 0) return {};
  Eigen::AlignedBox3d around = middleBox(count, place);
  const double size = around.sizes().maxCoeff();
  around.min().array() -= size;
  around.max().array() += size;
  if (!(size > 0) || around.contains(bounds)) return {};
  CubeParts parts(size / 2, around);
  std::vector<Eigen::Index> far; // at first all that are not around: hardly any
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d at = place(i);
    parts.add(at);
    if (!around.contains(at)) far.push_back(i);
  }
  parts.markFar(std::max<Eigen::Index>(count / 100, 1));
  std::erase_if(far, [&](Eigen::Index i) { return !parts.isFar(place(i)); });
  if (std::ssize(far) > count / 16) far.clear();
  return far;
}

std::vector<Eigen::Index> farPoints(const PointCloud& cloud,
                                    const std::vector<bool>& isNotCounted) {
  std::vector<Eigen::Index> counted;
  counted.reserve(static_cast<std::size_t>(cloud.size()));
  Eigen::AlignedBox3f bounds;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    if (isNotCounted[static_cast<std::size_t>(i)]) continue;
    counted.push_back(i);
    bounds.extend(cloud.positions().col(i));
  }
  if (counted.empty()) return {};
  const auto place = [&](Eigen::Index i) {
    return cloud.position(counted[static_cast<std::size_t>(i)]);
  };
  std::vector<Eigen::Index> far = farPoints(
      std::ssize(counted), place,
      {bounds.min().cast<double>() + cloud.origin(), bounds.max().cast<double>() + cloud.origin()});
  for (Eigen::Index& point : far)
    point = counted[static_cast<std::size_t>(point)];
  return far;
}

std::vector<Eigen::Index> farPoints(const PointCloud& cloud, const PointSet& leftOut,
                                    const Progress& progress) {
  progress.check();
  const std::vector<bool> isNotCounted = notCounted(cloud, leftOut);
  progress.check();
  const std::vector<Eigen::Index> far = farPoints(cloud, isNotCounted);
  progress.check();
  if (far.empty()) return {};
  std::vector<bool> isFar(isNotCounted.size(), false);
  for (const Eigen::Index point : far)
    isFar[static_cast<std::size_t>(point)] = true;
  // Those at one place follow each other, with points that are left out among them.
  std::vector<Eigen::Index> all;
  bool isFarPlace = false;
  for (Eigen::Index i = 0; i < cloud.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool isSame = i > 0 && cloud.positions().col(i) == cloud.positions().col(i - 1);
    isFarPlace = isFar[at] || (isSame && isFarPlace);
    if (isFarPlace && !leftOut.contains(i)) all.push_back(i);
  }
  return all;
}

Eigen::AlignedBox3d plantBounds(const PointCloud& cloud, const PointSet& leftOut,
                                const Progress& progress) {
  const PointSet without = leftOut | PointSet::of(farPoints(cloud, leftOut, progress));
  if (without.isEmpty()) return cloud.bounds();
  Eigen::AlignedBox3d box;
  for (const Eigen::Index point : others(without, cloud.size()))
    box.extend(cloud.position(point));
  return box;
}

} // namespace espalier
