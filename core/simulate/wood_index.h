#pragma once

#include "core/simulate/wood.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {

/// Finds the wood that a ray meets or a place lies in. A tree of boxes around the pieces.
///
/// Build O(N log N); one query O(log N) as long as few boxes overlap. Queries are const and may run
/// on many threads.
class WoodIndex {
public:
  explicit WoodIndex(std::vector<WoodPiece> wood);

  [[nodiscard]] const std::vector<WoodPiece>& wood() const { return wood_; }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const; // [L]; empty without wood

  /// The first wood on the ray within `range` [L], if any.
  [[nodiscard]] std::optional<WoodHit>
  firstHit(const Ray& ray, double range = std::numeric_limits<double>::infinity()) const;

  /// The least signedDistance [L] from a place to wood if it is under `reach`, else `reach`.
  [[nodiscard]] double distance(const Eigen::Vector3d& place, double reach) const;

private:
  struct Box {
    Eigen::AlignedBox3d bounds;
    std::uint32_t first = 0; // of its pieces, or of its two boxes
    std::uint32_t count = 0; // of its pieces; 0: it holds boxes
  };
  void split(std::uint32_t box, std::uint32_t first, std::uint32_t count);

  std::vector<WoodPiece> wood_; // those of a box side by side
  std::vector<Box> boxes_;      // the first holds all
};

} // namespace espalier
