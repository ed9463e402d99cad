#include "core/graph/scan_gaps.h"

#include "core/cloud/voxels.h"
#include "core/graph/components.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace espalier {
namespace {

struct CubeLink {
  float length; // [L]
  std::uint32_t a;
  std::uint32_t b;
};

/// The links of a graph, each once, the shortest first.
std::vector<CubeLink> sortedLinks(const NeighborhoodGraph& graph) {
  std::vector<CubeLink> links;
  for (Eigen::Index i = 0; i < graph.size(); ++i)
    for (const NeighborhoodGraph::Link& link : graph.links(i))
      if (i < static_cast<Eigen::Index>(link.to))
        links.push_back({link.length, static_cast<std::uint32_t>(i), link.to});
  std::ranges::sort(links, {},
                    [](const CubeLink& link) { return std::tuple(link.length, link.a, link.b); });
  return links;
}

/// Cubes that were joined, and how many points these hold.
class JoinedSets {
public:
  explicit JoinedSets(std::vector<std::size_t> sizes) : sizes_(std::move(sizes)) {
    above_.resize(sizes_.size());
    std::iota(above_.begin(), above_.end(), 0U);
  }

  [[nodiscard]] std::uint32_t setOf(std::uint32_t cube) {
    while (above_[cube] != cube) {
      above_[cube] = above_[above_[cube]];
      cube = above_[cube];
    }
    return cube;
  }
  [[nodiscard]] std::size_t size(std::uint32_t set) const { return sizes_[set]; }

  void join(std::uint32_t a, std::uint32_t b) { // pre: two sets
    if (sizes_[a] < sizes_[b]) std::swap(a, b);
    above_[b] = a;
    sizes_[a] += sizes_[b];
  }

private:
  std::vector<std::uint32_t> above_;
  std::vector<std::size_t> sizes_;
};

} // namespace

std::vector<ScanGap> scanGaps(const Eigen::Matrix3Xf& points, double spacing,
                              const Progress& progress) {
  constexpr double edge = 3;        // of cubes [spacings]
  constexpr double narrowest = 8;   // [spacings]
  constexpr std::size_t least = 10; // points on either side
  constexpr int neighbors = 4;
  if (points.cols() < 2) return {};
  const Voxels cubes(points, edge * spacing, progress.part(0, 0.2));
  const Eigen::Matrix3Xf means = cubes.means(points, progress);
  if (means.cols() < 2) return {};
  const NeighborhoodGraph graph =
      joined(NeighborhoodGraph(means, neighbors, progress.part(0.2, 0.6)), means,
             std::numeric_limits<float>::max(), progress.part(0.6, 0.9));
  std::vector<std::size_t> sizes(cubes.count());
  for (std::size_t cube = 0; cube < sizes.size(); ++cube)
    sizes[cube] = cubes.members(cube).size();
  JoinedSets sets(std::move(sizes));
  std::vector<ScanGap> gaps;
  progress.update(0.95);
  for (const CubeLink& link : sortedLinks(graph)) {
    const std::uint32_t a = sets.setOf(link.a);
    const std::uint32_t b = sets.setOf(link.b);
    if (a == b) continue;
    const auto width = static_cast<double>(link.length);
    if (width > narrowest * spacing && std::min(sets.size(a), sets.size(b)) >= least)
      gaps.push_back({(means.col(link.a) + means.col(link.b)) / 2, width});
    sets.join(a, b);
  }
  progress.update(1);
  return gaps;
}

} // namespace espalier
