#include "core/simulate/foliage.h"

#include "core/base/error.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace espalier {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double degrees = pi / 180;
constexpr double petioleShare = 0.7; // of the radius of the thinnest wood

/// Wood that may bear organs.
struct Stretch : Frustum {
  double lengthToApex = 0; // [L], from its upper end to the farthest apex
};

void check(const OrganHabit& habit, const char* what) {
  const auto require = [&](bool holds, const char* expected) {
    if (!holds) throw Error(std::string(what) + ": expected " + expected);
  };
  require(habit.spacing >= 0 && habit.spacing <= 1e300, "a spacing of 0 or more");
  require(habit.length > 0 && habit.length <= 1, "a length above 0, to 1 extent of the plant");
  require(habit.width >= 0 && habit.width <= 1, "a width of 0 to 1 extent of the plant");
  require(habit.angle >= 0 && habit.angle <= pi, "an angle of 0 to 180 degrees");
  require(habit.reach >= 0 && habit.reach <= 1e300, "a reach of 0 or more");
}

void checkLeaves(const Foliage& foliage) {
  if (!(foliage.petiole >= 0 && foliage.petiole <= 10))
    throw Error("petioles: expected a length of 0 to 10 blades");
  if (foliage.leaflets < 0 || foliage.leaflets > 100)
    throw Error("leaflets: expected 0 to 100 pairs");
  if (!(foliage.droop >= 0 && foliage.droop <= 4))
    throw Error("leaves: expected a droop of 0 to 4");
}

/// By id [L].
std::vector<double> lengthsToApex(const Skeleton& plant, const std::vector<NodeId>& ids) {
  std::vector<double> lengths(plant.idEnd(), 0);
  for (std::size_t i = ids.size(); i-- > 0;) { // children first
    const NodeId id = ids[i];
    const auto parent = plant[id].parent;
    if (!parent) continue;
    const double above =
        lengths[indexOf(id)] + (plant[id].position - plant[*parent].position).norm();
    lengths[indexOf(*parent)] = std::max(lengths[indexOf(*parent)], above);
  }
  return lengths;
}

std::vector<Stretch> stretchesOf(const Skeleton& plant) {
  const std::vector<NodeId> ids = plant.ids();
  const std::vector<double> lengths = lengthsToApex(plant, ids);
  std::vector<Stretch> stretches;
  for (const EdgeSolid& piece : woodOf(plant))
    stretches.push_back({static_cast<const Frustum&>(piece), lengths[indexOf(*piece.node)]});
  return stretches;
}

/// A place on the surface of wood from which an organ grows.
struct Place {
  Vector3d center;    // [L], on the axis of the wood
  Vector3d direction; // unit, of the organ
  Vector3d outward;   // unit, across the wood
  double radius = 0;  // [L], of the wood
  double length = 0;  // [L], of the organ
};

/// Strews organs over stretches, and counts them.
class Strewing {
public:
  Strewing(double extent, std::uint64_t seed) : extent_(extent), random_(seed) {}

  /// Calls grow(place) for each organ. They are as likely everywhere, whatever the pieces.
  template <class Grow>
  void over(const std::vector<Stretch>& stretches, const OrganHabit& habit, const Grow& grow) {
    if (!(habit.spacing > 0)) return;
    requireFew(count_ + expectedOn(stretches, habit) / 1.01); // at once, not after 10 million
    for (const Stretch& stretch : stretches) {
      const Vector3d axis = stretch.to - stretch.from;
      const double length = axis.norm();
      if (!(length > 0)) continue;
      for (double at = gap(habit); at < length; at += gap(habit)) {
        if (stretch.lengthToApex + length - at > habit.reach * extent_) continue;
        requireFew(++count_);
        grow(placeAt(stretch, axis / length, at / length, habit));
      }
    }
  }

  /// A unit vector across `direction`.
  [[nodiscard]] Vector3d across(const Vector3d& direction) {
    const double azimuth = random_.uniform(0, 2 * pi);
    const Vector3d side = direction.unitOrthogonal();
    return std::cos(azimuth) * side + std::sin(azimuth) * direction.cross(side);
  }

private:
  static constexpr int mostOrgans = 10'000'000;

