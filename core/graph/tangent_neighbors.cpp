#include "core/graph/tangent_neighbors.h"

#include "core/base/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

/// Places in the tangent plane of a point, about it.
class TangentPlane {
public:
  TangentPlane(const Eigen::Vector3f& point, const Eigen::Vector3f& normal)
      : point_(point.cast<double>()), right_(normal.cast<double>().normalized().unitOrthogonal()),
        up_(normal.cast<double>().normalized().cross(right_)) {}

  [[nodiscard]] Eigen::Vector2d place(const Eigen::Vector3f& other) const {
    const Eigen::Vector3d d = other.cast<double>() - point_;
    return {d.dot(right_), d.dot(up_)};
  }

private:
  Eigen::Vector3d point_;
  Eigen::Vector3d right_;
  Eigen::Vector3d up_;
};

/// A convex cell about the origin: corner i begins the side that `neighbors[i]` bounds.
struct Cell {
  std::vector<Eigen::Vector2d> corners;
  std::vector<std::uint32_t> neighbors;

  /// Cuts off what is nearer to `place` than to the origin.
  void clip(const Eigen::Vector2d& place, std::uint32_t neighbor) {
    const double limit = place.squaredNorm() / 2;
    Cell rest;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d& a = corners[i];
      const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
      const double overA = a.dot(place) - limit;
      const double overB = b.dot(place) - limit;
      const auto crossing = [&] { return Eigen::Vector2d(a + overA / (overA - overB) * (b - a)); };
      if (overA <= 0) {
        rest.corners.push_back(a);
        rest.neighbors.push_back(neighbors[i]);
        if (overB <= 0) continue;
        rest.corners.emplace_back(crossing()); // the side of the cut begins
        rest.neighbors.push_back(neighbor);
      } else if (overB <= 0) {
        rest.corners.emplace_back(crossing());
        rest.neighbors.push_back(neighbors[i]);
      }
    }
    *this = std::move(rest);
  }

  [[nodiscard]] double squaredReach() const {
    double reach = 0;
    for (const Eigen::Vector2d& corner : corners)
      reach = std::max(reach, corner.squaredNorm());
    return reach;
  }
};

struct Placed {
  double angle;
  double distance;
  std::uint32_t point;
};

/// The gap before each chosen one, in the order of their angles.
double gapBefore(const std::vector<Placed>& chosen, std::size_t i) {
  if (i > 0) return chosen[i].angle - chosen[i - 1].angle;
  return chosen[0].angle - chosen.back().angle + 2 * std::numbers::pi;
}

void insert(std::vector<Placed>& chosen, const Placed& one) {
  chosen.insert(std::ranges::upper_bound(chosen, one.angle, {}, &Placed::angle), one);
}

/// Drops the farthest that leaves no gap wider than `widest`; false if there is none.
bool dropFarthest(std::vector<Placed>& chosen, double widest) {
  std::optional<std::size_t> farthest;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double left = gapBefore(chosen, i) + gapBefore(chosen, (i + 1) % chosen.size());
    if (left > widest || (farthest && chosen[i].distance <= chosen[*farthest].distance)) continue;
    farthest = i;
  }
  if (!farthest) return false;
  chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(*farthest));
  return true;
}

/// The nearest of those left in the gap before chosen[i]; none if it is empty.
std::optional<std::size_t> nearestInGap(const std::vector<Placed>& left,
                                        const std::vector<Placed>& chosen, std::size_t i) {
  const double end = chosen[i].angle;
  const double gap = gapBefore(chosen, i);
  for (std::size_t j = 0; j < left.size(); ++j) {
    double before = end - left[j].angle;
    if (before < 0) before += 2 * std::numbers::pi;
    if (before > 0 && before < gap) return j;
  }
  return std::nullopt;
}

std::vector<std::uint32_t> evenlyAround(std::vector<Placed> left, std::size_t count,
                                        double widest) {
  std::vector<Placed> chosen;
  const std::size_t first = std::min(count, left.size());
  for (std::size_t i = 0; i < first; ++i)
    insert(chosen, left[i]);
  left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = 0; i < chosen.size();) {
    const auto next = gapBefore(chosen, i) > widest ? nearestInGap(left, chosen, i) : std::nullopt;
    if (!next) {
      ++i;
      continue;
    }
    insert(chosen, left[*next]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(*next));
    if (dropFarthest(chosen, widest)) i = 0; // places have moved
  }
  std::vector<std::uint32_t> points;
  points.reserve(chosen.size());
  for (const Placed& one : chosen)
    points.push_back(one.point);
  return points;
}

} // namespace

std::vector<std::uint32_t> voronoiRing(const Eigen::Matrix3Xf& points, Eigen::Index point,
                                       const Eigen::Vector3f& normal,
                                       std::span<const std::uint32_t> candidates) {
  const TangentPlane plane(points.col(point), normal);
  double reach = 0;
  for (const std::uint32_t other : candidates)
    reach = std::max(reach, plane.place(points.col(other)).norm());
  if (reach == 0) return {};
  // A cell that comes out larger than this has no bound that the candidates know of.
  const double far = 4 * reach;
  Cell cell{.corners = {{-far, -far}, {far, -far}, {far, far}, {-far, far}},
            .neighbors = std::vector<std::uint32_t>(4, noNeighbor)};
  double squaredReach = cell.squaredReach();
  for (const std::uint32_t other : candidates) {
    const Eigen::Vector2d place = plane.place(points.col(other));
    const double squared = place.squaredNorm();
    if (squared <= 1e-12 * reach * reach || squared > 4 * squaredReach) continue;
    cell.clip(place, other);
    squaredReach = cell.squaredReach();
  }
  std::vector<std::uint32_t> ring;
  for (const std::uint32_t neighbor : cell.neighbors)
    if (ring.empty() || neighbor != noNeighbor || ring.back() != noNeighbor)
      ring.push_back(neighbor);
  if (ring.size() > 1 && ring.front() == noNeighbor && ring.back() == noNeighbor) ring.pop_back();
  return ring;
}

Neighborhoods voronoiNeighbors(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& normals,
                               const Neighborhoods& candidates, const Progress& progress) {
  std::vector<std::vector<std::uint32_t>> lists(candidates.size());
  const auto find = [&](Eigen::Index point) {
    auto ring = voronoiRing(points, point, normals.col(point), candidates.of(point));
    std::erase(ring, noNeighbor);
    lists[static_cast<std::size_t>(point)] = std::move(ring);
  };
  parallelFor(points.cols(), find, progress);
  return joinedLists(lists, progress);
}

Neighborhoods angleCriterionNeighbors(const Eigen::Matrix3Xf& points,
                                      const Eigen::Matrix3Xf& normals,
                                      const Neighborhoods& candidates, int count, double widestGap,
                                      const Progress& progress) {
  std::vector<std::vector<std::uint32_t>> lists(candidates.size());
  const auto find = [&](Eigen::Index point) {
    const TangentPlane plane(points.col(point), normals.col(point));
    std::vector<Placed> placed;
    for (const std::uint32_t other : candidates.of(point)) {
      const Eigen::Vector2d place = plane.place(points.col(other));
      const double distance = (points.col(other) - points.col(point)).cast<double>().norm();
      placed.push_back({std::atan2(place.y(), place.x()), distance, other});
    }
    lists[static_cast<std::size_t>(point)] =
        evenlyAround(std::move(placed), static_cast<std::size_t>(std::max(count, 0)), widestGap);
  };
  parallelFor(points.cols(), find, progress);
  return joinedLists(lists, progress);
}

} // namespace espalier
