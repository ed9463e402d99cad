#include "core/surface/envelopes/skinned_hull.h"

#include "core/base/paced_check.h"
#include "core/base/plane_hull.h"
#include "core/base/shown.h"
#include "core/surface/envelopes/outline.h"
#include "core/surface/envelopes/rings.h"

#include <limits>
#include <numbers>

namespace espalier {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;

using Profile = SkinnedHull::Profile;
static_assert(skinnedLevels == ringLevels - 1);

double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Where an upright line goes through the convex hull: from, to.
std::pair<double, double> through(const ConvexHull& hull, const Eigen::Vector2d& at) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::array<int, 3>& triangle : hull.triangles) {
    const auto corner = [&](std::size_t i) { return hull.corners.col(triangle[i % 3]); };
    std::array<double, 3> sides{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sides[i] = turnOf(corner(i + 1).head<2>() - at, corner(i + 2).head<2>() - at);
      sum += sides[i];
    }
    if (sum == 0) continue;
    double z = 0;
    bool isOver = true;
    for (std::size_t i = 0; i < 3; ++i) {
      isOver = isOver && sides[i] / sum >= -1e-9;
      z += sides[i] / sum * corner(i).z();
    }
    if (!isOver) continue;
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return {low, high};
}

/// How many sectors there are from the middle of the first to an azimuth: in [0, count).
double sectorsTo(double azimuth, double first, std::size_t count) {
  const double turns = (azimuth - first) / fullTurn;
  const double within = (turns - std::floor(turns)) * static_cast<double>(count);
  return within < static_cast<double>(count) ? within : 0;
}

/// What the sectors around the axis hold.
class Sectors {
public:
  Sectors(const Crown& crown, int count, const Progress& progress)
      : outline_(outlineOf(crown)), reach_(outline_, outline_.middle),
        axis_(through(crown.hull, outline_.middle)),
        first_(std::atan2(outline_.along.y(), outline_.along.x())),
        places_(static_cast<std::size_t>(count)) {
    PacedCheck check(progress);
    for (const auto& point : crown.points.colwise()) {
      check.after(100);
      const Eigen::Vector2d from = point.head<2>() - outline_.middle;
      const double azimuth = std::atan2(from.y(), from.x());
      places_[nearest(azimuth)].emplace_back(from.norm() / reach_.at(azimuth), point.z());
    }
  }

  /// What is drawn over profiles of these, none of which is there yet.
  [[nodiscard]] SkinnedHull bare() const {
    return {.middle = outline_.middle,
            .axis = axis_,
            .azimuth = first_,
            .outline = outline_.corners,
            .profiles = {}};
  }
  [[nodiscard]] std::size_t count() const { return places_.size(); }

  /// Of a sector, with as many beside it as it takes to have some points.
  [[nodiscard]] Profile profile(std::size_t sector) const {
    Profile places = {{0, axis_.first}, {0, axis_.second}};
    for (std::size_t beside = 0; places.size() < 5 && beside <= count() / 2; ++beside) {
      add(places, (sector + beside) % count());
      if (beside > 0) add(places, (sector + count() - beside) % count());
    }
    return planeHull(places);
  }

private:
  [[nodiscard]] std::size_t nearest(double azimuth) const {
    return static_cast<std::size_t>(std::lround(sectorsTo(azimuth, first_, count()))) % count();
  }
  void add(Profile& places, std::size_t sector) const {
    places.insert(places.end(), places_[sector].begin(), places_[sector].end());
  }

  Outline outline_;
  OutlineReach reach_;
  std::pair<double, double> axis_;
  double first_; // azimuth of the middle of the first sector
  std::vector<Profile> places_;
};

/// Where rays leave a profile that start halfway up the axis, from straight down to straight up.
Profile sampled(const Profile& profile, const std::pair<double, double>& axis) {
  const Eigen::Vector2d start(0, (axis.first + axis.second) / 2);
  const double half = (axis.second - axis.first) / 2;
  Profile samples;
  for (int level = 1; level < ringLevels; ++level) {
    const double angle = std::numbers::pi * (static_cast<double>(level) / ringLevels - 0.5);
    const Eigen::Vector2d along(std::cos(angle), half * std::sin(angle));
    Eigen::Vector2d farthest = start;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const Eigen::Vector2d a = profile[i] - start;
      const Eigen::Vector2d b = profile[(i + 1) % profile.size()] - start;
      const double left = turnOf(along, a);
      const double right = turnOf(along, b);
      if (left > 0 || right < 0 || left == right) continue;
      const Eigen::Vector2d at = a + (b - a) * (left / (left - right));
      if (at.dot(along) > (farthest - start).dot(along)) farthest = start + at;
    }
    samples.push_back(farthest);
  }
  return samples;
}

/// Azimuths that the surface is drawn at: even, and where the outline has corners.
std::vector<double> drawnAzimuths(const OutlineReach& reach, double first) {
  std::vector<double> all = reach.cornerAzimuths();
  for (int i = 0; i < ringCorners; ++i)
    all.push_back(std::remainder(first + fullTurn * i / ringCorners, fullTurn));
  std::ranges::sort(all);
  std::vector<double> apart;
  for (const double azimuth : all)
    if (apart.empty() || azimuth - apart.back() > 1e-3) apart.push_back(azimuth);
  if (apart.front() + fullTurn - apart.back() < 1e-3) apart.pop_back();
  return apart;
}

