#include "core/surface/envelopes/solids_of_revolution.h"

#include "core/base/shown.h"
#include "core/surface/envelopes/enclosing_ball.h"
#include "core/surface/envelopes/least_at.h"
#include "core/surface/envelopes/rings.h"

#include <limits>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

using std::numbers::pi;

/// A wall over a foot: r^power = at the foot, less `slope` for each length up.
struct Wall {
  double foot = 0;  // [L^power]
  double slope = 0; // >= 0 but of a frustum
  double volume = std::numeric_limits<double>::infinity();
};

/// Height above the foot and r^power.
using Place = Eigen::Vector2d;

/// The places that a straight wall can touch from outside, from the lowest up: the outer side of
/// their convex hull.
std::vector<Place> outerSide(std::vector<Place> places) {
  std::ranges::sort(places, [](const Place& a, const Place& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::vector<Place> side;
  for (const Place& place : places) {
    while (side.size() > 1) {
      const Place& a = side[side.size() - 2];
      const Place& b = side.back();
      const double turn =
          (b.x() - a.x()) * (place.y() - a.y()) - (b.y() - a.y()) * (place.x() - a.x());
      if (turn < 0) break;
      side.pop_back();
    }
    side.push_back(place);
  }
  return side;
}

/// The slopes of walls that touch a place of the outer side and cut none: from, to.
std::pair<double, double> slopesAt(const std::vector<Place>& side, std::size_t i) {
  constexpr double steepest = 1e12;
  const auto slope = [&](std::size_t from, std::size_t to) {
    const double rise = side[to].x() - side[from].x();
    if (rise <= 0) return side[to].y() > side[from].y() ? -steepest : steepest;
    return (side[from].y() - side[to].y()) / rise;
  };
  return {i == 0 ? -steepest : slope(i - 1, i), i + 1 == side.size() ? steepest : slope(i, i + 1)};
}

/// The least wall that ends in a point on the axis: of height 3 z where it touches a cone, 2 z for
/// a paraboloid, if it may turn about that place alone.
Wall pointedWall(const std::vector<Place>& side, int power) {
  const double share = 1 + 2.0 / power;
  Wall best;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const auto [from, to] = slopesAt(side, i);
    const double z = side[i].x();
    const double r = side[i].y();
    const double free = z > 0 ? r / ((share - 1) * z) : to;
    Wall wall;
    wall.slope = std::clamp(free, std::max(from, 0.0), std::max(to, 0.0));
    if (wall.slope <= 0 || wall.slope >= 1e12) continue;
    wall.foot = r + wall.slope * z;
    const double height = wall.foot / wall.slope;
    if (height < side.back().x() * (1 - 1e-12)) continue;
    wall.volume = pi * std::pow(wall.foot, 2.0 / power) * height / share;
    if (wall.volume < best.volume) best = wall;
  }
  return best;
}

/// The least wall between foot and top: pi h (m^2 + (slope h)^2 / 12), m its radius halfway up.
Wall frustumWall(const std::vector<Place>& side, double height) {
  Wall best;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const auto [from, to] = slopesAt(side, i);
    const double up = side[i].x() - height / 2;
    const double r = side[i].y();
    const double least = side[i].x() > 0 ? std::max(from, -r / side[i].x()) : from;
    const double most = side[i].x() < height ? std::min(to, r / (height - side[i].x())) : to;
    if (least > most) continue;
    Wall wall;
    wall.slope = std::clamp(-r * up / (up * up + height * height / 12), least, most);
    wall.foot = r + wall.slope * side[i].x();
    const double middle = r + wall.slope * up;
    const double spread = wall.slope * height;
    wall.volume = pi * height * (middle * middle + spread * spread / 12);
    if (wall.volume < best.volume) best = wall;
  }
  return best;
}

using WallOf = std::function<Wall(const std::vector<Place>&)>;

Wall wallAbout(const Crown& crown, const Eigen::Vector2d& axis, int power, const WallOf& wallOf) {
  const double foot = bottomOf(crown);
  std::vector<Place> places;
  for (const auto& corner : crown.hull.corners.colwise())
    places.emplace_back(corner.z() - foot, std::pow((corner.head<2>() - axis).norm(), power));
  return wallOf(outerSide(std::move(places)));
}

Ball3 circleAbove(const Crown& crown, const Progress& progress) {
  Eigen::Matrix3Xd flat = crown.hull.corners;
  flat.row(2).setZero();
  return enclosingBall(flat, progress);
}

struct Turned {
  Eigen::Vector2d axis;
  Wall wall;
};

Turned leastTurned(const Crown& crown, int power, const WallOf& wallOf, const Progress& progress) {
  const Ball3 circle = circleAbove(crown, progress);
  const auto volumeAbout = [&](const Eigen::VectorXd& axis) {
    return wallAbout(crown, axis, power, wallOf).volume;
  };
  Eigen::VectorXd axis = circle.center.head<2>();
  for (const double reach : {0.3, 0.03}) // the second may leave a ridge that stopped the first
    axis =
        leastAt(volumeAbout, axis, Eigen::Vector2d::Constant(reach * circle.radius), 300, progress);
  return {axis, wallAbout(crown, axis, power, wallOf)};
}

