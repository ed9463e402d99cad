#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace espalier {

/// Random numbers that depend on a seed and a number: the same for a beam or a point,
/// whichever thread asks for it, and cheap to begin, which Random is not.
///
/// Source: G. L. Steele et al., "Fast splittable pseudorandom number generators", OOPSLA 2014
/// (SplitMix64).
class CountedRandom {
public:
  CountedRandom(std::uint64_t seed, std::uint64_t number)
      : state_(mixed(seed + 0x9e3779b97f4a7c15) ^ mixed(number + 0xd1b54a32d192ed03)) {}

  [[nodiscard]] double uniform() { // in [0, 1)
    state_ += 0x9e3779b97f4a7c15;
    return static_cast<double>(mixed(state_) >> 11) * 0x1.0p-53;
  }

  [[nodiscard]] double normal() { // mean 0, standard deviation 1; Box and Muller
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

private:
  [[nodiscard]] static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

} // namespace espalier
