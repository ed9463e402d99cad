#include "core/reconstruct/branch_structure_graph.h"

#include "core/base/parallel.h"
#include "core/base/spatial_index.h"
#include "core/reconstruct/flat_overlap.h"
#include "core/reconstruct/point_tree.h"
#include "core/reconstruct/reached_points.h"
#include "core/reconstruct/thick_wood.h"
#include "core/reconstruct/tree_equations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

using Children = PointTree::Children;

constexpr int mostMerges = 10;       // rounds of it
constexpr double pipeExponent = 2.5; // of the radius, by the logarithm of the weight

double meanEdge(const PointTree& tree) {
  const double length = tree.lengthCarried().front();
  return tree.size() < 2 || length == 0 ? 1 : length / static_cast<double>(tree.size() - 1);
}

/// What each node carries in mean edges, and one for itself.
std::vector<double> weightsOf(const PointTree& tree) {
  std::vector<double> weights = tree.lengthCarried();
  const double unit = meanEdge(tree);
  for (double& weight : weights)
    weight = 1 + weight / unit;
  return weights;
}

Eigen::Vector3d unitOrZero(const Eigen::Vector3d& vector) {
  const double length = vector.norm();
  return length > 0 ? Eigen::Vector3d(vector / length) : Eigen::Vector3d::Zero();
}

/// One round: directions that agree along the tree, then positions that agree with them.
void straighten(PointTree& tree) {
  const std::vector<double> weights = weightsOf(tree);
  const auto shared = [&](std::size_t i) { return (weights[i] + weights[tree.parents[i]]) / 2; };
  TreeEquations directions(tree.parents);
  for (std::size_t i = 1; i < tree.size(); ++i) {
    directions.ask(i, unitOrZero(tree.edge(i)), weights[i]);
    directions.askOfEdge(i, -1, Eigen::Vector3d::Zero(), shared(i));
  }
  const std::vector<Eigen::Vector3d> direction = directions.solved();
  TreeEquations places(tree.parents);
  places.ask(0, tree.positions[0], 1);
  for (std::size_t i = 1; i < tree.size(); ++i) {
    const std::uint32_t parent = tree.parents[i];
    places.askOfEdge(i, 1, tree.positions[i] + tree.positions[parent], weights[i]);
    places.askOfEdge(i, -1, tree.edge(i).norm() * unitOrZero(direction[i] + direction[parent]),
                     shared(i));
  }
  tree.positions = places.solved();
}

/// Mean distance from the points to the branches: to the nearest node that carries something.
/// (Those that carry little are as many as the points, and at their places.)
double meanDistance(const PointTree& tree, const Eigen::Matrix3Xf& points,
                    const Progress& progress) {
  constexpr double little = 6; // mean edges
  const std::vector<double> weights = weightsOf(tree);
  std::vector<Eigen::Vector3f> branches = {tree.positions.front().cast<float>()};
  for (std::size_t i = 1; i < tree.size(); ++i)
    if (weights[i] >= little) branches.emplace_back(tree.positions[i].cast<float>());
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(branches.size()));
  for (std::size_t i = 0; i < branches.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = branches[i];
  const SpatialIndex index(places);
  std::vector<double> distances(static_cast<std::size_t>(points.cols()));
  parallelFor(
      points.cols(),
      [&](Eigen::Index point) {
        distances[static_cast<std::size_t>(point)] =
            std::sqrt(index.nearest(points.col(point), 1).front().squaredDistance);
      },
      progress);
  double mean = 0;
  for (const double distance : distances)
    mean += distance / static_cast<double>(distances.size());
  return mean;
}

/// By the pipe model: r = r0 (log w)^2.5, of this weighted mean.
std::vector<double> radiiOf(const std::vector<double>& weights, double mean) {
  std::vector<double> radii;
  double sum = 0;
  double all = 0;
  for (const double weight : weights) {
    radii.push_back(std::pow(std::log(weight), pipeExponent));
    sum += weight * radii.back();
    all += weight;
  }
  for (double& radius : radii)
    radius *= sum > 0 ? mean * all / sum : 0;
  return radii;
}

