#include "core/graph/neighborhood_graph.h"

#include "core/base/paced_check.h"
#include "core/base/parallel.h"
#include "core/base/spatial_index.h"
#include "core/graph/normals.h"
#include "core/graph/tangent_neighbors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace espalier {
namespace {

std::span<const std::uint32_t> chosenBy(const NearestOthers& table, std::size_t point) {
  const auto perPoint = static_cast<std::size_t>(table.perPoint);
  return {table.indices.data() + point * perPoint, perPoint};
}

/// For each choice whether the other end did not make it as well.
std::vector<char> oneSidedChoices(const NearestOthers& table, std::size_t count,
                                  const Progress& progress) {
  const auto perPoint = static_cast<std::size_t>(table.perPoint);
  std::vector<char> isOneSided(table.indices.size());
  const auto look = [&](Eigen::Index point) {
    const auto from = static_cast<std::size_t>(point);
    for (std::size_t place = from * perPoint; place < (from + 1) * perPoint; ++place) {
      const auto back = chosenBy(table, table.indices[place]);
      isOneSided[place] = std::find(back.begin(), back.end(), from) == back.end() ? 1 : 0;
    }
  };
  parallelFor(static_cast<Eigen::Index>(count), look, progress);
  return isOneSided;
}

/// The neighbors of each point that surround it.
Neighborhoods inTangentPlane(const Eigen::Matrix3Xf& points, const PointLinks& links,
                             const Progress& progress) {
  const Neighborhoods candidates =
      nearestNeighborhoods(points, 3 * std::max(links.count, 1), progress.part(0, 0.4));
  const Eigen::Matrix3Xf across = normals(points, candidates, progress.part(0.4, 0.5));
  const Progress rest = progress.part(0.5, 0.9);
  if (links.kind == LinkKind::voronoi) return voronoiNeighbors(points, across, candidates, rest);
  return angleCriterionNeighbors(points, across, candidates, links.count, std::numbers::pi / 2,
                                 rest);
}

} // namespace

NeighborhoodGraph::NeighborhoodGraph(const Eigen::Matrix3Xf& points, const PointLinks& links,
                                     const Progress& progress) {
  if (links.kind == LinkKind::nearest)
    linkNearest(points, links.count, progress);
  else
    linkChosen(points, inTangentPlane(points, links, progress));
  progress.update(1);
}

void NeighborhoodGraph::linkChosen(const Eigen::Matrix3Xf& points, const Neighborhoods& chosen) {
  const std::size_t count = chosen.size();
  std::vector<std::vector<std::uint32_t>> linked(count);
  for (std::size_t i = 0; i < count; ++i)
    for (const std::uint32_t to : chosen.of(static_cast<Eigen::Index>(i))) {
      linked[i].push_back(to);
      if (std::ranges::find(chosen.of(to), i) == chosen.of(to).end())
        linked[to].push_back(static_cast<std::uint32_t>(i));
    }
  begin_.push_back(0);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::uint32_t to : linked[i])
      links_.push_back({to, (points.col(static_cast<Eigen::Index>(i)) - points.col(to)).norm()});
    begin_.push_back(links_.size());
  }
}

void NeighborhoodGraph::linkNearest(const Eigen::Matrix3Xf& points, int neighbors,
                                    const Progress& progress) {
  const auto count = static_cast<std::size_t>(points.cols());
  const NearestOthers table =
      SpatialIndex(points, progress).nearestOthers(std::max(neighbors, 1), progress.part(0, 0.8));
  const auto perPoint = static_cast<std::size_t>(table.perPoint);

  const std::vector<char> isOneSided = oneSidedChoices(table, count, progress.part(0.8, 0.9));
  PacedCheck pace(progress);

  begin_.assign(count + 1, perPoint);
  begin_[0] = 0;
  for (std::size_t place = 0; place < isOneSided.size(); ++place)
    if (isOneSided[place] != 0) ++begin_[table.indices[place] + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());

  links_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  const auto lengthAt = [&](std::size_t place) { return std::sqrt(table.squaredDistances[place]); };
  const auto addChosen = [&](Eigen::Index point) {
    const auto i = static_cast<std::size_t>(point);
    for (std::size_t place = i * perPoint; place < (i + 1) * perPoint; ++place)
      links_[next[i]++] = {table.indices[place], lengthAt(place)};
  };
  parallelFor(points.cols(), addChosen, progress.part(0.9, 1), 4096);
  for (std::size_t place = 0; place < isOneSided.size(); ++place) {
    pace.after(1);
    if (isOneSided[place] != 0)
      links_[next[table.indices[place]]++] = {static_cast<std::uint32_t>(place / perPoint),
                                              lengthAt(place)};
  }
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
