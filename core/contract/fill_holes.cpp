#include "core/contract/fill_holes.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace espalier {
namespace {

// Radii of circles that are holes [spacings]: points that lie by chance leave greater gaps than
// those of a grid, so only a hole that is none of these is filled, and then more tightly.
constexpr double leastHole = 3;
constexpr double leastLeft = 1.5;

/// A place in the tangent plane of a point, about that point.
using Place = Eigen::Vector2d;

/// The middle of an empty circle that points surround.
struct Hole {
  Eigen::Vector3d middle;
  double radius = 0; // [L]

  /// Wide ones first, then by place: the same whatever the order of points.
  [[nodiscard]] auto rank() const {
    return std::tuple(-radius, middle.x(), middle.y(), middle.z());
  }
};

/// A corner of a Voronoi cell, and the two neighbors that the cell shares it with.
struct Corner {
  Place place;
  int before = -1; // the neighbor across the side that ends here; -1: the frame
  int after = -1;  // across the side that begins here
};

/// The Voronoi cell of 0 in a plane.
class Cell {
public:
  /// As large as a frame of this half width lets it be.
  explicit Cell(double frame)
      : corners_{{{-frame, -frame}}, {{frame, -frame}}, {{frame, frame}}, {{-frame, frame}}} {}

  /// Takes away what is nearer to `site`.
  void cut(const Place& site, int name) {
    const double half = site.squaredNorm() / 2;
    const auto over = [&](const Corner& corner) { return corner.place.dot(site) - half; };
    std::vector<Corner> kept;
    kept.reserve(corners_.size() + 1);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& from = corners_[i];
      const Corner& to = corners_[(i + 1) % corners_.size()];
      const double a = over(from);
      const double b = over(to);
      if (a <= 0) kept.push_back(from);
      if ((a <= 0) == (b <= 0)) continue;
      const Place crossed = from.place + a / (a - b) * (to.place - from.place);
      if (a <= 0)
        kept.push_back({crossed, from.after, name});
      else
        kept.push_back({crossed, name, from.after});
    }
    corners_ = std::move(kept);
  }

  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }

  /// How far its farthest corner is.
  [[nodiscard]] double reach() const {
    double farthest = 0;
    for (const Corner& corner : corners_)
      farthest = std::max(farthest, corner.place.norm());
    return farthest;
  }

private:
  std::vector<Corner> corners_; // counterclockwise
};

/// Whether the middle of the circle through 0, a and b lies between them, or on a side.
bool surround(const Place& a, const Place& b) {
  constexpr double right = -0.05; // cosine of an angle that is right but for rounding and noise
  const auto cosine = [](const Place& u, const Place& v) {
    return u.dot(v) / std::max(u.norm() * v.norm(), std::numeric_limits<double>::min());
  };
  return cosine(a, b) > right && cosine(-a, b - a) > right && cosine(-b, a - b) > right;
}

/// Looks for holes in one set of points.
class HoleSearch {
public:
  /// @param least  radius of a circle that is a hole [L]
  HoleSearch(const Eigen::Matrix3Xf& points, LocalShape shape, const HoleOptions& options,
             double least, const Progress& progress)
      : points_(points), options_(options), least_(least), index_(points, progress),
        surface_(points, index_, shape) {}

  /// Those that touch a point.
  [[nodiscard]] std::vector<Hole> at(Eigen::Index point) const {
    const Eigen::Vector3d own = points_.col(point).cast<double>();
    Moments moments(own);
    const std::vector<Neighbor> near = index_.nearest(points_.col(point), nearestOfPlane);
    for (const Neighbor& each : near)
      moments.add(Eigen::Vector3f(points_.col(each.index)));
    const auto parts = moments.components();
    if (parts.eigenvalues()[0] > leastFlatness * parts.eigenvalues()[1]) return {};
    if (parts.eigenvalues()[1] <= 0) return {};
    const Plane plane{own, parts.eigenvectors()};
    if (cellOf(plane, near).reach() < least_) return {};
    std::vector<Neighbor> all =
        index_.within(points_.col(point), static_cast<float>(options_.widest));
    std::ranges::sort(
        all, {}, [](const Neighbor& each) { return std::pair(each.squaredDistance, each.index); });
    return holesOf(plane, all);
  }

  /// The new point of a hole: its middle on the surface, if that is free.
  [[nodiscard]] std::optional<Hole> onSurface(const Hole& hole) const {
    const double radius = std::max(options_.radius, 2 * hole.radius);
    const auto place = surface_.nearest(hole.middle, radius);
    if (!place || (*place - hole.middle).norm() > hole.radius) return std::nullopt;
    if (index_.nearestOne(place->cast<float>(), static_cast<float>(options_.spacing)))
      return std::nullopt;
    return Hole{*place, hole.radius};
  }

private:
  static constexpr int nearestOfPlane = 24;
  static constexpr double leastFlatness = 0.2;

  struct Plane {
    Eigen::Vector3d origin;
    Eigen::Matrix3d axes; // the normal first

    [[nodiscard]] Eigen::Vector3d of(const Eigen::Vector3d& place) const {
      return axes.transpose() * (place - origin);
    }
    [[nodiscard]] Eigen::Vector3d at(const Place& place) const {
      return origin + axes.rightCols<2>() * place;
    }
  };