  static void requireFew(double organs) {
    if (organs > mostOrgans)
      throw Error("foliage: over 10 million organs; ask for a greater spacing");
  }

  /// How many organs there will be in the mean.
  [[nodiscard]] double expectedOn(const std::vector<Stretch>& stretches,
                                  const OrganHabit& habit) const {
    double length = 0; // within reach of an apex
    for (const Stretch& stretch : stretches)
      length += std::clamp(habit.reach * extent_ - stretch.lengthToApex, 0.0, stretch.length());
    return length / (habit.spacing * extent_);
  }

  [[nodiscard]] double gap(const OrganHabit& habit) { // of a Poisson process
    return -habit.spacing * extent_ * std::log(1 - random_.uniform());
  }

  [[nodiscard]] Place placeAt(const Stretch& stretch, const Vector3d& axis, double share,
                              const OrganHabit& habit) {
    const Vector3d outward = across(axis);
    const double angle = std::clamp(habit.angle + 0.15 * random_.normal(), 0.0, pi);
    return {.center = stretch.from + share * (stretch.to - stretch.from),
            .direction = std::cos(angle) * axis + std::sin(angle) * outward,
            .outward = outward,
            .radius = (1 - share) * stretch.fromRadius + share * stretch.toRadius,
            .length = habit.length * extent_ * random_.uniform(0.7, 1.3)};
  }

  double extent_;
  Random random_;
  int count_ = 0;
};

/// A leaf as it grows out of wood.
struct Leaf {
  Vector3d base;      // [L]
  Vector3d direction; // unit
  Vector3d side;      // unit, across
  double length = 0;  // [L], of its blade
  double half = 0;    // [L], of its width
};

/// A blade of one flat piece, or of pieces that bend to the ground.
void addBlade(Organs& organs, const Leaf& leaf, double droop, Organ organ) {
  if (!(droop > 0)) {
    organs.blades.push_back({.base = leaf.base,
                             .along = leaf.length * leaf.direction,
                             .half = leaf.half * leaf.side,
                             .organ = organ});
    return;
  }
  constexpr int pieces = 8;
  const Vector3d side = leaf.direction.cross(Vector3d::UnitZ()).norm() > 1e-6
                            ? Vector3d(leaf.direction.cross(Vector3d::UnitZ()).normalized())
                            : leaf.side;
  Vector3d base = leaf.base;
  for (int i = 0; i < pieces; ++i) {
    const double turned =
        std::min(droop * (i + 0.5) / pieces, std::acos(std::clamp(-leaf.direction.z(), -1.0, 1.0)));
    const Vector3d along =
        leaf.length / pieces * (Eigen::AngleAxisd(-turned, side) * leaf.direction);
    organs.blades.push_back({.base = base,
                             .along = along,
                             .half = leaf.half * side,
                             .atBase = i == 0 ? 0.5 : 1,
                             .atTip = i + 1 == pieces ? 0.0 : 1.0,
                             .organ = organ});
    base += along;
  }
}

/// Pairs of leaflets along a petiole, and one at its end.
void addLeaflets(Organs& organs, const Leaf& leaf, double stalk, const Foliage& foliage) {
  const Vector3d normal = leaf.direction.cross(leaf.side);
  for (int i = 1; i <= foliage.leaflets; ++i)
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d direction = (0.5 * leaf.direction + sign * leaf.side).normalized();
      addBlade(organs,
               {.base = leaf.base - stalk * (1 - static_cast<double>(i) / (foliage.leaflets + 1)) *
                                        leaf.direction,
                .direction = direction,
                .side = normal.cross(direction),
                .length = 0.7 * leaf.length,
                .half = 0.7 * leaf.half},
               foliage.droop, Organ::blade);
    }
}

double thinnestOf(const std::vector<Stretch>& wood) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const Stretch& stretch : wood)
    thinnest = std::min(thinnest, stretch.toRadius);
  return thinnest;
}

} // namespace

