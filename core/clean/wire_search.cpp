#include "core/base/parallel.h"
#include "core/base/spatial_index.h"
#include "core/clean/wire.h"
#include "core/cloud/voxels.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// A place whose surroundings are a thin line.
struct LinePlace {
  Eigen::Index place;
  Eigen::Vector3f direction;
};

/// Whether few of the cubes around hold points, as around a line.
bool isSparse(const Voxels& coarse, std::size_t cube) {
  constexpr int most = 9; // of 26
  const Voxels::Place at = coarse.place(cube);
  int found = -1; // itself
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (coarse.find(at + Voxels::Place(dx, dy, dz))) ++found;
  return found <= most;
}

/// The direction of the line around a place, if it is one that does not stand upright.
std::optional<Eigen::Vector3f> lineAround(const SpatialIndex& index, const Eigen::Matrix3Xf& places,
                                          Eigen::Index place, double radius) {
  constexpr double thin = 0.04; // greatest variance across it, of that along it
  constexpr float steepest = 0.85F;
  const std::vector<Neighbor> near = index.within(places.col(place), static_cast<float>(radius));
  if (near.size() < 4) return std::nullopt;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Neighbor& one : near)
    mean += places.col(one.index).cast<double>();
  mean /= static_cast<double>(near.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Neighbor& one : near) {
    const Eigen::Vector3d d = places.col(one.index).cast<double>() - mean;
    spread += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  if (axes.eigenvalues()[1] > thin * axes.eigenvalues()[2]) return std::nullopt;
  const Eigen::Vector3f direction = axes.eigenvectors().col(2).cast<float>();
  if (std::abs(direction.z()) > steepest) return std::nullopt;
  return direction;
}

/// Ends of lines that go on straight from place to place, the longest first.
using Span = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

std::vector<Span> straightLines(const std::vector<LinePlace>& lines, const Eigen::Matrix3Xf& places,
                                double reach, double least, const Progress& progress) {
  Eigen::Matrix3Xf own(3, std::ssize(lines));
  for (std::size_t i = 0; i < lines.size(); ++i)
    own.col(static_cast<Eigen::Index>(i)) = places.col(lines[i].place);
  std::vector<Span> spans;
  if (lines.empty()) return spans;
  const SpatialIndex index(own, progress);
  std::vector<char> isMet(lines.size(), 0);
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (isMet[first]) continue;
    progress.check();
    std::vector<std::size_t> line = {first};
    isMet[first] = 1;
    for (std::size_t next = 0; next < line.size(); ++next) {
      const auto at = static_cast<Eigen::Index>(line[next]);
      const Eigen::Vector3f& direction = lines[line[next]].direction;
      for (const Neighbor& near : index.within(own.col(at), static_cast<float>(reach))) {
        const auto other = static_cast<std::size_t>(near.index);
        const Eigen::Vector3f d = own.col(near.index) - own.col(at);
        if (isMet[other] || std::abs(direction.dot(lines[other].direction)) < 0.95F ||
            std::abs(d.dot(direction)) < 0.8F * d.norm())
          continue;
        isMet[other] = 1;
        line.push_back(other);
      }
    }
    const auto alongFirst = [&](std::size_t i) {
      return own.col(static_cast<Eigen::Index>(i)).dot(lines[first].direction);
    };
    const auto [low, high] = std::ranges::minmax_element(line, {}, alongFirst);
    const Eigen::Vector3d from = own.col(static_cast<Eigen::Index>(*low)).cast<double>();
    const Eigen::Vector3d to = own.col(static_cast<Eigen::Index>(*high)).cast<double>();
    if ((to - from).norm() >= least) spans.emplace_back(from, to);
  }
  std::ranges::stable_sort(spans, std::greater<>(), [](const Span& span) {
    return (span.second - span.first).squaredNorm();
  });
  return spans;
}

