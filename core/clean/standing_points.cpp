#include "core/clean/standing_points.h"

#include "core/graph/turn_upright.h"

namespace espalier {

PointSet StandingPoints::inCloud(const std::vector<Eigen::Index>& places) const {
  std::vector<Eigen::Index> found;
  found.reserve(places.size());
  for (const Eigen::Index place : places)
    found.push_back(columns[static_cast<std::size_t>(place)]);
  return PointSet::of(found);
}

StandingPoints standingPoints(const PointCloud& cloud, std::vector<Eigen::Index> columns,
                              UpAxis up) {
  StandingPoints result;
  result.turn = turnUpright(up);
  result.origin = cloud.origin();
  result.positions = cloud.positions()(Eigen::all, columns);
  if (up != UpAxis::z)
    result.positions = (result.turn.cast<float>() * result.positions).eval(); // swaps axes: exact
  result.columns = std::move(columns);
  return result;
}

StandingPoints standingPoints(const PointCloud& cloud, const PointSet& leftOut, UpAxis up) {
  return standingPoints(cloud, others(leftOut, cloud.size()), up);
}

} // namespace espalier
