#include "core/skeleton/blades_along.h"

#include "core/skeleton/frustum.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
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
constexpr double widening = 2;        // of its middle width: a blade is no wider anywhere

/// Some of an edge, and the points that are nearest to it.
struct Piece {
  double length = 0;                                        // [L]
  double nearest = std::numeric_limits<double>::infinity(); // of them to the wood [L]
  double farthest = 0;                                      // [L]
  std::vector<Vector2d> across;                             // from the center line [L]
  std::vector<std::size_t> points;
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

/// Those of a piece, of either side of the axis by itself: a blade may be folded along it.
Vector2d spreadOf(const Piece& piece) {
  Eigen::Matrix2d about = Eigen::Matrix2d::Zero(); // the axis
  for (const Vector2d& place : piece.across)
    about += place * place.transpose();
  const Vector2d along =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(about).eigenvectors().col(1);
  std::array<std::vector<Vector2d>, 2> sides;
  for (const Vector2d& place : piece.across)
    sides[along.dot(place) > 0 ? 1 : 0].push_back(place);
  Vector2d spread = Vector2d::Zero();
  for (const std::vector<Vector2d>& side : sides)
    if (side.size() > 2) spread += spreadOf(side); // two lie on a line
  return spread;
}

bool isLayer(const Vector2d& spread, double thickness) {
  return spread[0] <= thickness * thickness * spread[1];
}

/// In order of their edges, and along them.
std::vector<Piece> piecesAlong(const Skeleton& skeleton, const std::vector<PointOffWood>& points,
                               double spacing) {
  std::map<std::pair<NodeId, int>, Piece> pieces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointOffWood& point = points[i];
    const Frustum line = centerLine(skeleton, point.edge);
    const double share = line.nearestShare(point.place);
    const double count = std::max(1.0, std::floor(line.length() / (pieceLength * spacing)));
    Piece& piece = pieces[{point.edge, static_cast<int>(std::min(share * count, count - 1))}];
    piece.length = line.length() / count;
    piece.nearest = std::min(piece.nearest, point.off);
    piece.farthest = std::max(piece.farthest, point.off);
    const Eigen::Vector3d along = (line.to - line.from).normalized();
    const Eigen::Vector3d first = along.unitOrthogonal();
    const Eigen::Vector3d offset = point.place - line.at(share);
    piece.across.emplace_back(first.dot(offset), along.cross(first).dot(offset));
    piece.points.push_back(i);
  }
  std::vector<Piece> all;
  all.reserve(pieces.size());
  for (auto& [place, piece] : pieces)
    all.push_back(std::move(piece));
  return all;
}

double lengthOf(const std::vector<Piece>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), 0.0,
                         [](double sum, const Piece& piece) { return sum + piece.length; });
}

/// Whether pieces that touch the wood are a blade along it.
bool areBlade(const std::vector<Piece>& pieces, double spacing) {
  double width = 0;
  Vector2d spread = Vector2d::Zero();
  for (const Piece& piece : pieces) {
    width = std::max(width, piece.farthest);
    spread += spreadOf(piece);
  }
  return width >= narrowest * spacing && lengthOf(pieces) >= slenderness * width &&
         isLayer(spread, thickest);
}

/// How far half of the length of pieces reaches off the wood at most [L].
double middleWidth(std::vector<Piece> pieces) {
  std::ranges::sort(pieces, {}, &Piece::farthest);
  double left = lengthOf(pieces) / 2;
  const auto middle =
      std::ranges::find_if(pieces, [&](const Piece& piece) { return (left -= piece.length) <= 0; });
  return middle != pieces.end() ? middle->farthest : 0;
}

/// What of a piece is within a distance of the wood [L].
Piece within(double reach, const Piece& piece, const std::vector<PointOffWood>& points) {
  Piece near{.length = piece.length, .nearest = piece.nearest};
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const double off = points[piece.points[i]].off;
    if (off > reach) continue;
    near.farthest = std::max(near.farthest, off);
    near.across.push_back(piece.across[i]);
    near.points.push_back(piece.points[i]);
  }
  return near;
}

} // namespace

std::vector<std::size_t> pointsOffBlades(const Skeleton& skeleton,
                                         const std::vector<PointOffWood>& points, double spacing) {
  std::vector<std::size_t> off(points.size());
  std::iota(off.begin(), off.end(), std::size_t{0});
  std::vector<Piece> pieces = piecesAlong(skeleton, points, spacing);
  const double length = lengthOf(pieces);
  std::erase_if(pieces, [&](const Piece& piece) { return piece.nearest > touching * spacing; });
  if (lengthOf(pieces) >= leastTouching * length && areBlade(pieces, spacing)) return {};
  // Else some of them may be one.
  const double middle = middleWidth(pieces);
  for (Piece& piece : pieces) {
    Piece near = within(widening * middle, piece, points);
    if (!isLayer(spreadOf(near), thickest)) near = within(middle, piece, points);
    piece = std::move(near);
  }
  std::erase_if(pieces, [](const Piece& piece) { return !isLayer(spreadOf(piece), 2 * thickest); });
  if (!areBlade(pieces, spacing)) return off;
  std::vector<bool> isOfBlade(points.size(), false);
  for (const Piece& piece : pieces)
    for (const std::size_t point : piece.points)
      isOfBlade[point] = true;
  std::erase_if(off, [&](std::size_t point) { return isOfBlade[point]; });
  return off;
}

std::vector<Eigen::Index> pointsOffBlades(const Skeleton& skeleton,
                                          const std::vector<Eigen::Index>& points,
                                          const PointDistances& distances, double reach,
                                          double spacing) {
  std::vector<PointOffWood> places;
  places.reserve(points.size());
  for (const Eigen::Index point : points) {
    const auto i = static_cast<std::size_t>(point);
    places.push_back({distances.cloud()->position(point), distances.nearest()[i],
                      distances.toSurface()[i] - reach});
  }
  std::vector<Eigen::Index> off;
  for (const std::size_t i : pointsOffBlades(skeleton, places, spacing))
    off.push_back(points[i]);
  return off;
}

} // namespace espalier
