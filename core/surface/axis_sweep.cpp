#include "core/surface/axis_sweep.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr int mostDivisions = 4; // of an edge, into halves

struct Knot {
  Vector3d position;
  double radius;
};

/// A cubic piece of the curve, by its ends and its derivatives there.
struct Piece {
  Vector3d start, end;
  Vector3d startSlope, endSlope;

  [[nodiscard]] Vector3d at(double t) const {
    const double u = 1 - t;
    return u * u * (1 + 2 * t) * start + t * t * (3 - 2 * t) * end + u * u * t * startSlope -
           t * t * u * endSlope;
  }
  [[nodiscard]] Vector3d slopeAt(double t) const {
    return 6 * t * (1 - t) * (end - start) + (1 - t) * (1 - 3 * t) * startSlope +
           t * (3 * t - 2) * endSlope;
  }
};

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Nodes of the axis one after another, each apart from the one before. An axis that is attached to
/// a node begins there.
std::vector<Knot> knotsOf(const Skeleton& skeleton, const Axis& axis,
                          const std::vector<double>& radii) {
  std::vector<Knot> knots;
  const double first = radii[indexOf(axis.front())];
  if (const auto bearer = skeleton[axis.front()].parent)
    knots.push_back({skeleton[*bearer].position, std::min(first, radii[indexOf(*bearer)])});
  for (const NodeId id : axis) {
    const Knot knot{skeleton[id].position, radii[indexOf(id)]};
    if (knots.empty() || knot.position != knots.back().position)
      knots.push_back(knot);
    else
      knots.back().radius = std::max(knots.back().radius, knot.radius);
  }
  return knots;
}

/// The direction in which the axis that bears `axis` passes there; zero for a root, or where
/// it turns back.
Vector3d directionOfBearer(const Skeleton& skeleton, const Axis& axis) {
  const auto bearer = skeleton[axis.front()].parent;
  if (!bearer) return Vector3d::Zero();
  const Node& node = skeleton[*bearer];
  const Vector3d before = node.parent
                              ? (node.position - skeleton[*node.parent].position).stableNormalized()
                              : Vector3d::Zero();
  const NodeId next = skeleton.children(*bearer).front(); // the successor, if there is one
  const Vector3d after = next != axis.front() && skeleton[next].edge == EdgeType::successor
                             ? (skeleton[next].position - node.position).stableNormalized()
                             : Vector3d::Zero();
  return (before + after).stableNormalized();
}

/// Derivative of the curve by its parameter at the middle one of three knots, for a parameter that
/// grows by the square root of their distance: no loops, no overshoot beyond the neighbors.
Vector3d slopeBetween(const Vector3d& before, const Vector3d& here, const Vector3d& after) {
  const double back = std::sqrt((here - before).norm());
  const double ahead = std::sqrt((after - here).norm());
  return (here - before) / back - (after - before) / (back + ahead) + (after - here) / ahead;
}

std::vector<Piece> piecesOf(const std::vector<Knot>& knots, const Vector3d& directionBefore) {
  const std::size_t n = knots.size();
  std::vector<Vector3d> slopes(n); // by a parameter that grows by sqrt(distance)
  for (std::size_t i = 1; i + 1 < n; ++i)
    slopes[i] = slopeBetween(knots[i - 1].position, knots[i].position, knots[i + 1].position);
  const Vector3d first = knots[1].position - knots[0].position;
  const Vector3d last = knots[n - 1].position - knots[n - 2].position;
  slopes[0] = first / std::sqrt(first.norm());
  slopes[n - 1] = last / std::sqrt(last.norm());
  if (n > 2) { // at an end the curve bends as it does beside it
    slopes[n - 1] = 1.5 * slopes[n - 1] - 0.5 * slopes[n - 2];
    slopes[0] = 1.5 * slopes[0] - 0.5 * slopes[1];
  }
  if (first.dot(directionBefore) > 0)
    slopes[0] = (first.normalized() + directionBefore).normalized() * std::sqrt(first.norm());
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double step = std::sqrt((knots[i + 1].position - knots[i].position).norm());
    pieces.push_back(
        {knots[i].position, knots[i + 1].position, slopes[i] * step, slopes[i + 1] * step});
  }
  return pieces;
}

/// Appends the parameters in (from, to] at which a piece needs sections.
void divide(const Piece& piece, double turn, double from, double to, int depth,
            std::vector<double>& result) {
  const double middle = (from + to) / 2;
  const Vector3d slope = piece.slopeAt(middle);
  const double angle =
      angleBetween(piece.slopeAt(from), slope) + angleBetween(slope, piece.slopeAt(to));
  if (angle <= turn || depth == 0) {
    result.push_back(to);
    return;
  }
  divide(piece, turn, from, middle, depth - 1, result);
  divide(piece, turn, middle, to, depth - 1, result);
}

/// Turns `forward` of the section before into the plane of this one, without a twist.
Vector3d carried(const Section& from, const Vector3d& center, const Vector3d& normal) {
  const auto mirrored = [](const Vector3d& v, const Vector3d& along) -> Vector3d {
    const double square = along.squaredNorm();
    return square > 0 ? Vector3d(v - 2 * v.dot(along) / square * along) : v;
  };
  const Vector3d along = center - from.center;
  const Vector3d forward = mirrored(from.forward, along);
  const Vector3d across = mirrored(from.normal, along);
  const Vector3d result = mirrored(forward, normal - across);
  return (result - result.dot(normal) * normal).normalized(); // against rounding, over long axes
}

Vector3d acrossTo(const Vector3d& normal) {
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  return normal.cross(Vector3d::Unit(least)).normalized();
}

} // namespace

std::vector<Section> sectionsOf(const Skeleton& skeleton, const Axis& axis,
                                const std::vector<double>& radii, double turn) {
  const std::vector<Knot> knots = knotsOf(skeleton, axis, radii);
  if (knots.size() < 2) return {};
  const std::vector<Piece> pieces = piecesOf(knots, directionOfBearer(skeleton, axis));
  std::vector<Section> sections;
  const Vector3d start = pieces.front().startSlope.normalized();
  sections.push_back({knots[0].position, knots[0].radius, start, acrossTo(start)});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::vector<double> places;
    divide(pieces[i], turn, 0, 1, mostDivisions, places);
    for (const double t : places) {
      const Vector3d slope = pieces[i].slopeAt(t);
      // The curve stands still where it turns right back: it goes on as the edge does.
      const Vector3d normal = slope.squaredNorm() > 0
                                  ? slope.normalized()
                                  : (knots[i + 1].position - knots[i].position).normalized();
      const Vector3d center = t == 1 ? knots[i + 1].position : pieces[i].at(t);
      const double radius = (1 - t) * knots[i].radius + t * knots[i + 1].radius;
      sections.push_back({center, radius, normal, carried(sections.back(), center, normal)});
    }
  }
  return sections;
}

} // namespace espalier
