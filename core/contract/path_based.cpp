#include "core/contract/path_based.h"

#include "core/graph/components.h"
#include "core/graph/geodesic.h"

#include <cassert>
#include <vector>

namespace espalier {
namespace {

using Vectors = std::vector<Eigen::Vector3d>;

/// A tree of all points by shortest paths. Points are named by their place in `order`.
struct PathTree {
  std::vector<std::uint32_t> order;  // columns of the cloud, parents before their children
  std::vector<std::uint32_t> parent; // 0 for the root, which is the first

  PathTree(const Geodesics& paths, Eigen::Index root) {
    const std::size_t count = paths.predecessor.size();
    std::vector<std::vector<std::uint32_t>> children(count);
    for (std::uint32_t i = 0; i < count; ++i)
      if (paths.predecessor[i] != Geodesics::none) children[paths.predecessor[i]].push_back(i);
    order.push_back(static_cast<std::uint32_t>(root));
    parent.push_back(0);
    for (std::uint32_t next = 0; next < order.size(); ++next)
      for (const std::uint32_t child : children[order[next]]) {
        order.push_back(child);
        parent.push_back(next);
      }
  }
  [[nodiscard]] std::size_t size() const { return order.size(); }
};

/// Length of what each point carries, and a mean link [L].
std::vector<double> weights(const PathTree& tree, const Vectors& places) {
  std::vector<double> carried(tree.size(), 0);
  double total = 0;
  for (std::size_t i = tree.size(); i-- > 1;) {
    const double length = (places[i] - places[tree.parent[i]]).norm();
    carried[tree.parent[i]] += carried[i] + length;
    total += length;
  }
  for (double& weight : carried)
    weight += total / static_cast<double>(tree.size());
  return carried;
}

/// The x that minimize the sum, over the links from a point to its parent p, of
/// a |x + x_p - sum|^2 + b |x - x_p - step|^2 + c |x - own|^2, given x of the root; all weights by
/// the point. Eliminates from the tips to the root, then puts in on the path back.
struct TreeEquations {
  std::vector<double> a, b, c;
  Vectors sum, step, own;

  [[nodiscard]] Vectors solve(const PathTree& tree, const Eigen::Vector3d& atRoot) const {
    std::vector<double> pull(tree.size(), 0); // of what a point carries: pull |x|^2 - 2 x . target
    Vectors target(tree.size(), Eigen::Vector3d::Zero());
    for (std::size_t i = tree.size(); i-- > 1;) {
      const double whole = a[i] + b[i] + c[i] + pull[i];
      const double mixed = a[i] - b[i];
      target[i] += a[i] * sum[i] + b[i] * step[i] + c[i] * own[i];
      pull[i] = whole;
      if (!(whole > 0)) continue;
      pull[tree.parent[i]] += a[i] + b[i] - mixed * mixed / whole;
      target[tree.parent[i]] += a[i] * sum[i] - b[i] * step[i] - mixed / whole * target[i];
    }
    Vectors x(tree.size(), atRoot);
    for (std::size_t i = 1; i < tree.size(); ++i) {
      const Eigen::Vector3d& below = x[tree.parent[i]];
      x[i] = pull[i] > 0 ? Eigen::Vector3d((target[i] - (a[i] - b[i]) * below) / pull[i]) : below;
    }
    return x;
  }
};

/// Equations with these weights, and nothing asked for.
TreeEquations equations(std::size_t size) {
  const std::vector<double> none(size, 0);
  const Vectors zero(size, Eigen::Vector3d::Zero());
  return {.a = none, .b = none, .c = none, .sum = zero, .step = zero, .own = zero};
}

/// Unit, or zero.
Eigen::Vector3d unit(const Eigen::Vector3d& v) {
  const double length = v.norm();
  return length > 0 ? Eigen::Vector3d(v / length) : Eigen::Vector3d::Zero();
}

Vectors directions(const PathTree& tree, const Vectors& places, const std::vector<double>& weight) {
  TreeEquations all = equations(tree.size());
  Eigen::Vector3d atRoot = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < tree.size(); ++i) {
    const Eigen::Vector3d link = unit(places[i] - places[tree.parent[i]]);
    all.b[i] = (weight[i] + weight[tree.parent[i]]) / 2; // like the parent
    all.c[i] = link.isZero() ? 0 : weight[i];            // like the link
    all.own[i] = link;
    if (tree.parent[i] == 0) atRoot += weight[i] * link;
  }
  Vectors found = all.solve(tree, unit(atRoot));
  for (Eigen::Vector3d& direction : found)
    direction = unit(direction);
  return found;
}

Vectors moved(const PathTree& tree, const Vectors& places) {
  const std::vector<double> weight = weights(tree, places);
  const Vectors direction = directions(tree, places, weight);
  TreeEquations all = equations(tree.size());
  for (std::size_t i = 1; i < tree.size(); ++i) {
    const std::uint32_t parent = tree.parent[i];
    all.a[i] = weight[i];
    all.b[i] = (weight[i] + weight[parent]) / 2;
    all.sum[i] = places[i] + places[parent];
    all.step[i] = (places[i] - places[parent]).norm() * unit(direction[i] + direction[parent]);
  }
  return all.solve(tree, places[0]);
}

} // namespace

Eigen::Matrix3Xf contractedAlongPaths(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                      const PathBasedOptions& options, const Progress& progress) {
  if (points.cols() < 2) return points;
  assert(root >= 0 && root < points.cols());
  const NeighborhoodGraph parts(points, options.neighbors, progress.part(0, 0.4));
  const NeighborhoodGraph graph =
      joined(parts, points, std::numeric_limits<float>::max(), progress.part(0.4, 0.6));
  const PathTree tree(geodesics(graph, {root}, 1, progress.part(0.6, 0.8)), root);
  Vectors places(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i)
    places[i] = (points.col(tree.order[i]) - points.col(root)).cast<double>();
  for (int round = 0; round < options.rounds; ++round) {
    progress.update(0.8 + 0.2 * round / options.rounds);
    places = moved(tree, places);
  }
  Eigen::Matrix3Xf result = points;
  for (std::size_t i = 0; i < tree.size(); ++i)
    result.col(tree.order[i]) = (places[i] + points.col(root).cast<double>()).cast<float>();
  progress.update(1);
  return result;
}

} // namespace espalier
