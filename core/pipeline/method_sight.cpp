#include "core/pipeline/method_sight.h"

#include "core/base/moments.h"
#include "core/base/spatial_index.h"
#include "core/contract/ball_centers.h"
#include "core/contract/density_radii.h"
#include "core/contract/section_grower.h"
#include "core/contract/stretched_length.h"
#include "core/graph/geodesic.h"
#include "core/graph/orientations.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/used_densities.h"
#include "core/reconstruct/direction_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

namespace espalier {
namespace {

/// A method with its values by name.
struct Named {
  std::string method;
  std::map<std::string, double, std::less<>> values;

  Named(const std::string& step, const PipelineOptions& options, const PlantScale& scale) {
    const Method& chosen = chosenMethod(stepNamed(step), options);
    const std::vector<double> all = resolvedValues(stepNamed(step), chosen, options, scale);
    method = chosen.name;
    for (std::size_t i = 0; i < all.size(); ++i)
      values[chosen.options[i].name] = all[i];
  }
  [[nodiscard]] double value(std::string_view name, double otherwise = 0) const {
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
  }
  [[nodiscard]] bool has(std::string_view name) const { return values.contains(name); }
};

PipelineState cleanedState(const std::shared_ptr<const PointCloud>& cloud,
                           const PipelineOptions& options, const PlantScale& scale,
                           const Progress& progress) {
  requireKnown(options);
  const Method& clean = chosenMethod(stepNamed("clean"), options);
  PipelineState state = firstState(cloud, options.leftOut);
  clean.run(state, resolvedValues(stepNamed("clean"), clean, options, scale), progress);
  return state;
}

Moments momentsOf(const Eigen::Matrix3Xf& points, const std::vector<std::uint32_t>& members,
                  std::uint32_t about) {
  Moments moments(points.col(about).cast<double>());
  for (const std::uint32_t member : members)
    moments.add(Eigen::Vector3f(points.col(member)));
  return moments;
}

constexpr int linksOtherwise = 7; // of methods that have no links
constexpr int nearestOfNormals = 16;

} // namespace

/// Points are those that cleaning keeps, by their place among them.
struct MethodSights::Prepared {
  std::shared_ptr<const PointCloud> cloud;
  std::shared_ptr<const Eigen::Matrix3Xf> contracted;
  Named contraction;
  Named tracking; // the method of the skeleton, whichever it is
  std::vector<Eigen::Index> columns;
  Eigen::Matrix3Xf points;
  NeighborhoodGraph graph;
  SpatialIndex index;
  std::vector<float> densities;         // normalized
  std::vector<float> trackingDensities; // likewise; empty if points are not tracked

  Prepared(std::shared_ptr<const PointCloud> itsCloud,
           std::shared_ptr<const Eigen::Matrix3Xf> itsContracted, const PipelineState& cleaned,
           const PipelineOptions& options, const PlantScale& scale, const Progress& progress)
      : cloud(std::move(itsCloud)), contracted(std::move(itsContracted)),
        contraction("contract", options, scale), tracking("skeleton", options, scale),
        columns(keptPoints(cleaned)), points(cloud->positions()(Eigen::all, columns)),
        graph(points, links(), progress.part(0, 0.4)), index(points, progress) {
    if (columns.empty()) return;
    const bool isTracked = tracking.method == "point_tracking";
    const bool followsDensity = contraction.has("density_radius");
    if (isTracked || !followsDensity) densities = scannedDensities(index, progress.part(0.4, 0.7));
    if (isTracked) trackingDensities = densities;
    if (followsDensity)
      densities = normalizedDensities(radiusDensities(
          graph, static_cast<float>(contraction.value("density_radius")), progress.part(0.7, 1)));
  }

  [[nodiscard]] int links() const {
    const bool areNearest = contraction.method.ends_with("laplacian");
    return areNearest ? linksOtherwise
                      : static_cast<int>(contraction.value("neighbors", linksOtherwise));
  }

  /// [L]; 0 for methods that look at nearest points or links.
  [[nodiscard]] double radiusAt(std::uint32_t point) const {
    if (contraction.has("density_radius"))
      return radiusOfDensity(densities[point], {.least = contraction.value("least_radius"),
                                                .most = contraction.value("most_radius"),
                                                .curve = contraction.value("curve")});
    for (const char* name : {"radius", "last_radius", "reach"})
      if (contraction.has(name)) return contraction.value(name);
    return 0;
  }

  [[nodiscard]] Orientation orientationAt(std::uint32_t point, double radius) const {
    std::vector<std::uint32_t> members;
    GeodesicBall ball(graph);
    for (const GeodesicBall::Member& member : ball.around(point, static_cast<float>(radius)))
      members.push_back(member.point);
    if (members.size() < 3 || radius <= 0) members = withLinks(point);
    return orientationOf(momentsOf(points, members, point));
  }

  [[nodiscard]] std::vector<std::uint32_t> withLinks(std::uint32_t point) const {
    std::vector<std::uint32_t> members = {point};
    for (const NeighborhoodGraph::Link& link : graph.links(point))
      members.push_back(link.to);
    return members;
  }

