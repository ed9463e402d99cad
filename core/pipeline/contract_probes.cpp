#include "core/pipeline/contract_probes.h"

#include "core/contract/ball_centers.h"
#include "core/contract/section_grower.h"
#include "core/contract/stretched_length.h"

#include <array>

namespace espalier {
namespace {

SeenBall placesOf(const std::vector<Neighbor>& found) {
  SeenBall places;
  places.reserve(found.size());
  for (const Neighbor& neighbor : found)
    places.push_back(static_cast<std::uint32_t>(neighbor.index));
  return places;
}

SeenBall ballInSpace(const SeenPoints& seen, const SeenFrom& from) {
  return placesOf(
      seen.index.within(seen.positions.col(from.point), static_cast<float>(from.radius)));
}

} // namespace

SeenBall ballAlongPlant(const SeenPoints& seen, const SeenFrom& from, double along, double across) {
  GeodesicBalls balls(seen.graph);
  const std::array<Eigen::Vector3f, 1> directions = {from.orientation.direction};
  const auto radii = GeodesicBalls::Lanes::Constant(static_cast<float>(from.radius)).eval();
  const std::array<std::uint32_t, 1> centers = {from.point};
  if (along != 1 || across != 1)
    balls.find(centers, radii, StretchedLength(seen.positions, directions, along, across));
  else
    balls.find(centers, radii);
  SeenBall places;
  balls.forEachMember([&](std::size_t /*center*/, std::uint32_t member, float /*distance*/) {
    places.push_back(member);
  });
  return places;
}

SeenBall sectionOfWood(const SeenPoints& seen, const SeenFrom& from, double halfThickness) {
  return SectionGrower(seen.positions, seen.graph)
      .around(from.point, from.orientation.direction, static_cast<float>(halfThickness),
              static_cast<float>(from.radius));
}

SeenBall withLinks(const SeenPoints& seen, std::uint32_t point) {
  SeenBall places = {point};
  for (const NeighborhoodGraph::Link& link : seen.graph.links(point))
    places.push_back(link.to);
  return places;
}

SeenBall nearestPoints(const SeenPoints& seen, std::uint32_t point, int count) {
  return placesOf(seen.index.nearest(seen.positions.col(point), count));
}

MethodProbe probeWithin(double radius) {
  return {.reach = radius,
          .radius = [radius](float /*density*/) { return radius; },
          .ball = ballInSpace};
}

MethodProbe probeOfNearest(int count) {
  return {.ball = [count](const SeenPoints& seen, const SeenFrom& from) {
    SeenBall nearest = nearestPoints(seen, from.point, count + 1);
    std::erase(nearest, from.point); // it does not count
    return nearest;
  }};
}

} // namespace espalier
