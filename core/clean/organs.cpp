#include "core/clean/organs.h"

#include "core/clean/organ_odds.h"
#include "core/graph/find_root.h"

namespace espalier {
namespace {

std::optional<Eigen::Index> rootAmongWood(const Eigen::Matrix3Xf& points,
                                          const std::vector<Organ>& organs,
                                          const Progress& progress) {
  std::vector<Eigen::Index> wood;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (organs[static_cast<std::size_t>(i)] == Organ::wood) wood.push_back(i);
  if (wood.empty()) return std::nullopt;
  const Eigen::Matrix3Xf places = points(Eigen::all, wood);
  return wood[static_cast<std::size_t>(findRoot(places, UpAxis::z, progress))];
}

} // namespace

FoundOrgans organsAmong(const Eigen::Matrix3Xf& points, std::optional<Eigen::Index> root,
                        double spacing, const Progress& progress) {
  const PointPyramid pyramid = organPyramid(points, progress.part(0, 0.4));
  const auto classified = [&](Eigen::Index from, const Progress& part) {
    return organsBy(fittedOrganOdds(), pyramid,
                    organFeatures(pyramid, from, spacing, part.part(0, 0.7)), part.part(0.7, 1));
  };
  FoundOrgans found{.root = root ? *root : findRoot(points, UpAxis::z, progress.part(0.4, 0.45))};
  found.ofPoint = classified(found.root, progress.part(0.45, 0.75));
  if (root || found.ofPoint[static_cast<std::size_t>(found.root)] == Organ::wood) return found;
  const auto better = rootAmongWood(points, found.ofPoint, progress.part(0.75, 0.8));
  if (!better) return found;
  found.root = *better;
  found.ofPoint = classified(found.root, progress.part(0.8, 1));
  return found;
}

} // namespace espalier
