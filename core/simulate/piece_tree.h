#pragma once

#include "core/base/box_tree.h"
#include "core/simulate/wood.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {

/// Finds the piece that a ray meets or a place lies in.
///
/// A Piece has boundsOf and hit, and signedDistance if distance is asked for.
/// Build O(N log N); one query O(log N) as long as few boxes overlap. Queries are const and may run
/// on many threads.
template <class Piece> class PieceTree {
public:
  explicit PieceTree(const std::vector<Piece>& pieces) : boxes_(boxesOf(pieces)) {
    pieces_.reserve(pieces.size());
    for (const std::uint32_t i : boxes_.renumber())
      pieces_.push_back(pieces[i]);
  }

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; } // near ones together
  [[nodiscard]] Eigen::AlignedBox3d bounds() const { return boxes_.bounds(); }

  /// The first piece on the ray within `range` [L], if any.
  [[nodiscard]] std::optional<WoodHit>
  firstHit(const Ray& ray, double range = std::numeric_limits<double>::infinity()) const {
    const Eigen::Array3d inverse = inverseOf(ray.direction);
    std::optional<WoodHit> best;
    const auto cost = [&](const Eigen::AlignedBox3d& box) {
      return entry(box, ray, inverse, range);
    };
    boxes_.search(cost, range, [&](std::size_t i) {
      if (const std::optional<WoodHit> next = hit(pieces_[i], ray); next && next->range < range) {
        best = next;
        range = next->range;
      }
      return range;
    });
    return best;
  }

  /// The least signedDistance [L] from a place to a piece if it is under `reach`, else `reach`.
  [[nodiscard]] double distance(const Eigen::Vector3d& place, double reach) const {
    const auto cost = [&](const Eigen::AlignedBox3d& box) {
      return box.contains(place) ? -1 : box.exteriorDistance(place);
    };
    boxes_.search(cost, std::max(reach, 0.0), [&](std::size_t i) {
      reach = std::min(reach, signedDistance(pieces_[i], place));
      return std::max(reach, 0.0);
    });
    return reach;
  }

private:
  static BoxTree boxesOf(const std::vector<Piece>& pieces) {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(pieces.size());
    for (const Piece& piece : pieces)
      boxes.push_back(boundsOf(piece));
    return BoxTree(std::move(boxes));
  }

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

  BoxTree boxes_;
  std::vector<Piece> pieces_; // by its numbers
};

using WoodIndex = PieceTree<EdgeSolid>;

} // namespace espalier
