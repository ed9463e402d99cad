#include "core/reconstruct/space_colonization.h"

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
  if (const auto shoot = tree.shootTowards(node, own)) return shoot;
  const Eigen::Vector3d first = attractors.position(own.front()) - tree.place(node);
  std::vector<std::uint32_t> side;
  for (const std::uint32_t point : own)
    if ((attractors.position(point) - tree.place(node)).dot(first) > 0) side.push_back(point);
  return tree.shootTowards(node, side);
}

} // namespace

Skeleton skeletonBySpaceColonization(const Eigen::Matrix3Xf& points,
                                     const std::vector<float>& densities, Eigen::Index root,
                                     const SpaceColonizationOptions& options,
                                     const Progress& progress) {
  const Eigen::Matrix3Xf drawn = withThickWoodAsLines(
      points, root, {.radius = options.thickWood, .widestGap = options.widestGap},
      progress.part(0, 0.2));
  Attractors attractors(drawn, densities, progress);
  GrowingTree tree(attractors, {options.leastStep, options.greatestStep}, options.kill,
                   options.reach);
  std::vector<std::uint32_t> growing = {tree.add(drawn.col(root).cast<double>(), std::nullopt)};
  const Progress growth = progress.part(0.2, 0.9);
  while (!growing.empty()) {
    growth.update(static_cast<double>(attractors.dead()) / static_cast<double>(drawn.cols()));
    std::vector<GrowingTree::Shoot> shoots;
    std::vector<std::uint32_t> next;
    for (const std::uint32_t node : growing) {
      progress.check();
      if (const auto shoot = shootOf(node, attractors, tree)) {
        shoots.push_back(*shoot);
        next.push_back(node); // what is left of its points may pull it elsewhere
      }
    }
    if (shoots.empty()) shoots = tree.shootsAcrossGaps(options.widestGap, progress);
    for (const GrowingTree::Shoot& shoot : shoots)
      next.push_back(tree.add(shoot.place, shoot.parent));
    growing = std::move(next);
  }
  requireHalf(attractors.reached(), drawn.cols());
  return withMeanDistances(tree.skeleton(), points, progress.part(0.9, 1));
}

} // namespace espalier
