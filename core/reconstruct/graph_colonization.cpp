#include "core/reconstruct/graph_colonization.h"

#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"
#include "core/reconstruct/reached_points.h"

#include <queue>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace espalier {
namespace {

constexpr std::uint32_t ungrouped = std::numeric_limits<std::uint32_t>::max();

/// A group of points that is going to grow.
struct Bud {
  double level = 0;         // [L] along the plant, from where on
  std::uint32_t number = 0; // of its group

  bool operator>(const Bud& other) const {
    return std::tuple(level, number) > std::tuple(other.level, other.number);
  }
};

/// A point without a group, next to one of the group that grows.
struct Seed {
  std::uint32_t point;
  std::uint32_t neighbor; // in the group that grows

  auto operator<=>(const Seed&) const = default; // NOLINT(modernize-use-nullptr): its own 0
};

class Colony {
public:
  Colony(const Eigen::Matrix3Xf& points, const std::vector<float>& densities,
         const NeighborhoodGraph& graph, const Geodesics& paths,
         const GraphColonizationOptions& options)
      : points_(points), densities_(densities), graph_(graph), paths_(paths), options_(options),
        groupOf_(densities.size(), ungrouped) {}

  Skeleton grow(Eigen::Index root, const Progress& progress) {
    const auto first = static_cast<std::uint32_t>(root);
    const double end = step(densities_[first]);
    found({{first, first}}, end, std::nullopt);
    while (!buds_.empty()) {
      const Bud bud = buds_.top();
      buds_.pop();
      progress.update(static_cast<double>(taken_) / static_cast<double>(groupOf_.size()));
      growFrom(bud);
    }
    return std::move(skeleton_);
  }

private:
  [[nodiscard]] double step(double density) const {
    return options_.leastStep + density * (options_.greatestStep - options_.leastStep);
  }
  [[nodiscard]] double distance(std::uint32_t point) const {
    return static_cast<double>(paths_.distance[point]);
  }

  /// The points without a group next to `group`, by their number.
  [[nodiscard]] std::vector<Seed> seedsOf(std::uint32_t group) const {
    std::vector<Seed> seeds;
    for (const std::uint32_t point : groups_[group])
      for (const NeighborhoodGraph::Link& link : graph_.links(point))
        if (groupOf_[link.to] == ungrouped) seeds.push_back({link.to, point});
    std::ranges::sort(seeds);
    return seeds;
  }

  void growFrom(const Bud& bud) {
    const std::vector<Seed> seeds = seedsOf(bud.number);
    if (seeds.empty()) return;
    double density = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Seed& seed : seeds) {
      density += static_cast<double>(densities_[seed.point]) / static_cast<double>(seeds.size());
      nearest = std::min(nearest, distance(seed.point));
    }
    const double end = bud.level + step(density);
    if (nearest > end) { // it sleeps
      buds_.push({nearest, bud.number});
      return;
    }
    double later = std::numeric_limits<double>::infinity();
    for (const Seed& seed : seeds)
      if (groupOf_[seed.point] == ungrouped && distance(seed.point) <= end)
        found(seedsWith(seed.point, seeds, end), end, bud.number);
    for (const Seed& seed : seeds)
      if (groupOf_[seed.point] == ungrouped) later = std::min(later, distance(seed.point));
    if (std::isfinite(later)) buds_.push({later, bud.number});
  }

  /// Takes all points up to `end` that are connected with `first` and have no group for a new one.
  /// @return those of `seeds` that are among them
  std::vector<Seed> seedsWith(std::uint32_t first, const std::vector<Seed>& seeds, double end) {
    const auto number = static_cast<std::uint32_t>(groups_.size());
    take(first, number, end);
    std::vector<Seed> own;
    for (const Seed& seed : seeds)
      if (groupOf_[seed.point] == number) own.push_back(seed);
    return own;
  }

  void take(std::uint32_t first, std::uint32_t number, double end) {
    std::vector<std::uint32_t> members = {first};
    groupOf_[first] = number;
    for (std::size_t next = 0; next < members.size(); ++next)
      for (const NeighborhoodGraph::Link& link : graph_.links(members[next])) {
        if (groupOf_[link.to] != ungrouped || distance(link.to) > end) continue;
        groupOf_[link.to] = number;
        members.push_back(link.to);
      }
    taken_ += members.size();
    groups_.push_back(std::move(members));
  }

  /// Makes the node of the last group, or of that of the root, and its bud.
  void found(const std::vector<Seed>& seeds, double end, std::optional<std::uint32_t> parent) {
    if (!parent) take(seeds.front().point, 0, end);
    const std::vector<std::uint32_t>& members = groups_.back();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::uint32_t point : members)
      mean += position(point) / static_cast<double>(members.size());
    Eigen::Vector3d junction = Eigen::Vector3d::Zero();
    for (const Seed& seed : seeds)
      junction += (position(seed.point) + position(seed.neighbor)) /
                  (2 * static_cast<double>(seeds.size()));
    const Eigen::Vector3d place = mean + options_.junctionShare * (junction - mean);
    double radius = 0;
    for (const std::uint32_t point : members)
      radius += (position(point) - place).norm() / static_cast<double>(members.size());
    nodes_.push_back(
        skeleton_.add({.position = place,
                       .radius = radius,
                       .parent = parent ? std::optional<NodeId>(nodes_[*parent]) : std::nullopt}));
    buds_.push({end, static_cast<std::uint32_t>(groups_.size() - 1)});
  }

  [[nodiscard]] Eigen::Vector3d position(std::uint32_t point) const {
    return points_.col(point).cast<double>();
  }

  const Eigen::Matrix3Xf& points_;
  const std::vector<float>& densities_;
  const NeighborhoodGraph& graph_;
  const Geodesics& paths_;
  const GraphColonizationOptions& options_;
  std::vector<std::uint32_t> groupOf_;             // by point
  std::vector<std::vector<std::uint32_t>> groups_; // their points
  std::vector<NodeId> nodes_;                      // by group
  std::size_t taken_ = 0;                          // points that have a group
  std::priority_queue<Bud, std::vector<Bud>, std::greater<>> buds_;
  Skeleton skeleton_;
};

} // namespace

Skeleton skeletonByGraphColonization(const Eigen::Matrix3Xf& points,
                                     const std::vector<float>& densities, Eigen::Index root,
                                     const GraphColonizationOptions& options,
                                     const Progress& progress) {
  assert(densities.size() == static_cast<std::size_t>(points.cols()));
  const NeighborhoodGraph parts(points, options.neighbors, progress.part(0, 0.4));
  const float widestGap = options.widestGap > 0 ? static_cast<float>(options.widestGap)
                                                : std::numeric_limits<float>::max();
  const NeighborhoodGraph graph = joined(parts, points, widestGap, progress.part(0.4, 0.6));
  const Geodesics paths = geodesics(graph, {root}, 1, progress.part(0.6, 0.8));
  requireHalf(std::ranges::count_if(paths.distance, [](float d) { return std::isfinite(d); }),
              points.cols());
  Colony colony(points, densities, graph, paths, options);
  return colony.grow(root, progress.part(0.8, 1));
}

} // namespace espalier
