#pragma once

#include "core/simulate/wood.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace espalier {

/// Finds the piece that a ray meets or a place lies in. A tree of boxes around the pieces.
///
/// A Piece has boundsOf and hit, and signedDistance if distance is asked for.
/// Build O(N log N); one query O(log N) as long as few boxes overlap. Queries are const and may run
/// on many threads.
template <class Piece> class PieceTree {
public:
  explicit PieceTree(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
    if (pieces_.empty()) return;
    boxes_.reserve(pieces_.size());
    boxes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(pieces_.size()));
  }

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const { // [L]; empty without pieces
    return boxes_.empty() ? Eigen::AlignedBox3d{} : boxes_.front().bounds;
  }

  /// The first piece on the ray within `range` [L], if any.
  [[nodiscard]] std::optional<WoodHit>
  firstHit(const Ray& ray, double range = std::numeric_limits<double>::infinity()) const;

  /// The least signedDistance [L] from a place to a piece if it is under `reach`, else `reach`.
  [[nodiscard]] double distance(const Eigen::Vector3d& place, double reach) const;

private:
  static constexpr std::uint32_t piecesPerBox = 4;
  static constexpr std::size_t maxDepth = 64; // halved at each step: more than 2^32 pieces

  struct Box {
    Eigen::AlignedBox3d bounds;
    std::uint32_t first = 0; // of its pieces, or of its two boxes
    std::uint32_t count = 0; // of its pieces; 0: it holds boxes
  };

  void split(std::uint32_t box, std::uint32_t first, std::uint32_t count);

  /// One over each coordinate. No infinity for 0: along a side of a box it would give
  /// 0 * infinity, and the NaN would hide the box.
  [[nodiscard]] static Eigen::Array3d inverseOf(const Eigen::Vector3d& direction) {
    return direction.unaryExpr([](double x) { return std::abs(x) > 1e-300 ? 1 / x : 1e300; })
        .array();
  }

  /// Where the ray enters the box, or infinity if it misses it or enters beyond `range`.
  [[nodiscard]] static double entry(const Eigen::AlignedBox3d& box, const Ray& ray,
                                    const Eigen::Array3d& inverse, double range) {
    double from = 0;
    double to = range;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min()[axis] - ray.origin[axis]) * inverse[axis];
      const double b = (box.max()[axis] - ray.origin[axis]) * inverse[axis];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  }

  std::vector<Piece> pieces_; // those of a box side by side
  std::vector<Box> boxes_;    // the first holds all
};

template <class Piece>
void PieceTree<Piece>::split(std::uint32_t box, std::uint32_t first, std::uint32_t count) {
  const auto middle = [](const Piece& piece) -> Eigen::Vector3d {
    return boundsOf(piece).center();
  };
  Eigen::AlignedBox3d bounds;
  Eigen::AlignedBox3d middles;
  for (std::uint32_t i = first; i < first + count; ++i) {
    bounds.extend(boundsOf(pieces_[i]));
    middles.extend(middle(pieces_[i]));
  }
  if (count <= piecesPerBox) {
    boxes_[box] = {bounds, first, count};
    return;
  }
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const auto placeOf = [&](const Piece& piece) {
    const Eigen::Vector3d at = middle(piece);
    return std::tuple(at[axis], at.x(), at.y(), at.z());
  };
  const std::uint32_t half = count / 2;
  std::nth_element(pieces_.begin() + first, pieces_.begin() + first + half,
                   pieces_.begin() + first + count,
                   [&](const Piece& a, const Piece& b) { return placeOf(a) < placeOf(b); });
  const auto children = static_cast<std::uint32_t>(boxes_.size());
  boxes_.resize(boxes_.size() + 2);
  boxes_[box] = {bounds, children, 0};
  split(children, first, half);
  split(children + 1, first + half, count - half);
}

template <class Piece>
std::optional<WoodHit> PieceTree<Piece>::firstHit(const Ray& ray, double range) const {
  std::optional<WoodHit> best;
  if (boxes_.empty()) return best;
  const Eigen::Array3d inverse = inverseOf(ray.direction);
  std::array<std::pair<double, std::uint32_t>, maxDepth> open;
  std::size_t size = 0;
  open[size++] = {entry(boxes_[0].bounds, ray, inverse, range), 0};
  while (size > 0) {
    const auto [start, at] = open[--size];
    if (!(start < range)) continue;
    const Box& box = boxes_[at];
    for (std::uint32_t i = box.first; i < box.first + box.count; ++i)
      if (const std::optional<WoodHit> next = hit(pieces_[i], ray); next && next->range < range) {
        best = next;
        range = next->range;
      }
    if (box.count > 0) continue;
    std::pair near{entry(boxes_[box.first].bounds, ray, inverse, range), box.first};
    std::pair far{entry(boxes_[box.first + 1].bounds, ray, inverse, range), box.first + 1};
    if (far.first < near.first) std::swap(near, far);
    open[size++] = far; // the nearer box comes off first
    open[size++] = near;
  }
  return best;
}

template <class Piece>
double PieceTree<Piece>::distance(const Eigen::Vector3d& place, double reach) const {
  if (boxes_.empty()) return reach;
  std::array<std::uint32_t, maxDepth> open;
  std::size_t size = 0;
  open[size++] = 0;
  while (size > 0) {
    const Box& box = boxes_[open[--size]];
    if (box.bounds.exteriorDistance(place) > std::max(reach, 0.0)) continue;
    for (std::uint32_t i = box.first; i < box.first + box.count; ++i)
      reach = std::min(reach, signedDistance(pieces_[i], place));
    if (box.count > 0) continue;
    open[size++] = box.first;
    open[size++] = box.first + 1;
  }
  return reach;
}

using WoodIndex = PieceTree<WoodPiece>;

} // namespace espalier