Foliage foliageOf(Architecture architecture, double density) {
  if (!(density > 0)) return {};
  const auto every = [density](double spacing) { return spacing / density; };
  switch (architecture) {
  case Architecture::conifer: // needles of 45 mm on a pine of 4 m, kept for three years
    return {.shortShoots = {.spacing = every(0.03), .length = 0.005, .angle = 55 * degrees},
            .blades = {.spacing = every(0.0015),
                       .length = 0.011,
                       .width = 0.0005,
                       .angle = 45 * degrees,
                       .reach = 0.12},
            .areNeedles = true};
  case Architecture::broadleaf:
  case Architecture::shrub:
    return {.shortShoots = {.spacing = every(0.015),
                            .length = 0.007,
                            .angle = 60 * degrees,
                            .reach = 0.25},
            .blades = {.spacing = every(0.025),
                       .length = 0.012,
                       .width = 0.006,
                       .angle = 55 * degrees,
                       .reach = 0.12}};
  case Architecture::herb:
    return {.blades = {.spacing = every(0.04),
                       .length = 0.03,
                       .width = 0.01,
                       .angle = 50 * degrees,
                       .reach = 0.5}};
  }
  return {};
}

std::optional<WoodHit> hit(const Blade& blade, const Ray& ray) {
  const Vector3d normal = blade.along.cross(blade.half).normalized();
  const double facing = ray.direction.dot(normal);
  if (!(std::abs(facing) > 1e-12)) return std::nullopt; // on edge, or of no width
  const double range = (blade.base - ray.origin).dot(normal) / facing;
  if (!(range > 0)) return std::nullopt;
  const Vector3d place = ray.origin + range * ray.direction - blade.base;
  const double along = place.dot(blade.along) / blade.along.squaredNorm();
  const double across = std::abs(place.dot(blade.half)) / blade.half.squaredNorm();
  if (along < 0 || along > 1) return std::nullopt;
  const double end = along < 0.5 ? blade.atBase : blade.atTip;
  if (across > 1 - (1 - end) * std::abs(2 * along - 1)) return std::nullopt;
  return WoodHit{range, facing < 0 ? normal : Vector3d(-normal), {}, blade.organ};
}

Eigen::AlignedBox3d boundsOf(const Blade& blade) {
  Eigen::AlignedBox3d box(blade.base);
  const Vector3d middle = blade.base + 0.5 * blade.along;
  box.extend(blade.base + blade.along);
  box.extend(middle + blade.half);
  box.extend(middle - blade.half);
  for (const double sign : {-1.0, 1.0}) {
    box.extend(blade.base + sign * blade.atBase * blade.half);
    box.extend(blade.base + blade.along + sign * blade.atTip * blade.half);
  }
  return box;
}

Organs organsOf(const Skeleton& plant, const Foliage& foliage, double extent, std::uint64_t seed) {
  check(foliage.shortShoots, "short shoots");
  check(foliage.blades, "needles and leaves");
  checkLeaves(foliage);
  std::vector<Stretch> wood = stretchesOf(plant);
  const double thinnest = thinnestOf(wood);
  Strewing strewing(extent, seed);
  Organs organs;
  strewing.over(wood, foliage.shortShoots, [&](const Place& place) {
    const Vector3d tip = place.center + (place.radius + place.length) * place.direction;
    organs.shortShoots.push_back({{place.center, tip, thinnest, thinnest}, {}, Organ::wood});
  });
  for (const EdgeSolid& shoot : organs.shortShoots)
    wood.push_back({static_cast<const Frustum&>(shoot), 0});
  strewing.over(wood, foliage.blades, [&](const Place& place) {
    Leaf leaf{.base = place.center + place.radius * place.outward,
              .direction = place.direction,
              .side = strewing.across(place.direction),
              .length = place.length,
              .half = 0.5 * foliage.blades.width * extent};
    const double stalk = foliage.petiole * place.length;
    if (stalk > 0) {
      const Vector3d end = leaf.base + stalk * leaf.direction;
      const double radius = petioleShare * thinnest;
      organs.petioles.push_back({{leaf.base, end, radius, radius}, {}, Organ::petiole});
      leaf.base = end;
      addLeaflets(organs, leaf, stalk, foliage);
    }
    addBlade(organs, leaf, foliage.droop, foliage.areNeedles ? Organ::needle : Organ::blade);
  });
  return organs;
}

} // namespace espalier
