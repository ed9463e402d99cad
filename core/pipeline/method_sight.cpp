#include "core/pipeline/method_sight.h"

#include "core/base/moments.h"
#include "core/base/spatial_index.h"
#include "core/graph/geodesic.h"
#include "core/graph/orientations.h"
#include "core/pipeline/contract_probes.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/step_graph.h"
#include "core/reconstruct/direction_cones.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

Moments momentsOf(const Eigen::Matrix3Xf& points, const std::vector<std::uint32_t>& members,
                  std::uint32_t about) {
  Moments moments(points.col(about).cast<double>());
  for (const std::uint32_t member : members)
    moments.add(Eigen::Vector3f(points.col(member)));
  return moments;
}

constexpr int nearestOfNormals = 16;

} // namespace

/// Points are those that cleaning keeps, by their place among them.
struct MethodSights::Prepared {
  std::shared_ptr<const PointCloud> cloud;
  std::shared_ptr<const Eigen::Matrix3Xf> contracted;
  MethodProbe contraction;
  std::optional<ConeProbe> cones;
  std::vector<Eigen::Index> columns;
  Eigen::Matrix3Xf points;
  NeighborhoodGraph graph;
  SpatialIndex index;
  std::vector<float> densities;     // normalized
  std::vector<float> coneDensities; // likewise; empty without cones

  Prepared(std::shared_ptr<const PointCloud> itsCloud,
           std::shared_ptr<const Eigen::Matrix3Xf> itsContracted, const PipelineState& smoothed,
           const PipelineOptions& options, const PlantScale& scale, const Progress& progress)
      : cloud(std::move(itsCloud)), contracted(std::move(itsContracted)),
        contraction(chosenFor(contractionStep(), options, scale).probe()),
        cones(chosenFor(skeletonStep(), options, scale).probe().cones),
        columns(keptPoints(smoothed)), points((*smoothed.contracted)(Eigen::all, columns)),
        graph(points, contraction.links, progress.part(0, 0.4)), index(points, progress) {
    if (columns.empty()) return;
    const std::optional<DensityValues>& followed = contraction.density;
    if (cones || !followed)
      densities =
          scannedDensities(*scannedIndex(smoothed, columns, progress),
                           cones ? cones->measure : DensityMeasure::range, progress.part(0.4, 0.7));
    if (cones) coneDensities = densities;
    if (followed)
      densities = normalizedDensities(
          radiusDensities(graph, static_cast<float>(followed->radius), progress.part(0.7, 1)),
          followed->measure);
  }

  [[nodiscard]] SeenPoints seen() const { return {points, graph, index}; }

  [[nodiscard]] Orientation orientationAt(std::uint32_t point, double radius) const {
    std::vector<std::uint32_t> members;
    GeodesicBall ball(graph);
    for (const GeodesicBall::Member& member : ball.around(point, static_cast<float>(radius)))
      members.push_back(member.point);
    if (members.size() < 3 || radius <= 0) members = withLinks(seen(), point);
    return orientationOf(momentsOf(points, members, point));
  }

  [[nodiscard]] SeenFrom from(std::uint32_t point) const {
    SeenFrom from{.point = point};
    if (contraction.radius) from.radius = contraction.radius(densities[point]);
    from.orientation = orientationAt(point, contraction.orientationRadius.value_or(from.radius));
    return from;
  }

  [[nodiscard]] std::optional<WoodCircle> circleOf(const SeenBall& ball,
                                                   const SeenFrom& from) const {
    if (!contraction.circle || ball.empty()) return std::nullopt;
    std::vector<Eigen::Vector3f> members;
    members.reserve(ball.size());
    for (const std::uint32_t member : ball)
      members.emplace_back(points.col(member));
    std::optional<WoodCircle> circle = contraction.circle(members, from);
    if (circle) circle->center += cloud->origin();
    return circle;
  }

  [[nodiscard]] Eigen::Vector3d normalAt(std::uint32_t point) const {
    return momentsOf(points, nearestPoints(seen(), point, nearestOfNormals), point)
        .components()
        .eigenvectors()
        .col(0);
  }

