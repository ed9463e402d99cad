#pragma once

#include <Eigen/Core>

namespace espalier {

/// The order in which points are drawn: one that leads all over the cloud again and again, so that
/// the first of them show all of it.
class DrawingOrder {
public:
  explicit DrawingOrder(Eigen::Index count); // pre: count >= 0, < 3e9

  [[nodiscard]] Eigen::Index size() const { return count_; }
  [[nodiscard]] Eigen::Index pointAt(Eigen::Index rank) const { return rank * step_ % count_; }
  [[nodiscard]] Eigen::Index rankOf(Eigen::Index point) const { return point * back_ % count_; }
  /// The point at the rank behind that of `point`.
  [[nodiscard]] Eigen::Index after(Eigen::Index point) const {
    const Eigen::Index next = point + step_;
    return next >= count_ ? next - count_ : next;
  }

private:
  Eigen::Index count_;
  Eigen::Index step_;     // near the count over the golden ratio, without a factor shared with it
  Eigen::Index back_ = 0; // step_ * back_ is 1, but for multiples of the count
};

} // namespace espalier
