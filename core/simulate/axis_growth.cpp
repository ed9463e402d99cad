#include "core/simulate/axis_growth.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr double reach = 0.04;       // how far an axis feels other wood
constexpr double shortest = 0.012;   // branch that is worth its node
constexpr double minimalGap = 0.002; // between the surfaces of two axes

/// Relative length of a branch at share u of the bearing part, at most 1.
double lengthShape(const OrderHabit& habit, double u) {
  const double a = habit.acrotony;
  const double b = habit.basitony;
  const double top = a + b > 0 ? a / (a + b) : 0; // where the product is largest
  const double most = std::pow(top, a) * std::pow(1 - top, b);
  return std::pow(u, a) * std::pow(1 - u, b) / most;
}

Sprout sproutAt(const OrderHabit& habit, double place, double length, Random& random) {
  const double share = place / length;
  const double u = std::clamp((share - habit.bare) / (1 - habit.bare), 0.02, 0.98);
  Sprout sprout{.place = place};
  sprout.angle = habit.angle + (habit.tipAngle - habit.angle) * share + 0.12 * random.normal();
  sprout.length = habit.ratio * length * lengthShape(habit, u) * std::exp(0.3 * random.normal());
  if (random.uniform() < habit.shortShoots) sprout.length *= random.uniform(0.1, 0.4);
  if (share > 0.25 && share < 0.85 && random.uniform() < habit.fork) {
    sprout.rivals = true;
    sprout.angle = random.uniform(0.45, 0.7);
    sprout.length = (length - place) * random.uniform(0.75, 1);
  }
  sprout.length = std::min(sprout.length, 0.95 * length);
  return sprout;
}

/// What other wood does to an axis that passes by.
struct Crowding {
  Vector3d push = Vector3d::Zero();
  bool blocked = false;
};

Crowding crowdingAt(const Vector3d& place, const Vector3d& direction, double radius, double feels,
                    const Occupancy& wood) {
  Crowding crowding;
  wood.visitNear(place, [&](const Occupancy::Ball& ball) {
    const Vector3d away = place - ball.center;
    if (away.dot(direction) >= 0) return; // what lies behind is passed
    const double gap = away.norm() - ball.radius - radius;
    if (gap < minimalGap) crowding.blocked = true;
    if (gap < feels) crowding.push += away.normalized() * (1 - gap / feels);
  });
  return crowding;
}

/// The course so far, and what will turn it next.
class Tip {
public:
  Tip(const AxisSeed& seed, double stray, Random& random)
      : seed_(seed), random_(random), step_(seed.length / std::ceil(seed.length / seed.spacing)),
        direction_(seed.direction.normalized()), side_(direction_.unitOrthogonal()) {
    // Curvature follows a random walk that is pulled back to 0 over a quarter of the axis.
    memory_ = std::exp(-4 * step_ / seed.length);
    bend_ = stray / (0.7 * seed.length);
    curvature_ = across(bend_ * gaussian());
    course_.positions = {seed.base};
    course_.directions = {direction_};
    course_.sides = {side_};
  }

  /// Turns the tip; where it gives way to a rival, to the side opposite of it.
  void turn(const OrderHabit& habit, const Vector3d& push) {
    const double share = course_.length / seed_.length;
    curvature_ =
        across(memory_ * curvature_ + std::sqrt(1 - memory_ * memory_) * bend_ * gaussian());
    const double rise = habit.rise + 2 * habit.tipRise * share;
    head(direction_ + step_ * curvature_ + step_ / seed_.length * rise * Vector3d::UnitZ() +
         across(push));
  }
  void giveWay(const Sprout& rival) {
    const Vector3d other = direction_.cross(side_);
    head(direction_ - 0.35 * (std::cos(rival.azimuth) * side_ + std::sin(rival.azimuth) * other));
  }