/// Takes away the nodes at the end of short edges; what they carry is attached to the node below.
void removeShortEdges(PointTree& tree, double share) {
  if (tree.size() < 3) return;
  std::vector<double> lengths;
  for (std::size_t i = 1; i < tree.size(); ++i)
    lengths.push_back(tree.edge(i).norm());
  std::ranges::sort(lengths);
  const std::size_t last = lengths.size() - 1;
  const double least = lengths.front() + share * (lengths[last - last / 100] - lengths.front());
  std::vector<std::uint32_t> kept(tree.size(), 0); // the node that stands for each
  Children children(tree.size());
  for (std::size_t i = 1; i < tree.size(); ++i) {
    const std::uint32_t below = kept[tree.parents[i]];
    const bool isShort = tree.edge(i).norm() < least;
    kept[i] = isShort ? below : static_cast<std::uint32_t>(i);
    if (!isShort) children[below].push_back(static_cast<std::uint32_t>(i));
  }
  tree = renumbered(tree.positions, children);
}

/// One round of making one of what overlaps.
class Merger {
public:
  Merger(const PointTree& tree, double meanRadius, double overlap)
      : positions_(tree.positions), children_(tree.children()), weights_(weightsOf(tree)),
        radii_(radiiOf(weights_, meanRadius)), overlap_(overlap) {}

  PointTree merged() {
    std::vector<std::uint32_t> order = {0};
    for (std::size_t next = 0; next < order.size(); ++next) {
      mergeChildren(order[next]);
      const std::vector<std::uint32_t>& here = children_[order[next]];
      order.insert(order.end(), here.begin(), here.end());
    }
    return renumbered(positions_, children_);
  }

private:
  [[nodiscard]] Frustum wood(std::uint32_t from, std::uint32_t to) const {
    return {positions_[from], positions_[to], radii_[from], radii_[to]};
  }

  void mergeChildren(std::uint32_t node) {
    std::vector<std::uint32_t>& here = children_[node];
    for (std::size_t a = 0; a < here.size(); ++a)
      for (std::size_t b = a + 1; b < here.size();) {
        if (flatOverlap(wood(node, here[a]), wood(node, here[b])) <= overlap_) {
          ++b;
          continue;
        }
        take(here[a], here[b]);
        here.erase(here.begin() + static_cast<std::ptrdiff_t>(b));
      }
    for (const std::uint32_t child : here) {
      const std::vector<std::uint32_t> carried = children_[child];
      for (const std::uint32_t next : carried)
        if (flatOverlap(wood(node, child), wood(child, next)) > overlap_) {
          std::erase(children_[child], next);
          take(child, next);
        }
    }
  }

  /// `gone` becomes a part of `kept`, which carries what it carried.
  void take(std::uint32_t kept, std::uint32_t gone) {
    const double all = weights_[kept] + weights_[gone];
    positions_[kept] =
        (weights_[kept] * positions_[kept] + weights_[gone] * positions_[gone]) / all;
    weights_[kept] = all;
    radii_[kept] = std::max(radii_[kept], radii_[gone]);
    children_[kept].insert(children_[kept].end(), children_[gone].begin(), children_[gone].end());
    children_[gone].clear();
  }

  std::vector<Eigen::Vector3d> positions_;
  Children children_;
  std::vector<double> weights_;
  std::vector<double> radii_;
  double overlap_;
};

} // namespace

Skeleton skeletonByBranchStructure(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                   const BranchStructureOptions& options,
                                   const Progress& progress) {
  const Eigen::Matrix3Xf drawn = withThickWoodAsLines(
      points, root,
      {.neighbors = options.neighbors, .radius = options.thickWood, .widestGap = options.widestGap},
      progress.part(0, 0.2));
  PointTree tree = shortestPathTree(
      drawn, root, {.neighbors = options.neighbors, .power = 1, .widestGap = options.widestGap},
      progress.part(0.2, 0.6));
  for (int round = 0; round < options.rounds; ++round) {
    progress.check();
    straighten(tree);
  }
  const double radius = options.radiusShare * meanDistance(tree, points, progress.part(0.6, 0.75));
  removeShortEdges(tree, options.leastEdge);
  for (int round = 0; round < mostMerges; ++round) {
    progress.update(0.75 + 0.015 * round);
    const std::size_t before = tree.size();
    tree = Merger(tree, radius, options.overlap).merged();
    if (tree.size() == before) break;
  }
  return withMeanDistances(skeletonOf(tree, options.spacing), points, progress.part(0.9, 1));
}

} // namespace espalier
