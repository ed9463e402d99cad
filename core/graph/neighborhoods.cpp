#include "core/graph/neighborhoods.h"

#include "core/base/paced_check.h"
#include "core/base/parallel.h"
#include "core/base/spatial_index.h"
#include "core/graph/geodesic.h"
#include "core/graph/geodesic_balls.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace espalier {
namespace {

using Lists = std::vector<std::vector<std::uint32_t>>;

struct Found {
  float distance;
  std::uint32_t point;
};

/// The points but `own`, nearest first; of equally near ones that of the lower number.
std::vector<std::uint32_t> sorted(std::vector<Found>& found, std::uint32_t own) {
  std::ranges::sort(found, {},
                    [](const Found& each) { return std::tuple(each.distance, each.point); });
  std::vector<std::uint32_t> points;
  points.reserve(found.size());
  for (const Found& each : found)
    if (each.point != own) points.push_back(each.point);
  return points;
}

/// Moves the lists of `points` to the end of `result`, and makes room for as many members of each
/// of the `left` points that come later. Memory that is not written to takes none.
void takeLists(Lists& lists, std::span<const std::uint32_t> points, std::size_t left,
               Neighborhoods& result) {
  std::size_t added = 0;
  for (const std::uint32_t point : points)
    added += lists[point].size();
  const std::size_t size = result.members.size() + added;
  if (result.members.capacity() < size)
    result.members.reserve(size + (added * left + added * left / 8) / points.size());
  for (const std::uint32_t point : points) {
    const auto list = std::exchange(lists[point], {});
    result.begin[point] = result.members.size();
    result.members.insert(result.members.end(), list.begin(), list.end());
    result.end[point] = result.members.size();
  }
}

} // namespace

Neighborhoods joinedLists(const Lists& lists, const Progress& progress) {
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

Neighborhoods neighborhoodsWithin(const Eigen::Matrix3Xf& points, float radius,
                                  const Progress& progress) {
  const SpatialIndex index(points, progress);
  Lists lists(static_cast<std::size_t>(points.cols()));
  const auto search = [&](Eigen::Index point) {
    std::vector<Found> found;
    for (const Neighbor& neighbor : index.within(points.col(point), radius))
      found.push_back({neighbor.squaredDistance, static_cast<std::uint32_t>(neighbor.index)});
    lists[static_cast<std::size_t>(point)] = sorted(found, static_cast<std::uint32_t>(point));
  };
  parallelFor(points.cols(), search, progress, 32);
  return joinedLists(lists, progress);
}

Neighborhoods geodesicNearest(const NeighborhoodGraph& graph, int count, const Progress& progress) {
  oneapi::tbb::enumerable_thread_specific<GeodesicBall> balls([&] { return GeodesicBall(graph); });
  Lists lists(static_cast<std::size_t>(graph.size()));
  const auto most = static_cast<std::size_t>(std::max(count, 0)) + 1;
  const auto search = [&](Eigen::Index point) {
    const auto& members = balls.local().around(point, std::numeric_limits<float>::max(), most);
    auto& list = lists[static_cast<std::size_t>(point)];
    for (const GeodesicBall::Member& member : members)
      if (member.point != static_cast<std::uint32_t>(point)) list.push_back(member.point);
    if (list.size() == most) list.pop_back(); // at the same place, and settled before the center
  };
  parallelFor(graph.size(), search, progress, 32);
  return joinedLists(lists, progress);
}

Neighborhoods geodesicWithin(const NeighborhoodGraph& graph, float radius,
                             const Progress& progress) {
  constexpr std::size_t groupsAtOnce = 1024; // only their lists are in memory twice
  const BallGroups groups = ballGroups(graph);
  Lists lists(static_cast<std::size_t>(graph.size()));
  const auto visit = [&](const GeodesicBalls& balls) {
    std::array<std::vector<Found>, GeodesicBalls::most> found;
    balls.forEachMember([&](std::size_t center, std::uint32_t point, float distance) {
      found[center].push_back({distance, point});
    });
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      lists[balls.centers()[i]] = sorted(found[i], balls.centers()[i]);
  };
  const auto radiusOf = [&](std::uint32_t /*center*/) { return radius; };
  const auto total = static_cast<double>(groups.size());
  Neighborhoods result{.begin = std::vector<std::size_t>(lists.size()),
                       .end = std::vector<std::size_t>(lists.size())};
  for (std::size_t first = 0; first < groups.size(); first += groupsAtOnce) {
    const std::size_t last = std::min(first + groupsAtOnce, groups.size());
    forEachGeodesicBalls(
        groups, first, last, graph, radiusOf, findAlongLinks, visit,
        progress.part(static_cast<double>(first) / total, static_cast<double>(last) / total));
    const std::size_t seen = last == groups.size() ? lists.size() : groups.begin(last);
    takeLists(lists, groups.between(first, last), lists.size() - seen, result);
  }
  return result;
}

} // namespace espalier
