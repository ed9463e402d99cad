#include "tests/support/surface_sampler.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/simulate/piece_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr double mostDraws = 1e9;

struct Sample {
  Vector3d place;
  Vector3d normal;
};

/// A place on the side of a frustum, evenly by area.
Sample sampleOf(const EdgeSolid& piece, Random& random) {
  const Vector3d along = piece.to - piece.from;
  const double height = along.norm();
  const Vector3d axis = along / height;
  // The area up to a radius grows with its square.
  const double from = piece.fromRadius;
  const double to = piece.toRadius;
  const double u = random.uniform();
  const double radius = std::sqrt(from * from + u * (to * to - from * from));
  const double share = u * (from + to) / (from + radius);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const Vector3d side = axis.unitOrthogonal();
  const Vector3d out = std::cos(angle) * side + std::sin(angle) * axis.cross(side);
  return {piece.from + share * along + radius * out,
          (out - (to - from) / height * axis).normalized()};
}

/// Sums of the areas of the pieces up to each. Edges without length have no side.
std::vector<double> areaSums(const std::vector<EdgeSolid>& wood) {
  std::vector<double> sums;
  double sum = 0;
  for (const EdgeSolid& piece : wood) {
    if (piece.from != piece.to) sum += piece.lateralArea();
    sums.push_back(sum);
  }
  return sums;
}

void check(const SamplingOptions& options) {
  const bool one = (options.points > 0) != (options.spacing > 0);
  if (!one || options.points < 0 || options.points > 100'000'000 || !(options.spacing >= 0))
    throw Error("sampling: expected either a number of points, up to 10^8, or a spacing above 0");
  if (!(options.noise >= 0) || !std::isfinite(options.noise))
    throw Error("sampling: expected a noise of 0 or more");
}

} // namespace

SimulatedScan sampleSurface(const Skeleton& plant, const SamplingOptions& options,
                            std::uint64_t seed, const Progress& progress) {
  check(options);
  const WoodIndex index(woodOf(plant));
  const std::vector<double> sums = areaSums(index.pieces());
  if (sums.empty() || !(sums.back() > 0))
    throw Error("the plant has no surface: give it edges and radii");
  const double buried = -1e-9 * index.bounds().sizes().maxCoeff();
  const auto wanted = options.points > 0 ? static_cast<std::size_t>(options.points)
                                         : std::numeric_limits<std::size_t>::max();
  // Half of a plant may well be buried, hardly nine tenths of it.
  const double draws = options.points > 0 ? 1e3 * static_cast<double>(options.points)
                                          : sums.back() / (options.spacing * options.spacing);
  if (options.spacing > 0 && draws > mostDraws)
    throw Error("sampling: so small a spacing gives over 10^9 points; try a larger one");

  Random random(seed);
  SimulatedScan result;
  std::vector<Vector3d>& places = result.points.positions;
  for (double draw = 0; draw < draws && places.size() < wanted; ++draw) {
    const auto at = std::upper_bound(sums.begin(), sums.end(), random.uniform() * sums.back());
    const auto piece =
        std::min<std::size_t>(static_cast<std::size_t>(at - sums.begin()), sums.size() - 1);
    const Sample sample = sampleOf(index.pieces()[piece], random);
    if (index.distance(sample.place, 0) < buried) continue;
    places.emplace_back(sample.place + options.noise * random.normal() * sample.normal);
    result.nodes.emplace_back(index.pieces()[piece].node);
    if (places.size() % 4096 == 0)
      progress.update(options.points > 0
                          ? static_cast<double>(places.size()) / static_cast<double>(options.points)
                          : draw / draws);
  }
  progress.update(1);
  return result;
}

} // namespace espalier
