#include "core/cloud/file_order.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace espalier {
namespace {

std::vector<std::uint32_t> countedUp(Eigen::Index count) {
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// What each point has, if they have it.
template <class Value>
std::vector<Value> inOrder(const std::vector<Value>& values,
                           const std::vector<Eigen::Index>& order) {
  std::vector<Value> result;
  if (values.empty()) return result;
  result.reserve(order.size());
  for (const Eigen::Index point : order)
    result.push_back(values[static_cast<std::size_t>(point)]);
  return result;
}

} // namespace

std::vector<Eigen::Index> pointsInFileOrder(const PointCloud& cloud, const Progress& progress) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(cloud.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto placeOf = [&](Eigen::Index point) {
    return cloud.fileOrder()[static_cast<std::size_t>(point)];
  };
  std::size_t looks = 0;
  std::ranges::sort(order, [&](Eigen::Index a, Eigen::Index b) {
    if (++looks % 65536 == 0) progress.check();
    return placeOf(a) < placeOf(b);
  });
  return order;
}

PointCloud sortedAsInFile(const PointCloud& cloud, const Progress& progress) {
  const std::vector<Eigen::Index> order = pointsInFileOrder(cloud, progress);
  return PointCloud(StoredPoints{.positions = cloud.positions()(Eigen::all, order),
                                 .origin = cloud.origin(),
                                 .colors = inOrder(cloud.colors(), order),
                                 .intensities = inOrder(cloud.intensities(), order),
                                 .fileOrder = countedUp(cloud.size()),
                                 .stations = cloud.stations(),
                                 .stationOf = inOrder(cloud.stationOf(), order)});
}

PointCloud listedByColumn(const PointCloud& cloud) {
  return PointCloud(StoredPoints{.positions = cloud.positions(),
                                 .origin = cloud.origin(),
                                 .colors = cloud.colors(),
                                 .intensities = cloud.intensities(),
                                 .fileOrder = countedUp(cloud.size()),
                                 .stations = cloud.stations(),
                                 .stationOf = cloud.stationOf()});
}

} // namespace espalier
