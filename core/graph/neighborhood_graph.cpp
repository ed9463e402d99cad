#include "core/graph/neighborhood_graph.h"

#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

std::span<const std::uint32_t> chosenBy(const NearestOthers& table, std::size_t point) {
  const auto perPoint = static_cast<std::size_t>(table.perPoint);
  return {table.indices.data() + point * perPoint, perPoint};
}

/// Calls visit(from, place in the table) for each choice that the other end did not make as well.
template <class Visit>
void forEachOneSidedChoice(const NearestOthers& table, std::size_t count, const Progress& progress,
                           const Visit& visit) {
  const auto perPoint = static_cast<std::size_t>(table.perPoint);
  for (std::size_t from = 0; from < count; ++from) {
    if (from % (1 << 16) == 0) progress.check();
    for (std::size_t place = from * perPoint; place < (from + 1) * perPoint; ++place) {
      const auto back = chosenBy(table, table.indices[place]);
      if (std::find(back.begin(), back.end(), from) == back.end()) visit(from, place);
    }
  }
}

} // namespace

NeighborhoodGraph::NeighborhoodGraph(const Eigen::Matrix3Xf& points, int neighbors,
                                     const Progress& progress) {
  const auto count = static_cast<std::size_t>(points.cols());
  const NearestOthers table =
      SpatialIndex(points, progress).nearestOthers(std::max(neighbors, 1), progress.part(0, 0.8));
  const auto perPoint = static_cast<std::size_t>(table.perPoint);

  begin_.assign(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i)
    begin_[i + 1] = perPoint;
  forEachOneSidedChoice(table, count, progress, [&](std::size_t /*from*/, std::size_t place) {
    ++begin_[table.indices[place] + 1];
  });
  progress.update(0.9);
  for (std::size_t i = 0; i < count; ++i)
    begin_[i + 1] += begin_[i];

  links_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  const auto lengthAt = [&](std::size_t place) { return std::sqrt(table.squaredDistances[place]); };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t place = i * perPoint; place < (i + 1) * perPoint; ++place)
      links_[next[i]++] = {table.indices[place], lengthAt(place)};
  forEachOneSidedChoice(table, count, progress, [&](std::size_t from, std::size_t place) {
    const std::uint32_t to = table.indices[place];
    links_[next[to]++] = {static_cast<std::uint32_t>(from), lengthAt(place)};
  });
  progress.update(1);
}

NeighborhoodGraph NeighborhoodGraph::withLinks(const std::vector<Edge>& edges,
                                               const Eigen::Matrix3Xf& points) const {
  if (edges.empty()) return *this;
  NeighborhoodGraph result;
  std::vector<std::vector<std::uint32_t>> added(static_cast<std::size_t>(size()));
  for (const auto& [a, b] : edges) {
    added[a].push_back(b);
    added[b].push_back(a);
  }
  result.begin_.reserve(begin_.size());
  result.links_.reserve(links_.size() + 2 * edges.size());
  result.begin_.push_back(0);
  for (Eigen::Index i = 0; i < size(); ++i) {
    const auto own = links(i);
    result.links_.insert(result.links_.end(), own.begin(), own.end());
    for (const std::uint32_t to : added[static_cast<std::size_t>(i)])
      result.links_.push_back({to, (points.col(i) - points.col(to)).norm()});
    result.begin_.push_back(result.links_.size());
  }
  return result;
}

} // namespace espalier