  /// The place of a point in the plane; none for itself, and for what the surface does not lead to.
  [[nodiscard]] std::optional<Place> siteOf(const Neighbor& neighbor, const Plane& plane) const {
    const Eigen::Vector3d from = plane.of(points_.col(neighbor.index).cast<double>());
    const Place site = from.tail<2>();
    if (site.isZero(1e-9 * options_.spacing) || std::abs(from[0]) > site.norm())
      return std::nullopt;
    return site;
  }

  [[nodiscard]] Cell cellOf(const Plane& plane, const std::vector<Neighbor>& near) const {
    Cell cell(options_.widest);
    for (const Neighbor& each : near)
      if (const auto site = siteOf(each, plane)) cell.cut(*site, 0);
    return cell;
  }

  [[nodiscard]] std::vector<Hole> holesOf(const Plane& plane,
                                          const std::vector<Neighbor>& near) const {
    Cell cell(options_.widest);
    std::vector<Place> sites;
    for (const Neighbor& each : near) {
      const auto site = siteOf(each, plane);
      if (!site) continue;
      sites.push_back(*site);
      cell.cut(*site, static_cast<int>(sites.size()) - 1);
    }
    std::vector<Hole> holes;
    for (const Corner& corner : cell.corners()) {
      const double radius = corner.place.norm();
      if (corner.before < 0 || corner.after < 0 || radius < least_ || radius > options_.widest / 2)
        continue;
      if (surround(sites[static_cast<std::size_t>(corner.before)],
                   sites[static_cast<std::size_t>(corner.after)]))
        holes.push_back({plane.at(corner.place), radius});
    }
    return holes;
  }

  const Eigen::Matrix3Xf& points_;
  const HoleOptions& options_;
  double least_;
  SpatialIndex index_;
  LeastSquaresSurface surface_;
};

/// Of holes that overlap, the one that ranks first.
std::vector<Hole> apart(std::vector<Hole> holes, const Progress& progress) {
  constexpr double overlap = 0.8; // [radii] between middles
  std::ranges::sort(holes, {}, &Hole::rank);
  Eigen::Matrix3Xf middles(3, static_cast<Eigen::Index>(holes.size()));
  for (std::size_t i = 0; i < holes.size(); ++i)
    middles.col(static_cast<Eigen::Index>(i)) = holes[i].middle.cast<float>();
  const SpatialIndex index(middles, progress);
  std::vector<char> isFirst(holes.size());
  parallelFor(
      middles.cols(),
      [&](Eigen::Index i) {
        const auto radius = overlap * holes[static_cast<std::size_t>(i)].radius;
        isFirst[static_cast<std::size_t>(i)] =
            !index.nearestIf(middles.col(i), static_cast<float>(radius),
                             [&](Eigen::Index other) { return other < i; });
      },
      progress.part(1, 1), 64);
  std::vector<Hole> first;
  for (std::size_t i = 0; i < holes.size(); ++i)
    if (isFirst[i]) first.push_back(holes[i]);
  return first;
}

/// What one look at points finds.
struct Found {
  std::vector<Hole> holes;          // on the surface
  std::vector<Eigen::Index> points; // that touch them
};

Found holesAt(const std::vector<Eigen::Index>& looked, const HoleSearch& search,
              const Progress& progress) {
  std::vector<std::vector<Hole>> each(looked.size());
  parallelFor(
      static_cast<Eigen::Index>(looked.size()),
      [&](Eigen::Index i) {
        const auto place = static_cast<std::size_t>(i);
        for (const Hole& hole : search.at(looked[place]))
          if (const auto moved = search.onSurface(hole)) each[place].push_back(*moved);
      },
      progress, 64);
  Found found;
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (!each[i].empty()) found.points.push_back(looked[i]);
    found.holes.insert(found.holes.end(), each[i].begin(), each[i].end());
  }
  return found;
}

} // namespace

Eigen::Matrix3Xf pointsInHoles(const Eigen::Matrix3Xf& points, LocalShape shape,
                               const HoleOptions& options, const Progress& progress) {
  Eigen::Matrix3Xf all = points;
  std::vector<Eigen::Index> looked(static_cast<std::size_t>(points.cols()));
  for (std::size_t i = 0; i < looked.size(); ++i)
    looked[i] = static_cast<Eigen::Index>(i);
  double done = 0;
  while (!looked.empty()) {
    const Progress part = progress.part(done, (done + 1) / 2); // how often is not known
    done = (done + 1) / 2;
    const double least = all.cols() == points.cols() ? leastHole : leastLeft;
    const HoleSearch search(all, shape, options, least * options.spacing, part);
    Found found = holesAt(looked, search, part);
    const std::vector<Hole> added = apart(std::move(found.holes), part);
    looked = std::move(found.points);
    const Eigen::Index before = all.cols();
    all.conservativeResize(3, before + static_cast<Eigen::Index>(added.size()));
    for (std::size_t i = 0; i < added.size(); ++i) {
      all.col(before + static_cast<Eigen::Index>(i)) = added[i].middle.cast<float>();
      looked.push_back(before + static_cast<Eigen::Index>(i));
    }
    if (added.empty()) break;
  }
  return all.rightCols(all.cols() - points.cols());
}

} // namespace espalier
