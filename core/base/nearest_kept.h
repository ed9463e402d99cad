#pragma once

#include <Eigen/Core>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace espalier {

/// Keeps the nearest points of a search of nanoflann's, of equally near ones those found first.
///
/// Each has a key that grows with its distance, then with when it was found. Keys are kept as the
/// doubles of the same bits, which sort alike: a new one goes to its place without a branch.
class NearestKept {
public:
  explicit NearestKept(std::size_t count) // > 0
      : count_(count), keys_((count + 1) / 2) {
    begin(std::numeric_limits<float>::max());
  }

  /// Forgets all; keeps no more but what is nearer than `squaredReach` [L^2].
  void begin(float squaredReach) {
    found_.clear();
    keys_.assign(keys_.size(), Two::Constant(keyOf(squaredReach, none)));
  }

  // As nanoflann asks for it.
  [[nodiscard]] float worstDist() const { return distanceOf(key(count_ - 1)); } // [L^2]
  [[nodiscard]] static bool full() { return true; }
  [[nodiscard]] std::size_t size() const { return found_.size(); }
  static void sort() {}
  bool addPoint(float squaredDistance, std::uint32_t index) {
    const double added = keyOf(squaredDistance, static_cast<std::uint32_t>(found_.size()));
    found_.push_back(index);
    double last = -1;        // before all others
    for (Two& own : keys_) { // each place keeps its own, takes the new one, or that before its own
      const Two before(last, own[0]);
      last = own[1];
      own = before.max(own.min(added));
    }
    return true;
  }

  /// Calls visit(index, squaredDistance) for each, the nearest first.
  template <class Visit> void forEach(const Visit& visit) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const auto number = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(key(i)));
      if (number == none) return;
      visit(found_[number], distanceOf(key(i)));
    }
  }

private:
  using Two = Eigen::Array2d; // goes to its place in one step
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  static double keyOf(float squaredDistance, std::uint32_t number) {
    const std::uint64_t high = std::bit_cast<std::uint32_t>(squaredDistance);
    return std::bit_cast<double>(high << 32 | number);
  }
  static float distanceOf(double key) {
    return std::bit_cast<float>(
        static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(key) >> 32));
  }

  [[nodiscard]] double key(std::size_t i) const { return keys_[i / 2][i % 2]; }

  std::size_t count_;
  std::vector<Two> keys_;            // the nearest first
  std::vector<std::uint32_t> found_; // index, by number
};

} // namespace espalier
