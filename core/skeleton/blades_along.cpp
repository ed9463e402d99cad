#include "core/skeleton/blades_along.h"

#include "core/skeleton/frustum.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector2d;

constexpr double pieceLength = 4;     // spacings, at least, where edges are that long
constexpr double touching = 1.5;      // spacings from where points are off the wood: no gap
constexpr double leastTouching = 0.7; // of the length along which there are points
constexpr double narrowest = 5;       // spacings off the wood: a twig beside an axis is narrower
constexpr double slenderness = 2;     // of the length that touches the axis, by how far it is off
constexpr double thickest = 0.15;     // of the width of the layer, as standard deviations

/// Some of an edge, and the points that are nearest to it.
struct Piece {
  double length = 0;                                        // [L]
  double nearest = std::numeric_limits<double>::infinity(); // of them to the wood [L]
  std::vector<Vector2d> across;                             // from the center line [L]
};

/// Variances of places along their principal directions, times their number [L^2]: the lesser, the
/// greater.
Vector2d spreadOf(const std::vector<Vector2d>& places) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& place : places)
    mean += place / static_cast<double>(places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vector2d& place : places)
    spread += (place - mean) * (place - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

/// By edge, and by place along it.
std::map<std::pair<NodeId, int>, Piece>
piecesAlong(const Skeleton& skeleton, const std::vector<PointOffWood>& points, double spacing) {
  std::map<std::pair<NodeId, int>, Piece> pieces;
  for (const PointOffWood& point : points) {
    const Frustum line = centerLine(skeleton, point.edge);
    const double share = line.nearestShare(point.place);
    const double count = std::max(1.0, std::floor(line.length() / (pieceLength * spacing)));
    Piece& piece = pieces[{point.edge, static_cast<int>(std::min(share * count, count - 1))}];
    piece.length = line.length() / count;
    piece.nearest = std::min(piece.nearest, point.off);
    const Eigen::Vector3d along = (line.to - line.from).normalized();
    const Eigen::Vector3d first = along.unitOrthogonal();
    const Eigen::Vector3d offset = point.place - line.at(share);
    piece.across.emplace_back(first.dot(offset), along.cross(first).dot(offset));
  }
  return pieces;
}

} // namespace

std::vector<PointOffWood> pointsOffWood(const std::vector<Eigen::Index>& points,
                                        const PointDistances& distances, double reach) {
  std::vector<PointOffWood> result;
  result.reserve(points.size());
  for (const Eigen::Index point : points) {
    const auto i = static_cast<std::size_t>(point);
    result.push_back({distances.cloud()->position(point), distances.nearest()[i],
                      distances.toSurface()[i] - reach});
  }
  return result;
}

bool isBladeAlong(const Skeleton& skeleton, const std::vector<PointOffWood>& points,
                  double spacing) {
  const double width = std::ranges::max_element(points, {}, &PointOffWood::off)->off;
  if (width < narrowest * spacing) return false;
  double all = 0;
  double touches = 0;
  Vector2d spread = Vector2d::Zero();
  for (const auto& [place, piece] : piecesAlong(skeleton, points, spacing)) {
    all += piece.length;
    if (piece.nearest > touching * spacing) continue;
    touches += piece.length;
    if (piece.across.size() > 2) spread += spreadOf(piece.across); // two lie on a line
  }
  return touches >= leastTouching * all && touches >= slenderness * width &&
         spread[0] <= thickest * thickest * spread[1];
}

} // namespace espalier
