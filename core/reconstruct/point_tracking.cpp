#include "core/reconstruct/point_tracking.h"

#include "core/base/parallel.h"
#include "core/graph/neighborhood_graph.h"
#include "core/graph/orientations.h"
#include "core/reconstruct/attractors.h"
#include "core/reconstruct/direction_clusters.h"
#include "core/reconstruct/direction_cones.h"
#include "core/reconstruct/growing_tree.h"
#include "core/reconstruct/reached_points.h"
#include "core/reconstruct/thick_wood.h"

#include <Eigen/Geometry>

namespace espalier {
namespace {

constexpr std::size_t fewestForClusters = 30; // points, for an honest number of clusters

/// The points that a node sees.
struct View {
  std::vector<std::uint32_t> points;
  std::vector<Eigen::Vector3d> directions; // unit
};

class Tracker {
public:
  /// @param wood  how it runs, by point; empty: directions to the points are clustered
  Tracker(Attractors& attractors, const std::vector<Orientation>& wood,
          const PointTrackingOptions& options)
      : attractors_(attractors), wood_(wood), options_(options), cones_(options.coneAngle),
        tree_(attractors, {options.leastStep, options.greatestStep}, options.kill, options.reach) {}

  Skeleton grow(const Eigen::Vector3d& root, Eigen::Index points, const Progress& progress) {
    std::vector<std::uint32_t> growing = {tree_.addRoot(root)};
    headings_.push_back(firstHeading());
    while (!growing.empty()) {
      progress.update(static_cast<double>(attractors_.dead()) / static_cast<double>(points));
      std::vector<GrowingTree::Shoot> shoots = shootsOf(growing, progress);
      if (shoots.empty()) shoots = tree_.shootsAcrossGaps(options_.widestGap, progress);
      for (const GrowingTree::Shoot& shoot : shoots) {
        const Eigen::Vector3d direction = (shoot.place - tree_.place(shoot.parent)).normalized();
        headings_.push_back(headings_[shoot.parent].turnedTo(direction));
      }
      growing = tree_.add(shoots, progress);
    }
    return tree_.skeleton();
  }

private:
  [[nodiscard]] View viewOf(std::uint32_t node) const {
    View view;
    view.points = attractors_.around(tree_.place(node), tree_.reach(node));
    for (const std::uint32_t point : view.points)
      view.directions.push_back((attractors_.position(point) - tree_.place(node)).normalized());
    return view;
  }

  /// Towards the points around the root; its side to the one farthest off that way, so that it
  /// turns with the plant.
  [[nodiscard]] Heading firstHeading() const {
    const View view = viewOf(0);
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& direction : view.directions)
      along += direction;
    along = along.norm() > 0 ? Eigen::Vector3d(along.normalized()) : Eigen::Vector3d::UnitZ();
    Eigen::Vector3d side = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& direction : view.directions) {
      const Eigen::Vector3d across = direction - direction.dot(along) * along;
      if (across.squaredNorm() > side.squaredNorm()) side = across;
    }
    return {along, side.norm() > 1e-9 ? Eigen::Vector3d(side.normalized())
                                      : Eigen::Vector3d(along.unitOrthogonal())};
  }

  /// By clusters where points are dense enough to find them, by cones elsewhere.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groupsOf(std::uint32_t node,
                                                               const View& view) const {
    const bool areEnough = view.points.size() >= fewestForClusters;
    if (areEnough && tree_.density(node) > options_.clusterDensity) {
      std::vector<Eigen::Vector3d> ahead(view.points.size()); // as the cones look ahead only
      for (std::size_t i = 0; i < ahead.size(); ++i)
        ahead[i] = view.directions[i].dot(headings_[node].along) > 0 ? clusteredOf(view, i)
                                                                     : Eigen::Vector3d::Zero();
      return directionClusters(ahead);
    }
    return cones_.groups(headings_[node], view.directions);
  }

  /// The wood at a point runs away from the node.
  [[nodiscard]] Eigen::Vector3d clusteredOf(const View& view, std::size_t i) const {
    const Eigen::Vector3d& direction = view.directions[i];
    if (wood_.empty()) return direction;
    const Eigen::Vector3d along = wood_[view.points[i]].direction.cast<double>();
    return along.dot(direction) < 0 ? Eigen::Vector3d(-along) : along;
  }

  [[nodiscard]] std::vector<GrowingTree::Shoot> shootsOf(std::uint32_t node) const {
    std::vector<GrowingTree::Shoot> shoots;
    const View view = viewOf(node);
    for (const std::vector<std::size_t>& group : groupsOf(node, view)) {
      if (group.size() < static_cast<std::size_t>(options_.fewestPoints)) continue;
      std::vector<std::uint32_t> own;
      for (const std::size_t i : group)
        if (attractors_.isOf(node, view.points[i])) own.push_back(view.points[i]);
      if (own.empty()) continue;
      if (const auto shoot = tree_.shootTowards(node, own)) shoots.push_back(*shoot);
    }
    return shoots;
  }

  [[nodiscard]] std::vector<GrowingTree::Shoot> shootsOf(const std::vector<std::uint32_t>& nodes,
                                                         const Progress& progress) const {
    std::vector<std::vector<GrowingTree::Shoot>> found(nodes.size());
    const auto find = [&](Eigen::Index i) {
      const auto at = static_cast<std::size_t>(i);
      found[at] = shootsOf(nodes[at]);
    };
    parallelFor(static_cast<Eigen::Index>(nodes.size()), find, progress.part(0, 0), 8);
    std::vector<GrowingTree::Shoot> shoots;
    for (const auto& each : found)
      shoots.insert(shoots.end(), each.begin(), each.end());
    return shoots;
  }

  Attractors& attractors_;
  const std::vector<Orientation>& wood_;
  const PointTrackingOptions& options_;
  DirectionCones cones_;
  GrowingTree tree_;
  std::vector<Heading> headings_; // by node
};

std::vector<Orientation> woodAt(const Eigen::Matrix3Xf& points, const PointTrackingOptions& options,
                                const Progress& progress) {
  if (options.clustered == ClusteredDirections::toPoints) return {};
  constexpr int neighbors = 7; // as contractions have it
  const NeighborhoodGraph graph(points, neighbors, progress.part(0, 0.5));
  return orientations(points, graph, static_cast<float>(options.leastStep), progress.part(0.5, 1));
}

} // namespace

Skeleton skeletonByPointTracking(const Eigen::Matrix3Xf& points,
                                 const std::vector<float>& densities, Eigen::Index root,
                                 const PointTrackingOptions& options, const Progress& progress) {
  const Eigen::Matrix3Xf drawn = withThickWoodAsLines(
      points, root, {.radius = options.thickWood, .widestGap = options.widestGap},
      progress.part(0, 0.2));
  const SpatialIndex index(drawn, progress);
  Attractors attractors(drawn, index, densities);
  const std::vector<Orientation> wood = woodAt(drawn, options, progress.part(0.2, 0.3));
  Tracker tracker(attractors, wood, options);
  Skeleton skeleton =
      tracker.grow(drawn.col(root).cast<double>(), drawn.cols(), progress.part(0.3, 0.9));
  requireHalf(attractors.reached(), drawn.cols());
  return withMeanDistances(std::move(skeleton), points, progress.part(0.9, 1));
}

} // namespace espalier