/// Whether over half of its length has no points beside it.
bool hangsFree(const Wire& wire, const SpatialIndex& index, const Eigen::Matrix3Xf& places,
               const WireOptions& options) {
  std::vector<Eigen::Index> sampled;
  const std::size_t step = wire.points.size() / 200 + 1;
  for (std::size_t i = 0; i < wire.points.size(); i += step)
    sampled.push_back(wire.points[i]);
  std::size_t free = 0;
  for (const Eigen::Index point : sampled) {
    const auto near = index.within(places.col(point), static_cast<float>(6 * options.width()));
    const auto isBeside = [&](const Neighbor& one) {
      return !std::ranges::binary_search(wire.points, one.index);
    };
    if (4 * std::ranges::count_if(near, isBeside) <= std::ssize(near)) ++free;
  }
  return 2 * free >= sampled.size();
}

bool isTaken(const std::vector<Wire>& wires, const Span& span, double tolerance) {
  const Eigen::Vector3d middle = (span.first + span.second) / 2;
  return std::ranges::any_of(wires, [&](const Wire& wire) {
    const Eigen::Vector3d whole = wire.to - wire.from;
    const double t = std::clamp((middle - wire.from).dot(whole) / whole.squaredNorm(), 0.0, 1.0);
    return (wire.from + t * whole - middle).norm() <= wire.sag + 4 * tolerance &&
           std::abs(whole.normalized().dot((span.second - span.first).normalized())) > 0.8;
  });
}

/// Adds the wires that are not among `wires` yet.
void addWires(std::vector<Wire>& wires, const Eigen::Matrix3Xf& points, const WireOptions& options,
              const Progress& progress) {
  constexpr std::size_t mostTried = 200;
  const Voxels fine(points, 1.5 * options.width(), progress.part(0, 0.3));
  const Eigen::Matrix3Xf places = fine.means(points);
  const double radius = 4 * fine.edge();
  const Voxels coarse(places, radius, progress.part(0.3, 0.4));
  std::vector<Eigen::Index> sparse;
  for (std::size_t cube = 0; cube < coarse.count(); ++cube)
    if (isSparse(coarse, cube))
      sparse.insert(sparse.end(), coarse.members(cube).begin(), coarse.members(cube).end());
  const SpatialIndex index(places, progress);
  std::vector<std::optional<Eigen::Vector3f>> directions(sparse.size());
  parallelFor(
      std::ssize(sparse),
      [&](Eigen::Index i) {
        const auto at = static_cast<std::size_t>(i);
        directions[at] = lineAround(index, places, sparse[at], radius);
      },
      progress.part(0.4, 0.7), 64);
  std::vector<LinePlace> lines;
  for (std::size_t i = 0; i < sparse.size(); ++i)
    if (directions[i]) lines.push_back({sparse[i], *directions[i]});
  const std::vector<Span> spans =
      straightLines(lines, places, 2 * radius, std::max(options.leastLength / 6, radius),
                    progress.part(0.7, 0.75));
  for (std::size_t i = 0; i < std::min(spans.size(), mostTried); ++i) {
    progress.update(0.75 + 0.25 * static_cast<double>(i) / mostTried);
    if (isTaken(wires, spans[i], options.width())) continue;
    const auto found =
        wireBetween(places, spans[i].first, spans[i].second, options, progress.part(0.75, 0.75));
    if (!found || (found->to - found->from).norm() < options.leastLength || found->filled < 0.7 ||
        !hangsFree(*found, index, places, options))
      continue;
    if (auto whole =
            wireBetween(points, found->from, found->to, options, progress.part(0.75, 0.75)))
      wires.push_back(std::move(*whole));
  }
}

} // namespace

std::vector<Wire> wiresIn(const Eigen::Matrix3Xf& points, const WireOptions& options,
                          const Progress& progress) {
  std::vector<Wire> wires;
  if (points.cols() == 0 || options.width() <= 0) return wires;
  // What is thin and near to something else is found with less width than the noise has.
  WireOptions narrower = options;
  for (double from = 0; from < 1; from = (1 + from) / 2) {
    const bool isLast = narrower.noise <= narrower.tolerance;
    addWires(wires, points, narrower, progress.part(from, isLast ? 1 : (1 + from) / 2));
    if (isLast) break;
    narrower.noise = narrower.noise / 2;
  }
  std::ranges::stable_sort(wires, std::greater<>(),
                           [](const Wire& wire) { return wire.points.size(); });
  return wires;
}

} // namespace espalier