OutlineReach reachOf(const SkinnedHull& hull) {
  return {{.corners = hull.outline}, hull.middle};
}

Eigen::Vector3d onAxis(const SkinnedHull& hull, double z) {
  return {hull.middle.x(), hull.middle.y(), z};
}

Eigen::Vector3d beside(const SkinnedHull& hull, double azimuth, double out, double z) {
  return onAxis(hull, z) + out * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0);
}

SurfaceMesh meshOf(const SkinnedHull& hull) {
  const OutlineReach outline = reachOf(hull);
  const std::size_t count = hull.profiles.size();
  std::vector<Ring> rings(hull.profiles.front().size());
  for (const double azimuth : drawnAzimuths(outline, hull.azimuth)) {
    const double at = sectorsTo(azimuth, hull.azimuth, count);
    const auto before = static_cast<std::size_t>(at);
    const double share = at - std::floor(at);
    const double reach = outline.at(azimuth);
    for (std::size_t level = 0; level < rings.size(); ++level) {
      const Eigen::Vector2d place = (1 - share) * hull.profiles[before][level] +
                                    share * hull.profiles[(before + 1) % count][level];
      rings[level].push_back(beside(hull, azimuth, place.x() * reach, place.y()));
    }
  }
  return meshOfRings(onAxis(hull, hull.axis.first), rings, onAxis(hull, hull.axis.second));
}

} // namespace

double azimuthOf(const SkinnedHull& hull, std::size_t profile) {
  const auto share = static_cast<double>(profile) / static_cast<double>(hull.profiles.size());
  return hull.azimuth + fullTurn * share;
}

double reachTo(const SkinnedHull& hull, std::size_t profile) {
  return reachOf(hull).at(azimuthOf(hull, profile));
}

Envelope envelopeOf(const SkinnedHull& hull) {
  Envelope envelope = envelopeOf(meshOf(hull));
  using Kind = EnvelopeParameter::Kind;
  const std::size_t count = hull.profiles.size();
  envelope.parameters = {
      {"profiles", Shown::tr("profiles"), Kind::number, static_cast<double>(count)},
      {"azimuth", Shown::tr("azimuth of the first profile"), Kind::angle, hull.azimuth}};
  addPlace(envelope.parameters, "axis_bottom", Shown::tr("lower end of the axis"),
           onAxis(hull, hull.axis.first));
  addPlace(envelope.parameters, "axis_top", Shown::tr("upper end of the axis"),
           onAxis(hull, hull.axis.second));
  envelope.profiles.resize(1 + count); // the first is the outline
  for (const Eigen::Vector2d& corner : hull.outline)
    envelope.profiles[0].emplace_back(corner.x(), corner.y(), hull.axis.first);
  for (std::size_t i = 0; i < count; ++i) {
    const double reach = reachTo(hull, i);
    for (const Eigen::Vector2d& place : hull.profiles[i])
      envelope.profiles[1 + i].push_back(
          beside(hull, azimuthOf(hull, i), place.x() * reach, place.y()));
  }
  return envelope;
}

SkinnedHull skinnedHullOf(const Envelope& envelope) {
  const Eigen::Vector3d bottom = placeOf(envelope.parameters, "axis_bottom");
  SkinnedHull hull{.middle = bottom.head<2>(),
                   .axis = {bottom.z(), placeOf(envelope.parameters, "axis_top").z()},
                   .azimuth = valueOf(envelope.parameters, "azimuth")};
  for (const Eigen::Vector3d& corner : envelope.profiles.front())
    hull.outline.emplace_back(corner.head<2>());
  hull.profiles.resize(envelope.profiles.size() - 1);
  for (std::size_t i = 0; i < hull.profiles.size(); ++i) {
    const double reach = reachTo(hull, i);
    for (const Eigen::Vector3d& place : envelope.profiles[1 + i])
      hull.profiles[i].emplace_back((place.head<2>() - hull.middle).norm() / reach, place.z());
  }
  return hull;
}

Envelope skinnedHull(const Crown& crown, const SkinnedHullOptions& options,
                     const Progress& progress) {
  const Sectors sectors(crown, options.profiles, progress);
  SkinnedHull hull = sectors.bare();
  for (std::size_t i = 0; i < sectors.count(); ++i) {
    progress.update(0.5 + 0.3 * static_cast<double>(i) / static_cast<double>(sectors.count()));
    hull.profiles.push_back(sampled(sectors.profile(i), hull.axis));
  }
  Envelope envelope = envelopeOf(hull);
  envelope.parameters.push_back({"inside", Shown::tr("share of the points inside"),
                                 EnvelopeParameter::Kind::number,
                                 shareInside(envelope.mesh, crown.points, progress.part(0.8, 1))});
  return envelope;
}

} // namespace espalier
