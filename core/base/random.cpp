#include "core/base/random.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace espalier {

double Random::uniform() {
  return static_cast<double>(engine_() >> 11) * 0x1.0p-53;
}

double Random::uniform(double from, double to) {
  return from + (to - from) * uniform();
}

std::size_t Random::below(std::size_t count) {
  assert(count > 0);
  return static_cast<std::size_t>(uniform() * static_cast<double>(count));
}

double Random::normal() { // Box and Muller
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

Eigen::Vector3d Random::direction() {
  const double z = uniform(-1, 1);
  const double angle = uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

} // namespace espalier