EnvelopeParameter ofRadius(double radius) {
  return {.name = "radius", .label = Shown::tr("radius"), .value = radius};
}

void addSizes(Envelope& envelope, const std::vector<EnvelopeParameter>& radii, double height,
              const Eigen::Vector3d& base) {
  envelope.parameters.insert(envelope.parameters.end(), radii.begin(), radii.end());
  envelope.parameters.push_back({.name = "height", .label = Shown::tr("height"), .value = height});
  addPlace(envelope.parameters, "base", Shown::tr("base"), base);
  envelope.height = height;
  double widest = 0;
  for (const EnvelopeParameter& radius : radii)
    widest = std::max(widest, radius.value);
  envelope.diameter = 2 * widest;
}

Envelope frustumBody(double bottomRadius, double topRadius, double height,
                     const Eigen::Vector3d& base) {
  Envelope envelope = envelopeOf(meshOfTurned({{0, base.z()},
                                               {bottomRadius, base.z()},
                                               {topRadius, base.z() + height},
                                               {0, base.z() + height}},
                                              base.head<2>()));
  const double squares = bottomRadius * bottomRadius + topRadius * topRadius;
  envelope.volume = pi * height * (squares + bottomRadius * topRadius) / 3;
  envelope.area =
      pi * (squares + (bottomRadius + topRadius) * std::hypot(height, bottomRadius - topRadius));
  return envelope;
}

} // namespace

Envelope cylinderOf(double radius, double height, const Eigen::Vector3d& base) {
  Envelope envelope = frustumBody(radius, radius, height, base);
  addSizes(envelope, {ofRadius(radius)}, height, base);
  return envelope;
}

Envelope coneOf(double radius, double height, const Eigen::Vector3d& base) {
  Envelope envelope = frustumBody(radius, 0, height, base);
  addSizes(envelope, {ofRadius(radius)}, height, base);
  return envelope;
}

Envelope frustumOf(double bottomRadius, double topRadius, double height,
                   const Eigen::Vector3d& base) {
  Envelope envelope = frustumBody(bottomRadius, topRadius, height, base);
  addSizes(envelope,
           {{.name = "bottom_radius", .label = Shown::tr("bottom radius"), .value = bottomRadius},
            {.name = "top_radius", .label = Shown::tr("top radius"), .value = topRadius}},
           height, base);
  return envelope;
}

Envelope paraboloidOf(double radius, double height, const Eigen::Vector3d& base) {
  std::vector<Eigen::Vector2d> profile = {{0, base.z()}};
  for (int i = 0; i <= ringLevels; ++i) { // even in r, so that its top is round
    const double share = 1 - static_cast<double>(i) / ringLevels;
    profile.emplace_back(radius * share, base.z() + height * (1 - share * share));
  }
  Envelope envelope = envelopeOf(meshOfTurned(profile, base.head<2>()));
  envelope.volume = pi * radius * radius * height / 2;
  const double focal = radius * radius + 4 * height * height;
  envelope.area = pi * radius * radius + pi * radius / (6 * height * height) *
                                             (std::pow(focal, 1.5) - std::pow(radius, 3));
  addSizes(envelope, {ofRadius(radius)}, height, base);
  return envelope;
}

Envelope cylinderEnvelope(const Crown& crown, const Progress& progress) {
  const Ball3 circle = circleAbove(crown, progress);
  return cylinderOf(circle.radius, topOf(crown) - bottomOf(crown),
                    {circle.center.x(), circle.center.y(), bottomOf(crown)});
}

Envelope coneEnvelope(const Crown& crown, const Progress& progress) {
  const auto [axis, wall] = leastTurned(
      crown, 1, [](const auto& side) { return pointedWall(side, 1); }, progress);
  return coneOf(wall.foot, wall.foot / wall.slope, {axis.x(), axis.y(), bottomOf(crown)});
}

Envelope frustumEnvelope(const Crown& crown, const Progress& progress) {
  const double height = topOf(crown) - bottomOf(crown);
  const auto [axis, wall] = leastTurned(
      crown, 1, [&](const auto& side) { return frustumWall(side, height); }, progress);
  return frustumOf(wall.foot, std::max(0.0, wall.foot - wall.slope * height), height,
                   {axis.x(), axis.y(), bottomOf(crown)});
}

Envelope paraboloidEnvelope(const Crown& crown, const Progress& progress) {
  const auto [axis, wall] = leastTurned(
      crown, 2, [](const auto& side) { return pointedWall(side, 2); }, progress);
  return paraboloidOf(std::sqrt(wall.foot), wall.foot / wall.slope,
                      {axis.x(), axis.y(), bottomOf(crown)});
}

} // namespace espalier