  [[nodiscard]] std::vector<std::uint32_t> ballAt(std::uint32_t point, double radius,
                                                  const Orientation& orientation) const {
    const std::string& method = contraction.method;
    if (method == "none") return {point};
    if (method == "adaptive_sections")
      return SectionGrower(points, graph)
          .around(point, orientation.direction, static_cast<float>(contraction.value("width")),
                  static_cast<float>(radius));
    if (method == "geodesic_centroid" || method == "adaptive_geodesic")
      return alongPlant(point, radius, orientation);
    if (radius > 0) return inSpace(index.within(points.col(point), static_cast<float>(radius)));
    if (method == "path_based") return withLinks(point);
    const int count = static_cast<int>(contraction.value("neighbors"));
    std::vector<std::uint32_t> nearest = inSpace(index.nearest(points.col(point), count + 1));
    std::erase(nearest, point); // it does not count
    return nearest;
  }

  [[nodiscard]] std::vector<std::uint32_t> alongPlant(std::uint32_t point, double radius,
                                                      const Orientation& orientation) const {
    GeodesicBalls balls(graph);
    const std::array<Eigen::Vector3f, 1> directions = {orientation.direction};
    const double along = contraction.value("along", 1);
    const double across = contraction.value("across", 1);
    const GeodesicBalls::Lanes radii = GeodesicBalls::Lanes::Constant(static_cast<float>(radius));
    const std::array<std::uint32_t, 1> centers = {point};
    if (along != 1 || across != 1)
      balls.find(centers, radii, StretchedLength(points, directions, along, across));
    else
      balls.find(centers, radii);
    std::vector<std::uint32_t> members;
    balls.forEachMember([&](std::size_t /*center*/, std::uint32_t member, float /*distance*/) {
      members.push_back(member);
    });
    return members;
  }

  static std::vector<std::uint32_t> inSpace(const std::vector<Neighbor>& found) {
    std::vector<std::uint32_t> members;
    members.reserve(found.size());
    for (const Neighbor& neighbor : found)
      members.push_back(static_cast<std::uint32_t>(neighbor.index));
    return members;
  }

  [[nodiscard]] std::optional<WoodCircle> circleOf(const std::vector<std::uint32_t>& ball,
                                                   double radius,
                                                   const Orientation& orientation) const {
    if (contraction.value("circles") == 0 || ball.empty()) return std::nullopt;
    std::vector<Eigen::Vector3f> members;
    members.reserve(ball.size());
    for (const std::uint32_t member : ball)
      members.emplace_back(points.col(member));
    std::optional<WoodCircle> circle;
    if (contraction.method != "adaptive_sections")
      circle = circleOfBall(members, radius);
    else if (!orientation.direction.isZero())
      circle = circleAround(members, orientation.direction.cast<double>().normalized(), radius);
    if (circle) circle->center += cloud->origin();
    return circle;
  }

  [[nodiscard]] Eigen::Vector3d normalAt(std::uint32_t point) const {
    std::vector<std::uint32_t> nearest =
        inSpace(index.nearest(points.col(point), nearestOfNormals));
    return momentsOf(points, nearest, point).components().eigenvectors().col(0);
  }

  [[nodiscard]] std::vector<SightCone> conesAt(const Eigen::Vector3d& place,
                                               const Skeleton& skeleton) const {
    if (trackingDensities.empty() || skeleton.isEmpty()) return {};
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
    const double least = tracking.value("least_step");
    const double step =
        least + static_cast<double>(trackingDensities[static_cast<std::size_t>(nearest)]) *
                    (tracking.value("greatest_step") - least);
    const double angle = tracking.value("cone_angle") * std::numbers::pi / 180;
    const Heading heading{along.normalized(), along.normalized().unitOrthogonal()};
    std::vector<SightCone> cones;
    for (const Eigen::Vector3d& axis : DirectionCones(angle).axes(heading))
      cones.push_back({.apex = node.position,
                       .direction = axis,
                       .angle = angle,
                       .length = tracking.value("reach") * step});
    return cones;
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
  const PipelineState cleaned = cleanedState(cloud, options, scale, progress.part(0, 0.2));
  prepared_ = std::make_unique<const Prepared>(std::move(cloud), std::move(contracted), cleaned,
                                               options, scale, progress.part(0.2, 1));
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
  if (all.points.col(own) != all.cloud->positions().col(point)) return sight;
  const double radius = all.radiusAt(own);
  const Orientation orientation =
      all.orientationAt(own, all.contraction.value("orientation_radius", radius));
  const std::vector<std::uint32_t> ball = all.ballAt(own, radius, orientation);
  std::vector<std::uint32_t> linked = all.withLinks(own);
  linked.erase(linked.begin());
  sight.neighbors = all.ascendingColumns(linked);
  sight.ball = all.ascendingColumns(ball);
  sight.direction = orientation.direction.cast<double>();
  sight.linearity = static_cast<double>(orientation.linearity);
  sight.normal = all.normalAt(own);
  sight.radius = radius;
  sight.density = static_cast<double>(all.densities[own]);
  sight.circle = all.circleOf(ball, radius, orientation);
  sight.cones = all.conesAt(all.cloud->position(point), skeleton);
  for (const Eigen::Index member : sight.ball) // of methods that look at nearest points or links
    if (radius == 0)
      sight.radius =
          std::max(sight.radius, (all.cloud->position(member) - all.cloud->position(point)).norm());
  return sight;
}

} // namespace espalier
