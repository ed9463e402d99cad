#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <random>

namespace espalier {

/// Random numbers that depend on the seed alone: the distributions of the standard library differ
/// between compilers, these do not.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform();                       // in [0, 1)
  [[nodiscard]] double uniform(double from, double to); // in [from, to)
  [[nodiscard]] std::size_t below(std::size_t count);   // in [0, count), pre: count > 0
  [[nodiscard]] double normal();                        // mean 0, standard deviation 1
  [[nodiscard]] Eigen::Vector3d direction();            // evenly on the unit sphere

private:
  std::mt19937_64 engine_;
};

} // namespace espalier
