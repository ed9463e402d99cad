#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {

/// Finds boxes near a place or along a ray: axis-aligned boxes halved again and again at the median
/// of their centers.
///
/// Build O(N log N), memory O(N). Queries are const and may run on many threads.
class BoxTree {
public:
  static constexpr std::uint32_t noGroup = std::numeric_limits<std::uint32_t>::max();

  /// @param boxes  none of them empty
  /// @param groups of each box, for within(); empty: none is of any
  explicit BoxTree(std::vector<Eigen::AlignedBox3d> boxes, std::vector<std::uint32_t> groups = {});

  /// Calls visit(i) for each box i at most `distance` [L] from `box`, in no order that means
  /// anything. Boxes of group `but` are passed over where they lie together: some may be visited.
  template <class Visit>
  void within(const Eigen::AlignedBox3d& box, double distance, const Visit& visit,
              std::uint32_t but = noGroup) const {
    if (parts_.empty()) return;
    const double limit = distance * distance;
    Stack open;
    for (open.push({0, 0}); !open.isEmpty();) {
      const Part& part = parts_[open.pop().part];
      if (part.group != noGroup && part.group == but) continue;
      if (part.box.squaredExteriorDistance(box) > limit) continue;
      if (part.isLeaf()) {
        for (std::uint32_t k = part.begin; k < part.end; ++k)
          if (boxes_[order_[k]].squaredExteriorDistance(box) <= limit) visit(order_[k]);
      } else {
        open.push({part.left, 0});
        open.push({part.left + 1, 0});
      }
    }
  }

  /// The i of least squaredDistance(i), a distance to something inside box i [L^2]; none if there
  /// are no boxes.
  template <class SquaredDistance>
  [[nodiscard]] std::optional<std::size_t> nearest(const Eigen::Vector3d& place,
                                                   const SquaredDistance& squaredDistance) const {
    std::optional<std::size_t> found;
    double least = std::numeric_limits<double>::infinity();
    const auto toBox = [&](const Eigen::AlignedBox3d& box) {
      return box.squaredExteriorDistance(place);
    };
    search(toBox, least, [&](std::size_t i) {
      if (const double distance = squaredDistance(i); distance < least) {
        least = distance;
        found = i;
      }
      return least;
    });
    return found;
  }

  /// Visits boxes that cost less than a limit, cheaper halves first. cost(box) is at most that of
  /// any box inside; visit(i) returns the limit from there on.
  template <class Cost, class Visit>
  void search(const Cost& cost, double limit, const Visit& visit) const {
    if (parts_.empty()) return;
    Stack open;
    for (open.push({0, cost(parts_[0].box)}); !open.isEmpty();) {
      const Open next = open.pop();
      if (!(next.cost < limit)) continue;
      const Part& part = parts_[next.part];
      if (part.isLeaf()) {
        for (std::uint32_t k = part.begin; k < part.end; ++k)
          limit = visit(order_[k]);
        continue;
      }
      const Open left{part.left, cost(parts_[part.left].box)};
      const Open right{part.left + 1, cost(parts_[part.left + 1].box)};
      open.push(left.cost < right.cost ? right : left);
      open.push(left.cost < right.cost ? left : right);
    }
  }

  /// Numbers the boxes anew, those of a part side by side. Returns the old number of each.
  std::vector<std::uint32_t> renumber();

  [[nodiscard]] Eigen::AlignedBox3d bounds() const { // [L]; empty without boxes
    return parts_.empty() ? Eigen::AlignedBox3d() : parts_.front().box;
  }

private:
  struct Part {
    Eigen::AlignedBox3d box;
    std::uint32_t begin, end;      // in order_
    std::uint32_t left = 0;        // its halves are parts left and left + 1; 0 in a leaf
    std::uint32_t group = noGroup; // of all its boxes
    [[nodiscard]] bool isLeaf() const { return left == 0; }
  };
  struct Open {
    std::uint32_t part;
    double cost;
  };
  /// Parts still to be looked at. Halving 2^32 boxes never leaves more than 64 of them.
  struct Stack {
    std::array<Open, 64> parts;
    std::size_t size = 0;
    void push(const Open& part) { parts[size++] = part; }
    Open pop() { return parts[--size]; }
    [[nodiscard]] bool isEmpty() const { return size == 0; }
  };

  void split(std::uint32_t part);

  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::uint32_t> groups_; // of the boxes; empty: none
  std::vector<std::uint32_t> order_;  // boxes, those of a part next to each other
  std::vector<Part> parts_;           // the whole first
};

} // namespace espalier
