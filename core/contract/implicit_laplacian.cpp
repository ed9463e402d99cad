#include "core/contract/implicit_laplacian.h"

#include "core/contract/ring_laplacian.h"

#include <algorithm>
#include <numeric>

namespace espalier {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// How strongly each point holds its place, by what the triangles about it have shrunk.
std::vector<double> holdsOf(const std::vector<double>& sizes, const std::vector<double>& first) {
  constexpr double strongest = 1e4;
  std::vector<double> holds(sizes.size(), 1);
  for (std::size_t i = 0; i < holds.size(); ++i)
    if (first[i] > 0) holds[i] = std::min(first[i] / std::max(sizes[i], 1e-300), strongest);
  return holds;
}

Eigen::MatrixX3d rightSide(const Eigen::Matrix3Xd& places, const std::vector<double>& holds) {
  Eigen::MatrixX3d right(places.cols(), 3);
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const double hold = holds[static_cast<std::size_t>(i)];
    right.row(i) = hold * hold * places.col(i).transpose();
  }
  return right;
}

} // namespace

Eigen::Matrix3Xf contractedByImplicitLaplacian(const Eigen::Matrix3Xf& points,
                                               const ImplicitLaplacianOptions& options,
                                               const Progress& progress) {
  constexpr double greatestWeight = 2048;
  constexpr double diagonalOfAuthors = 1.6;
  if (points.cols() < 3) return points;
  const RingLaplacian laplacian(points, options.neighbors, progress.part(0, 0.1));
  // About their middle, so that no digits are lost.
  const Eigen::Vector3d middle = points.cast<double>().rowwise().mean();
  Eigen::Matrix3Xd places = points.cast<double>().colwise() - middle;
  const std::vector<double> first = laplacian.sizes(places, progress.part(0.1, 0.12));
  const double extent = mean(laplacian.extents(places, progress.part(0.12, 0.13)));
  if (extent == 0) return points;
  double shrunk = mean(first);
  const double diagonal =
      (places.rowwise().maxCoeff() - places.rowwise().minCoeff()).norm() / diagonalOfAuthors;
  double weight = std::min(options.contraction * diagonal / (5 * extent), greatestWeight);

  std::vector<double> holds(first.size(), 1);
  const SymmetricPattern& pattern = laplacian.pattern();
  SparseLdlt solver(pattern, dissectionOrder(pattern, points, progress), progress);
  for (int round = 0; round < options.rounds; ++round) {
    const auto share = [&](double of) { return 0.15 + 0.85 * (round + of) / options.rounds; };
    const Progress setting = progress.part(share(0), share(0.1));
    solver.factor(laplacian.normalEquations(places, weight, holds, setting),
                  progress.part(share(0.1), share(0.95)));
    places = solver.solve(rightSide(places, holds), progress).transpose();
    const std::vector<double> sizes = laplacian.sizes(places, progress.part(share(0.95), share(1)));
    const double now = mean(sizes);
    if (now > 0.99 * shrunk) break;
    shrunk = now;
    holds = holdsOf(sizes, first);
    weight = std::min(options.growth * weight, greatestWeight);
  }
  progress.update(1);
  return (places.colwise() + middle).cast<float>();
}

} // namespace espalier
