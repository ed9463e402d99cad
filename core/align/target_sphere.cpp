#include "core/align/target_sphere.h"

#include "core/base/coordinates.h"
#include "core/base/quantile.h"
#include "core/base/random.h"
#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace espalier {
namespace {

using Places = std::vector<Eigen::Vector3d>; // about the picked place

constexpr std::size_t fewest = 12; // points on a sphere
constexpr double shell = 1.5;      // in radii: what is within it should be the sphere

struct Sphere {
  Eigen::Vector3d center;
  double radius;

  [[nodiscard]] double off(const Eigen::Vector3d& place) const {
    return std::abs((place - center).norm() - radius);
  }
};

/// The spheres of a radius through three places: two, or none if they lie too far apart.
std::vector<Sphere> through(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c, double radius) {
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  if (!(squared > 1e-12 * ab.squaredNorm() * ac.squaredNorm())) return {};
  const Eigen::Vector3d toMiddle =
      (ab.squaredNorm() * ac.cross(normal) + ac.squaredNorm() * normal.cross(ab)) / (2 * squared);
  const double height = radius * radius - toMiddle.squaredNorm();
  if (!(height >= 0)) return {};
  const Eigen::Vector3d rise = normal / std::sqrt(squared) * std::sqrt(height);
  return {{a + toMiddle + rise, radius}, {a + toMiddle - rise, radius}};
}

/// The sphere through four places; none if they lie in a plane.
std::vector<Sphere> through(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  Eigen::Matrix3d sides;
  sides << (b - a).transpose(), (c - a).transpose(), (d - a).transpose();
  const double volume = sides.determinant();
  if (!(std::abs(volume) > 1e-9 * sides.row(0).norm() * sides.row(1).norm() * sides.row(2).norm()))
    return {};
  const Eigen::Vector3d toCenter =
      sides.partialPivLu().solve(Eigen::Vector3d(sides.rowwise().squaredNorm() / 2));
  return {{a + toCenter, toCenter.norm()}};
}

/// How badly a sphere explains the places in and about its shell: truncated squares of those on
/// it, less what as many that lie off it would cost. The least is the best.
double costOf(const Sphere& sphere, const Places& places) {
  const double most = std::pow(0.1 * sphere.radius, 2);
  double cost = 0;
  for (const Eigen::Vector3d& place : places) {
    const double distance = (place - sphere.center).norm();
    if (distance > shell * sphere.radius) continue;
    const double squared = std::pow(distance - sphere.radius, 2);
    cost += squared < most ? squared - most : most / 2;
  }
  return cost / most;
}

/// The best of spheres through places drawn by chance.
std::optional<Sphere> likeliest(const Places& all, const TargetSphereOptions& options, double reach,
                                const Progress& progress) {
  Places places; // enough to judge by, evenly
  const std::size_t stride = (all.size() + 999) / 1000;
  for (std::size_t i = 0; i < all.size(); i += stride)
    places.push_back(all[i]);
  Random random(1);
  std::optional<Sphere> best;
  double least = 0;
  constexpr int draws = 2000;
  for (int i = 0; i < draws; ++i) {
    if (i % 100 == 0) progress.update(static_cast<double>(i) / draws);
    const auto drawn = [&] { return places[random.below(places.size())]; };
    const Eigen::Vector3d a = drawn();
    const Eigen::Vector3d b = drawn();
    const Eigen::Vector3d c = drawn();
    const std::vector<Sphere> found =
        options.radius ? through(a, b, c, *options.radius) : through(a, b, c, drawn());
    for (const Sphere& sphere : found) {
      const bool isNear = sphere.center.norm() <= 2 * sphere.radius;
      if (!isNear || sphere.radius > reach / 2) continue;
      const double cost = costOf(sphere, places);
      if (cost >= least) continue;
      least = cost;
      best = sphere;
    }
  }
  return best;
}

Places on(const Sphere& sphere, const Places& places, double tolerance) {
  Places result;
  for (const Eigen::Vector3d& place : places)
    if (sphere.off(place) <= tolerance) result.push_back(place);
  return result;
}

/// One Gauss-Newton step to the least squares of the distances.
Sphere stepped(const Sphere& sphere, const Places& places, bool isRadiusFree) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Eigen::Vector3d& place : places) {
    const Eigen::Vector3d to = place - sphere.center;
    const double distance = to.norm();
    if (!(distance > 0)) continue;
    Eigen::Vector4d slope;
    slope << to / distance, isRadiusFree ? 1 : 0;
    normal += slope * slope.transpose();
    right += slope * (distance - sphere.radius);
  }
  if (!isRadiusFree) normal(3, 3) = 1;
  normal.diagonal().array() += 1e-12 * normal.trace();
  const Eigen::Vector4d step = normal.ldlt().solve(right);
  return {sphere.center + step.head<3>(), sphere.radius + step[3]};
}

Sphere refinedOn(Sphere sphere, const Places& places, bool isRadiusFree) {
  double tolerance = 0.1 * sphere.radius;
  for (int i = 0; i < 30; ++i) {
    const Places its = on(sphere, places, tolerance);
    if (its.size() < fewest) break;
    sphere = stepped(sphere, its, isRadiusFree);
    std::vector<double> distances;
    for (const Eigen::Vector3d& place : its)
      distances.push_back(sphere.off(place));
    const double usual = 1.4826 * *quantile(std::move(distances), 0.5);
    tolerance = std::clamp(3 * usual, 0.005 * sphere.radius, 0.1 * sphere.radius);
  }
  return sphere;
}

