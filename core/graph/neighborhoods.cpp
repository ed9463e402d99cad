#include "core/graph/neighborhoods.h"

#include "core/base/paced_check.h"
#include "core/base/spatial_index.h"

#include <utility>

namespace espalier {

Neighborhoods joinedLists(const std::vector<std::vector<std::uint32_t>>& lists,
                          const Progress& progress) {
  Neighborhoods result;
  PacedCheck pace(progress);
  std::size_t total = 0;
  for (const auto& list : lists) {
    result.begin.push_back(total);
    total += list.size();
    result.end.push_back(total);
  }
  result.members.reserve(total);
  for (const auto& list : lists) {
    pace.after(1 + list.size());
    result.members.insert(result.members.end(), list.begin(), list.end());
  }
  return result;
}

Neighborhoods nearestNeighborhoods(const Eigen::Matrix3Xf& points, int count,
                                   const Progress& progress) {
  NearestOthers others = SpatialIndex(points, progress).nearestOthers(count, progress);
  Neighborhoods result;
  const auto perPoint = static_cast<std::size_t>(others.perPoint);
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.cols()); ++i) {
    result.begin.push_back(i * perPoint);
    result.end.push_back((i + 1) * perPoint);
  }
  result.members = std::move(others.indices);
  return result;
}

} // namespace espalier