  void advance() {
    course_.positions.push_back(next());
    course_.directions.push_back(direction_);
    course_.sides.push_back(side_);
    course_.length += step_;
  }
  [[nodiscard]] Vector3d next() const { return course_.positions.back() + step_ * direction_; }
  [[nodiscard]] const Vector3d& direction() const { return direction_; }
  [[nodiscard]] const Course& course() const { return course_; }
  [[nodiscard]] double step() const { return step_; }

private:
  [[nodiscard]] Vector3d gaussian() {
    return {random_.normal(), random_.normal(), random_.normal()};
  }
  [[nodiscard]] Vector3d across(const Vector3d& v) const {
    return v - v.dot(direction_) * direction_;
  }
  void head(const Vector3d& direction) {
    direction_ = direction.normalized();
    side_ = across(side_).normalized();
  }

  const AxisSeed& seed_;
  Random& random_;
  double step_;
  Vector3d direction_;
  Vector3d side_;
  Vector3d curvature_;
  double memory_ = 0;
  double bend_ = 0;
  Course course_;
};

} // namespace

Vector3d Course::branchDirection(std::size_t i, const Sprout& sprout, double flatness) const {
  const Vector3d& along = directions[i];
  const Vector3d other = along.cross(sides[i]);
  Vector3d side = std::cos(sprout.azimuth) * sides[i] + std::sin(sprout.azimuth) * other;
  Vector3d up = Vector3d::UnitZ() - along.z() * along;
  if (up.norm() > 0.2) { // upright axes have no level plane of their own
    up.normalize();
    side = (side - flatness * side.dot(up) * up + 1e-9 * along.cross(up)).normalized();
  }
  return std::cos(sprout.angle) * along + std::sin(sprout.angle) * side;
}

std::vector<Sprout> sproutsOf(const OrderHabit& habit, double length, double density,
                              Random& random) {
  std::vector<Sprout> sprouts;
  const double internode = habit.internode / density;
  double azimuth = random.uniform(0, 2 * std::numbers::pi);
  for (double place = habit.bare * length + internode * random.uniform(0, 1); place < 0.97 * length;
       place += internode * random.uniform(0.75, 1.25)) {
    for (int bud = 0; bud < habit.budsPerNode; ++bud) {
      Sprout sprout = sproutAt(habit, place, length, random);
      sprout.azimuth =
          azimuth + 2 * std::numbers::pi * bud / habit.budsPerNode + 0.15 * random.normal();
      if (sprout.length > shortest) sprouts.push_back(sprout);
    }
    azimuth += habit.divergence;
  }
  return sprouts;
}

double guessedRadius(const AxisSeed& seed, double place) {
  const double share = std::clamp(1 - place / seed.length, 0.0, 1.0);
  return seed.apexRadius + (seed.baseRadius - seed.apexRadius) * std::pow(share, 1.1);
}

Course grow(const AxisSeed& seed, const OrderHabit& habit, double wander,
            const std::vector<Sprout>& sprouts, const Occupancy& wood, Random& random) {
  Tip tip(seed, wander * habit.wander, random);
  auto rival = sprouts.begin();
  const double free = seed.clearance + 0.15 * seed.length; // among those that start beside it
  while (tip.course().length < seed.length - 0.5 * tip.step()) {
    const double place = tip.course().length;
    for (; rival != sprouts.end() && rival->place <= place; ++rival)
      if (rival->rivals) tip.giveWay(*rival);
    const double feels = std::min(reach, 0.3 * seed.length);
    const Crowding crowding =
        crowdingAt(tip.next(), tip.direction(), guessedRadius(seed, place), feels, wood);
    if (crowding.blocked && place > std::min(free, 0.3 * seed.length)) break;
    Vector3d push = 0.6 * tip.step() / feels * std::min(1.0, place / (2 * free)) * crowding.push;
    if (tip.next().z() < 0.03 && tip.direction().z() < 0.3) push.z() += 6 * tip.step();
    tip.turn(habit, push);
    if (tip.next().z() < 0) break; // the ground
    tip.advance();
  }
  return tip.course();
}

} // namespace espalier