/// Why there is no sphere, of a radius that is given and of one that is not.
struct NoSphereTexts {
  const char* ofRadius;
  const char* ofAny;
};

constexpr NoSphereTexts oneNearTexts{
    Shown::tr("no sphere of radius %3 about %1: only 1 point is near: pick its middle, and check "
              "the radius"),
    Shown::tr("no sphere about %1: only 1 point is near: pick its middle, and check the radius")};
constexpr NoSphereTexts fewNearTexts{
    Shown::tr("no sphere of radius %3 about %1: only %2 points are near: pick its middle, and "
              "check the radius"),
    Shown::tr(
        "no sphere about %1: only %2 points are near: pick its middle, and check the radius")};
constexpr NoSphereTexts onNoneTexts{
    Shown::tr("no sphere of radius %3 about %1: the points there lie on none: pick its middle, and "
              "check the radius"),
    Shown::tr(
        "no sphere about %1: the points there lie on none: pick its middle, and check the radius")};
constexpr NoSphereTexts oneOnItTexts{
    Shown::tr("no sphere of radius %3 about %1: only 1 point lies on the likeliest: pick its "
              "middle, and check the radius"),
    Shown::tr("no sphere about %1: only 1 point lies on the likeliest: pick its middle, and check "
              "the radius")};
constexpr NoSphereTexts fewOnItTexts{
    Shown::tr("no sphere of radius %3 about %1: only %2 points lie on the likeliest: pick its "
              "middle, and check the radius"),
    Shown::tr("no sphere about %1: only %2 points lie on the likeliest: pick its middle, and check "
              "the radius")};
constexpr NoSphereTexts littleSeenTexts{
    Shown::tr("no sphere of radius %3 about %1: too little of it is seen: pick its middle, and "
              "check the radius"),
    Shown::tr(
        "no sphere about %1: too little of it is seen: pick its middle, and check the radius")};
constexpr NoSphereTexts mostOffTexts{
    Shown::tr("no sphere of radius %3 about %1: over half of the points about it lie off it: pick "
              "its middle, and check the radius"),
    Shown::tr("no sphere about %1: over half of the points about it lie off it: pick its middle, "
              "and check the radius")};

/// @param points  of which there are too few
[[noreturn]] void refuseSphere(const NoSphereTexts& why, std::size_t points,
                               const Eigen::Vector3d& place, const TargetSphereOptions& options) {
  std::ostringstream where;
  where << place.x() << ", " << place.y() << ", " << place.z();
  throw ShownError({options.radius ? why.ofRadius : why.ofAny,
                    {where.str(), std::to_string(points),
                     options.radius ? plainDecimal(*options.radius) : std::string()}});
}

/// Why it is no sphere; null if it is one.
const NoSphereTexts* doubtOf(const Sphere& sphere, const Places& its, const Places& places) {
  if (its.size() < fewest) return its.size() == 1 ? &oneOnItTexts : &fewOnItTexts;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : its)
    mean += (place - sphere.center).normalized() / static_cast<double>(its.size());
  if (mean.norm() > 0.9) return &littleSeenTexts; // a cap of 37 degrees about a side
  const auto about = std::ranges::count_if(places, [&](const Eigen::Vector3d& place) {
    return (place - sphere.center).norm() <= shell * sphere.radius;
  });
  if (2 * std::ssize(its) < about) return &mostOffTexts;
  return nullptr;
}

} // namespace

TargetSphere targetSphere(const PointCloud& cloud, const SpatialIndex& index,
                          const Eigen::Vector3d& place, const TargetSphereOptions& options,
                          const Progress& progress) {
  const auto isLength = [](const std::optional<double>& length) {
    return !length || (*length > 0 && *length <= largestCoordinate);
  };
  if (!isInRange(place) || !isLength(options.radius) || !isLength(options.reach))
    throw ShownError(
        {Shown::tr("a target sphere: expected a finite place, and a radius and reach over 0")});
  const double reach = options.reach    ? *options.reach
                       : options.radius ? 3 * *options.radius
                                        : 40 * pointSpacing(cloud.positions(), index);
  const Eigen::Vector3d about = place - cloud.origin();
  std::vector<Eigen::Index> found;
  for (const Neighbor& one : index.within(about.cast<float>(), static_cast<float>(reach)))
    found.push_back(one.index);
  std::ranges::sort(found); // the order of a search means nothing
  Places places;
  for (const Eigen::Index i : found)
    places.push_back(cloud.positions().col(i).cast<double>() - about);

  if (places.size() < fewest)
    refuseSphere(places.size() == 1 ? oneNearTexts : fewNearTexts, places.size(), place, options);
  const double most = options.radius ? 2 * *options.radius : reach;
  const std::optional<Sphere> best = likeliest(places, options, most, progress);
  if (!best) refuseSphere(onNoneTexts, places.size(), place, options);
  const Sphere sphere = refinedOn(*best, places, !options.radius);
  const Places its = on(sphere, places, 0.1 * sphere.radius);
  if (const NoSphereTexts* doubt = doubtOf(sphere, its, places))
    refuseSphere(*doubt, its.size(), place, options);
  double squares = 0;
  for (const Eigen::Vector3d& each : its)
    squares += std::pow(sphere.off(each), 2);
  return {.center = place + sphere.center,
          .radius = sphere.radius,
          .residual = std::sqrt(squares / static_cast<double>(its.size())),
          .points = std::ssize(its)};
}

} // namespace espalier
