#include "core/clean/wood_paths.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/graph/geodesic.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace espalier {
namespace {

/// The places near one that links lead to, itself first.
std::vector<std::uint32_t> linkedNear(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& means,
                                      Eigen::Index about, float reach) {
  std::vector<std::uint32_t> near = {static_cast<std::uint32_t>(about)};
  for (std::size_t next = 0; next < near.size(); ++next)
    for (const NeighborhoodGraph::Link& link : graph.links(near[next]))
      if (link.length <= reach && (means.col(link.to) - means.col(about)).norm() <= reach &&
          std::ranges::find(near, link.to) == near.end())
        near.push_back(link.to);
  return near;
}

struct Arrival {
  float cost;
  std::uint32_t at;
};

struct IsDearer {
  bool operator()(const Arrival& a, const Arrival& b) const {
    return a.cost != b.cost ? a.cost > b.cost : a.at > b.at;
  }
};

} // namespace

std::vector<float> woodThickness(const Voxels& voxels, const Eigen::Matrix3Xf& points,
                                 const Eigen::Matrix3Xf& means, const NeighborhoodGraph& graph,
                                 const Progress& progress) {
  const auto reach = static_cast<float>(2 * voxels.edge());
  std::vector<float> thickness(voxels.count());
  parallelFor(
      means.cols(),
      [&](Eigen::Index place) {
        Moments moments(means.col(place).cast<double>());
        for (const std::uint32_t cube : linkedNear(graph, means, place, reach))
          for (const std::uint32_t point : voxels.members(cube))
            moments.add(Eigen::Vector3f(points.col(point)));
        const Eigen::Vector3d spread = moments.components().eigenvalues();
        thickness[static_cast<std::size_t>(place)] =
            static_cast<float>(std::sqrt(std::max(0.0, spread[0]) + std::max(0.0, spread[1])));
      },
      progress);
  return thickness;
}

std::vector<float> fullThickness(std::vector<float> thickness, const Eigen::Matrix3Xf& means,
                                 double edge, const Progress& progress) {
  constexpr int levels = 6;
  constexpr int links = 8;
  constexpr double full = 0.7; // cubes; of a cylinder as thick as a cube, its surface is a disc
  std::vector<std::uint32_t> cubeOf(thickness.size());
  std::iota(cubeOf.begin(), cubeOf.end(), 0U);
  Eigen::Matrix3Xf finer = means;
  for (int level = 1; level < levels; ++level, edge *= 2) {
    const auto isFull = [&](float thick) { return static_cast<double>(thick) > full * edge; };
    if (std::ranges::none_of(thickness, isFull)) break;
    const Progress part = progress.part(1 - 1.0 / level, 1 - 1.0 / (level + 1));
    const Voxels coarse(finer, 2 * edge, part.part(0, 0.2));
    const Eigen::Matrix3Xf places = coarse.means(finer, part.part(0.2, 0.3));
    if (places.cols() <= 2 * links) break;
    const std::vector<float> wider =
        woodThickness(coarse, finer, places, NeighborhoodGraph(places, links, part.part(0.3, 0.5)),
                      part.part(0.5, 1));
    const std::vector<std::uint32_t> into = coarse.ofPoints();
    for (std::size_t i = 0; i < thickness.size(); ++i) {
      cubeOf[i] = into[cubeOf[i]];
      if (isFull(thickness[i])) thickness[i] = std::max(thickness[i], wider[cubeOf[i]]);
    }
    finer = places;
  }
  return thickness;
}

std::vector<std::uint32_t> woodPaths(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& places,
                                     const std::vector<float>& thickness, double least,
                                     const std::vector<Eigen::Index>& sources,
                                     const WoodPathCosts& costs, const Progress& progress) {
  constexpr float kept = 0.9F; // of how a path ran, per link
  constexpr double free = 0.4; // 1 - cos of turns up to 50 degrees, as links scatter
  const auto count = static_cast<std::size_t>(graph.size());
  std::vector<float> costTo(count, std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> back(count, Geodesics::none);
  std::vector<Eigen::Vector3f> runs(count, Eigen::Vector3f::UnitZ());
  std::vector<Arrival> storage;
  storage.reserve(count);
  std::priority_queue<Arrival, std::vector<Arrival>, IsDearer> queue({}, std::move(storage));
  for (const Eigen::Index source : sources) {
    costTo[static_cast<std::size_t>(source)] = 0;
    queue.push({0, static_cast<std::uint32_t>(source)});
  }
  std::size_t settled = 0;
  while (!queue.empty()) {
    const auto [cost, at] = queue.top();
    queue.pop();
    if (cost > costTo[at]) continue;
    if (++settled % 8192 == 0)
      progress.update(static_cast<double>(settled) / static_cast<double>(count));
    for (const NeighborhoodGraph::Link& link : graph.links(at)) {
      if (link.length <= 0 || costTo[link.to] <= cost) continue;
      const Eigen::Vector3f along = (places.col(link.to) - places.col(at)) / link.length;
      const double length = static_cast<double>(link.length) / least;
      const double thick = std::max(
          1.0, (static_cast<double>(thickness[at]) + static_cast<double>(thickness[link.to])) / 2 /
                   least);
      const double turned = std::max(0.0, 1 - free - static_cast<double>(along.dot(runs[at])));
      const auto there =
          cost + static_cast<float>(std::pow(length, costs.power) *
                                    std::pow(thick, -costs.thinness) * (1 + costs.turn * turned));
      if (there >= costTo[link.to]) continue;
      costTo[link.to] = there;
      back[link.to] = at;
      runs[link.to] = (kept * runs[at] + (1 - kept) * along).normalized();
      queue.push({there, link.to});
    }
  }
  progress.update(1);
  return back;
}

} // namespace espalier
