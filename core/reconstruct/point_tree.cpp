#include "core/reconstruct/point_tree.h"

#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"
#include "core/reconstruct/reached_points.h"

#include <algorithm>
#include <cmath>

namespace espalier {

PointTree::Children PointTree::children() const {
  Children result(size());
  for (std::size_t i = 1; i < size(); ++i)
    result[parents[i]].push_back(static_cast<std::uint32_t>(i));
  return result;
}

std::vector<double> PointTree::longestDown() const {
  std::vector<double> longest(size(), 0);
  for (std::size_t i = size(); i-- > 1;)
    longest[parents[i]] = std::max(longest[parents[i]], longest[i] + edge(i).norm());
  return longest;
}

std::vector<double> PointTree::lengthCarried() const {
  std::vector<double> carried(size(), 0);
  for (std::size_t i = size(); i-- > 1;)
    carried[parents[i]] += carried[i] + edge(i).norm();
  return carried;
}

PointTree shortestPathTree(const Eigen::Matrix3Xf& points, Eigen::Index root,
                           const PointTreeOptions& options, const Progress& progress) {
  const NeighborhoodGraph parts(points, options.neighbors, progress.part(0, 0.5));
  const float widestGap = options.widestGap > 0 ? static_cast<float>(options.widestGap)
                                                : std::numeric_limits<float>::max();
  const NeighborhoodGraph graph = joined(parts, points, widestGap, progress.part(0.5, 0.7));
  const Geodesics paths = geodesics(graph, {root}, options.power, progress.part(0.7, 1));
  requireHalf(std::ranges::count_if(paths.distance, [](float d) { return std::isfinite(d); }),
              points.cols());
  // The root comes first: it and the point that was first change places.
  const auto swapped = [&](std::size_t point) {
    const auto first = static_cast<std::size_t>(root);
    return point == first ? 0 : point == 0 ? first : point;
  };
  std::vector<Eigen::Vector3d> positions(static_cast<std::size_t>(points.cols()));
  PointTree::Children children(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::size_t number = swapped(i);
    positions[number] = points.col(static_cast<Eigen::Index>(i)).cast<double>();
    if (paths.predecessor[i] != Geodesics::none)
      children[swapped(paths.predecessor[i])].push_back(static_cast<std::uint32_t>(number));
  }
  return renumbered(positions, children);
}

PointTree renumbered(const std::vector<Eigen::Vector3d>& positions,
                     const PointTree::Children& children) {
  PointTree tree;
  std::vector<std::uint32_t> old = {0};
  tree.parents.push_back(PointTree::none);
  for (std::size_t next = 0; next < old.size(); ++next) {
    tree.positions.push_back(positions[old[next]]);
    for (const std::uint32_t child : children[old[next]]) {
      old.push_back(child);
      tree.parents.push_back(static_cast<std::uint32_t>(next));
    }
  }
  return tree;
}

Skeleton skeletonOf(const PointTree& tree, double spacing) {
  Skeleton skeleton;
  std::vector<NodeId> ids;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (tree.parents[i] == PointTree::none) {
      ids.push_back(skeleton.add({.position = tree.positions[i]}));
      continue;
    }
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(tree.edge(i).norm() / spacing - 1e-6)));
    NodeId below = ids[tree.parents[i]];
    for (int piece = 1; piece <= pieces; ++piece) {
      const Eigen::Vector3d place =
          piece == pieces ? tree.positions[i]
                          : Eigen::Vector3d(tree.positions[tree.parents[i]] +
                                            static_cast<double>(piece) / pieces * tree.edge(i));
      below = skeleton.add({.position = place, .parent = below});
    }
    ids.push_back(below);
  }
  return skeleton;
}

} // namespace espalier
