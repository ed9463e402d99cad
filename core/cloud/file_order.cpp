#include "core/cloud/file_order.h"

#include <algorithm>
#include <numeric>

namespace espalier {

std::vector<Eigen::Index> pointsInFileOrder(const PointCloud& cloud) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(cloud.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::sort(order, {}, [&](Eigen::Index point) {
    return cloud.fileOrder()[static_cast<std::size_t>(point)];
  });
  return order;
}

} // namespace espalier