  [[nodiscard]] std::vector<SightCone> conesAt(const Eigen::Vector3d& place,
                                               const Skeleton& skeleton) const {
    if (coneDensities.empty() || skeleton.isEmpty()) return {};
    const std::vector<NodeId> ids = skeleton.ids();
    const NodeId id = *std::ranges::min_element(
        ids, {}, [&](NodeId each) { return (skeleton[each].position - place).squaredNorm(); });
    const Node& node = skeleton[id];
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    if (node.parent) along = node.position - skeleton[*node.parent].position;
    for (const NodeId child : skeleton.children(id))
      if (along.isZero()) along = skeleton[child].position - node.position;
    if (along.isZero()) return {};
    const Eigen::Matrix3Xf attractors = (*contracted)(Eigen::all, columns);
    const Eigen::Index nearest =
        nearestPoint(attractors, (node.position - cloud->origin()).cast<float>());
    const double length =
        cones->length(static_cast<double>(coneDensities[static_cast<std::size_t>(nearest)]));
    const Heading heading{along.normalized(), along.normalized().unitOrthogonal()};
    std::vector<SightCone> result;
    for (const Eigen::Vector3d& axis : DirectionCones(cones->angle).axes(heading))
      result.push_back({node.position, axis, cones->angle, length});
    return result;
  }

  [[nodiscard]] std::vector<Eigen::Index>
  ascendingColumns(const std::vector<std::uint32_t>& members) const {
    std::vector<Eigen::Index> result;
    result.reserve(members.size());
    for (const std::uint32_t member : members)
      result.push_back(columns[member]);
    std::ranges::sort(result);
    return result;
  }
};

MethodSights::MethodSights(std::shared_ptr<const PointCloud> cloud,
                           std::shared_ptr<const Eigen::Matrix3Xf> contracted,
                           const PipelineOptions& options, const PlantScale& scale,
                           const Progress& progress) {
  PipelineState state = cleanedState(cloud, options, scale, progress.part(0, 0.1));
  const PlantScale left = state.extent.scale;
  runSteps(stepsBetween(StepResult::cleaned, StepResult::smoothed, options, left), state,
           progress.part(0.1, 0.2));
  prepared_ = std::make_unique<const Prepared>(std::move(cloud), std::move(contracted), state,
                                               options, left, progress.part(0.2, 1));
}
MethodSights::~MethodSights() = default;
MethodSights::MethodSights(MethodSights&&) noexcept = default;
MethodSights& MethodSights::operator=(MethodSights&&) noexcept = default;

MethodSight MethodSights::at(Eigen::Index point, const Skeleton& skeleton) const {
  const Prepared& all = *prepared_;
  MethodSight sight;
  sight.point = point;
  sight.moved = all.contracted->col(point).cast<double>() + all.cloud->origin();
  const auto behind =
      std::ranges::upper_bound(all.columns, point); // of its place, the first counts
  if (behind == all.columns.begin()) return sight;
  const auto own = static_cast<std::uint32_t>(behind - all.columns.begin() - 1);
  if (all.cloud->positions().col(all.columns[own]) != all.cloud->positions().col(point))
    return sight;
  const SeenFrom from = all.from(own);
  const SeenBall ball =
      all.contraction.ball ? all.contraction.ball(all.seen(), from) : SeenBall{own};
  SeenBall linked = withLinks(all.seen(), own);
  linked.erase(linked.begin());
  sight.neighbors = all.ascendingColumns(linked);
  sight.ball = all.ascendingColumns(ball);
  sight.direction = from.orientation.direction.cast<double>();
  sight.linearity = static_cast<double>(from.orientation.linearity);
  sight.normal = all.normalAt(own);
  sight.radius = from.radius;
  sight.density = static_cast<double>(all.densities[own]);
  sight.circle = all.circleOf(ball, from);
  sight.cones = all.conesAt(all.cloud->position(point), skeleton);
  for (const Eigen::Index member : sight.ball) // of methods that look at nearest points or links
    if (from.radius == 0)
      sight.radius =
          std::max(sight.radius, (all.cloud->position(member) - all.cloud->position(point)).norm());
  return sight;
}

} // namespace espalier
