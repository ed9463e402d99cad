#include "core/evaluate/light/sky.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace espalier {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

Eigen::Vector3d directionTo(double elevation, double azimuth) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

/// Directions by fives around the zenith, and the zenith.
std::vector<SkyDirection> unweighted() {
  struct Ring {
    double elevation, azimuth; // of the first [degrees]
  };
  constexpr Ring rings[] = {{9.23, 12.23},  {9.23, 59.77}, {10.81, 36}, {26.57, 0}, {31.08, 23.27},
                            {31.08, 48.73}, {47.41, 0},    {52.62, 36}, {69.16, 0}};
  std::vector<SkyDirection> sky;
  for (const Ring& ring : rings)
    for (int k = 0; k < 5; ++k) {
      const double elevation = ring.elevation * degree;
      const double azimuth = (ring.azimuth + 72 * k) * degree;
      sky.push_back({elevation, azimuth, 0, directionTo(elevation, azimuth)});
    }
  sky.push_back({pi / 2, 0, 0, Eigen::Vector3d::UnitZ()});
  return sky;
}

std::size_t nearest(const std::vector<SkyDirection>& sky, const Eigen::Vector3d& direction) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < sky.size(); ++i)
    if (sky[i].direction.dot(direction) > sky[best].direction.dot(direction)) best = i;
  return best;
}

std::vector<SkyDirection> weighted() {
  std::vector<SkyDirection> sky = unweighted();
  constexpr int rows = 200;    // of equal height: cells of one row and column are equally large
  constexpr int columns = 720; // a multiple of five: the rings stay alike
  double all = 0;
  for (int row = 0; row < rows; ++row) {
    const double sine = (row + 0.5) / rows; // of the elevation
    const double light = (1 + 2 * sine) * sine;
    for (int column = 0; column < columns; ++column) {
      const double azimuth = (column + 0.5) * 2 * pi / columns;
      sky[nearest(sky, directionTo(std::asin(sine), azimuth))].weight += light;
      all += light;
    }
  }
  for (SkyDirection& each : sky)
    each.weight /= all;
  return sky;
}

} // namespace

const std::vector<SkyDirection>& overcastSky() {
  static const std::vector<SkyDirection> sky = weighted();
  return sky;
}

} // namespace espalier
