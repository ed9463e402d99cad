#include "core/surface/envelopes/alpha_hull.h"

#include "core/base/delaunay.h"
#include "core/base/shown_message.h"

#include <numeric>
#include <tuple>

namespace espalier {
namespace {

constexpr Eigen::Index mostPlaces = 50'000;

/// Of each cube of this side the point farthest from the middle of all.
std::vector<Eigen::Index> outermost(const Eigen::Matrix3Xd& points, double side,
                                    const Progress& progress) {
  const Eigen::Vector3d low = points.rowwise().minCoeff();
  const Eigen::Vector3d middle = (low + points.rowwise().maxCoeff()) / 2;
  using Entry = std::tuple<std::array<int, 3>, double, Eigen::Index>; // cube, -distance, point
  std::vector<Entry> entries;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Array3d cube = ((points.col(i) - low) / side).array().floor();
    entries.emplace_back(std::array{static_cast<int>(cube.x()), static_cast<int>(cube.y()),
                                    static_cast<int>(cube.z())},
                         -(points.col(i) - middle).squaredNorm(), i);
  }
  progress.check();
  std::ranges::sort(entries);
  progress.check();
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (i == 0 || std::get<0>(entries[i]) != std::get<0>(entries[i - 1]))
      kept.push_back(std::get<2>(entries[i]));
  std::ranges::sort(kept);
  return kept;
}

struct Thinned {
  Eigen::Matrix3Xd points;
  double cube = 0; // [L]
};

Thinned thinned(const Eigen::Matrix3Xd& points, const Progress& progress) {
  if (points.cols() <= mostPlaces) return {.points = points};
  const Eigen::Vector3d size = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  Thinned result{.points = points, .cube = size.maxCoeff() / 512};
  while (result.points.cols() > mostPlaces) {
    result.points = points(Eigen::all, outermost(points, result.cube, progress));
    result.cube *= 1.25;
  }
  result.cube /= 1.25;
  return result;
}

/// Which tetrahedra are of the body.
class Body {
public:
  Body(const std::vector<Tetrahedron>& all, double radius) : all_(all), isIn_(all.size()) {
    for (std::size_t i = 0; i < all.size(); ++i)
      isIn_[i] = all[i].radius <= radius;
  }

  /// Those others join it that none leads out of.
  void fillHollows() {
    std::vector<bool> isOutside(all_.size());
    std::vector<std::size_t> found;
    const auto reach = [&](std::size_t i) {
      if (isIn_[i] || isOutside[i]) return;
      isOutside[i] = true;
      found.push_back(i);
    };
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (std::ranges::count(all_[i].neighbors, -1) > 0) reach(i);
    while (!found.empty()) {
      const std::size_t at = found.back();
      found.pop_back();
      for (const int neighbor : all_[at].neighbors)
        if (neighbor >= 0) reach(static_cast<std::size_t>(neighbor));
    }
    for (std::size_t i = 0; i < all_.size(); ++i)
      isIn_[i] = !isOutside[i];
  }

  /// Parts that are joined across sides.
  [[nodiscard]] int pieces() const {
    std::vector<bool> isFound(all_.size());
    int count = 0;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (!isIn_[i] || isFound[i]) continue;
      ++count;
      std::vector<std::size_t> found = {i};
      isFound[i] = true;
      while (!found.empty()) {
        const std::size_t at = found.back();
        found.pop_back();
        for (const int neighbor : all_[at].neighbors) {
          const auto next = static_cast<std::size_t>(neighbor);
          if (neighbor < 0 || !isIn_[next] || isFound[next]) continue;
          isFound[next] = true;
          found.push_back(next);
        }
      }
    }
    return count;
  }

  /// The sides between it and what is not of it.
  [[nodiscard]] SurfaceMesh surface(const Eigen::Matrix3Xd& points) const {
    SurfaceMesh mesh;
    std::vector<int> cornerOf(static_cast<std::size_t>(points.cols()), -1);
    const auto corner = [&](int point) {
      int& at = cornerOf[static_cast<std::size_t>(point)];
      if (at < 0) {
        at = static_cast<int>(mesh.corners.size());
        mesh.corners.emplace_back(points.col(point));
      }
      return at;
    };
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (!isIn_[i]) continue;
      for (std::size_t side = 0; side < 4; ++side) {
        const int across = all_[i].neighbors[side];
        if (across >= 0 && isIn_[static_cast<std::size_t>(across)]) continue;
        const std::array<int, 3> out = turnedOut(all_[i], side);
        mesh.triangles.push_back({corner(out[0]), corner(out[1]), corner(out[2])});
      }
    }
    return mesh;
  }

private:
  /// The side opposite a corner, counterclockwise as seen from outside: by the order of corners,
  /// since places of flat tetrahedra do not say.
  static std::array<int, 3> turnedOut(const Tetrahedron& each, std::size_t opposite) {
    constexpr std::array<std::array<std::size_t, 3>, 4> sides = {
        {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    const auto& [a, b, c] = sides[opposite];
    return {each.corners[a], each.corners[b], each.corners[c]};
  }

  const std::vector<Tetrahedron>& all_;
  std::vector<bool> isIn_;
};

} // namespace

Envelope alphaHull(const Crown& crown, const AlphaHullOptions& options, const Progress& progress) {
  if (!(options.radius > 0))
    throw ShownError({Shown::tr("the radius of the ball is 0: give one above it")});
  const Thinned places = thinned(crown.points, progress.part(0, 0.1));
  const std::vector<Tetrahedron> all = delaunay(places.points, progress.part(0.1, 0.9));
  progress.check();
  Body body(all, options.radius);
  if (options.fillsHollows) body.fillHollows();
  progress.check();
  SurfaceMesh surface = body.surface(places.points);
  if (surface.triangles.empty())
    throw ShownError({Shown::tr("a ball of this radius goes between all points: there is no body; "
                                "give it a larger radius")});
  Envelope envelope = envelopeOf(std::move(surface));
  using Kind = EnvelopeParameter::Kind;
  envelope.parameters = {
      {"radius", Shown::tr("radius of the ball"), Kind::length, options.radius},
      {"pieces", Shown::tr("pieces"), Kind::number, static_cast<double>(body.pieces())},
      {"points", Shown::tr("points"), Kind::number, static_cast<double>(places.points.cols())},
      {"cube", Shown::tr("side of the cubes"), Kind::length, places.cube}};
  return envelope;
}

} // namespace espalier
