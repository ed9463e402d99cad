#include "core/reconstruct/space_colonization.h"

#include "core/base/parallel.h"
#include "core/reconstruct/attractors.h"
#include "core/reconstruct/growing_tree.h"
#include "core/reconstruct/reached_points.h"
#include "core/reconstruct/thick_wood.h"

namespace espalier {
namespace {

/// The next step of a node; where its points pull both ways, to the side of the first of them.
std::optional<GrowingTree::Shoot> shootOf(std::uint32_t node, Attractors& attractors,
                                          const GrowingTree& tree) {
  const std::vector<std::uint32_t>& own = attractors.of(node);
  if (own.empty()) return std::nullopt;
  if (auto shoot = tree.shootTowards(node, own)) return shoot;
  const Eigen::Vector3d first = attractors.position(own.front()) - tree.place(node);
  std::vector<std::uint32_t> side;
  for (const std::uint32_t point : own)
    if ((attractors.position(point) - tree.place(node)).dot(first) > 0) side.push_back(point);
  return tree.shootTowards(node, side);
}

/// Of those nodes that grow.
std::vector<GrowingTree::Shoot> shootsOf(const std::vector<std::uint32_t>& nodes,
                                         Attractors& attractors, const GrowingTree& tree,
                                         const Progress& progress) {
  std::vector<std::optional<GrowingTree::Shoot>> found(nodes.size());
  const auto find = [&](Eigen::Index i) {
    const auto at = static_cast<std::size_t>(i);
    found[at] = shootOf(nodes[at], attractors, tree);
  };
  parallelFor(static_cast<Eigen::Index>(nodes.size()), find, progress.part(0, 0), 8);
  std::vector<GrowingTree::Shoot> shoots;
  for (const auto& shoot : found)
    if (shoot) shoots.push_back(*shoot);
  return shoots;
}

} // namespace

Skeleton skeletonBySpaceColonization(const Eigen::Matrix3Xf& points,
                                     const std::vector<float>& densities, Eigen::Index root,
                                     const SpaceColonizationOptions& options,
                                     const Progress& progress, const SpatialIndex* index) {
  const Eigen::Matrix3Xf drawn = withThickWoodAsLines(
      points, root, {.radius = options.thickWood, .widestGap = options.widestGap},
      progress.part(0, 0.2));
  std::optional<SpatialIndex> ofDrawn;
  if (index == nullptr || options.thickWood > 0) index = &ofDrawn.emplace(drawn, progress);
  Attractors attractors(drawn, *index, densities);
  GrowingTree tree(attractors, {options.leastStep, options.greatestStep}, options.kill,
                   options.reach);
  std::vector<std::uint32_t> growing = {tree.addRoot(drawn.col(root).cast<double>())};
  const Progress growth = progress.part(0.2, 0.9);
  while (!growing.empty()) {
    growth.update(static_cast<double>(attractors.dead()) / static_cast<double>(drawn.cols()));
    std::vector<GrowingTree::Shoot> shoots = shootsOf(growing, attractors, tree, progress);
    growing.clear();
    for (const GrowingTree::Shoot& shoot : shoots)
      growing.push_back(shoot.parent); // what is left of its points may pull it elsewhere
    if (shoots.empty()) shoots = tree.shootsAcrossGaps(options.widestGap, progress);
    const std::vector<std::uint32_t> added = tree.add(shoots, progress);
    growing.insert(growing.end(), added.begin(), added.end());
  }
  requireHalf(attractors.reached(), drawn.cols());
  return withMeanDistances(tree.skeleton(), points, progress.part(0.9, 1));
}

} // namespace espalier
