#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <vector>

namespace espalier {

/// A shortest link out of a component.
struct Bridge {
  float squaredLength = std::numeric_limits<float>::max(); // [L^2]; that: there is none
  std::uint32_t from = 0;
  std::uint32_t to = 0;

  [[nodiscard]] bool exists() const { return squaredLength < std::numeric_limits<float>::max(); }
  [[nodiscard]] bool operator<(const Bridge& other) const; // the same choice at both ends
};

/// Finds the shortest links between components of a cloud, round after round of their joining.
///
/// A k-d tree that knows which of its parts lie in one component: a search from there passes over
/// them, and looks no farther than what another point of its component has found.
class BridgeSearch {
public:
  /// @param points 3 x N, finite [L]; must outlive the search. Time O(N log N), on all threads
  /// @throws Cancelled if `progress` asks to stop
  explicit BridgeSearch(const Eigen::Matrix3Xf& points, const Progress& progress = {});

  /// For each component but number 0 its shortest bridge to any other of at most `widest` [L].
  /// Not searching from the largest saves nearly all of the work and loses nothing: each of the
  /// others still finds an edge of the minimum spanning tree.
  ///
  /// @param componentOf by point; numbers from 0 to count - 1, 0 the largest
  /// @return by component
  /// @throws Cancelled if `progress` asks to stop
  /// On all threads, deterministic. Time O(N) and about O(log N) for each point searched from.
  [[nodiscard]] std::vector<Bridge> shortest(const std::vector<std::uint32_t>& componentOf,
                                             std::size_t count, float widest,
                                             const Progress& progress);

private:
  struct Part {
    Eigen::Vector3f low, high;   // of its points [L]
    std::uint32_t begin, end;    // in order_
    std::uint32_t left = 0;      // its halves are parts left and left + 1; 0 in a leaf
    std::uint32_t component = 0; // of all its points, or `mixed`
    [[nodiscard]] bool isLeaf() const { return left == 0; }
    [[nodiscard]] float squaredDistance(const Eigen::Vector3f& place) const;
  };
  static constexpr std::uint32_t mixed = std::numeric_limits<std::uint32_t>::max();

  void addHalves(std::size_t part);
  void split(Part& part); // among its halves
  void label(const std::vector<std::uint32_t>& componentOf);
  [[nodiscard]] Bridge from(std::uint32_t point, const std::vector<std::uint32_t>& componentOf,
                            float squaredReach) const;

  const Eigen::Matrix3Xf& points_;
  std::vector<std::uint32_t> order_; // points, those of a part next to each other
  std::vector<Part> parts_;          // the whole first, each before its halves
};

} // namespace espalier
