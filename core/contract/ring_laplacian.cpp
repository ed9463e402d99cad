#include "core/contract/ring_laplacian.h"

#include "core/base/parallel.h"
#include "core/graph/neighborhoods.h"
#include "core/graph/normals.h"
#include "core/graph/tangent_neighbors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {
namespace {

/// Of the angle at `tip` between the ways to a and b.
double cotangent(const Eigen::Vector3d& tip, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double across = (a - tip).cross(b - tip).norm();
  const double along = (a - tip).dot(b - tip);
  return along / std::max(across, 1e-3 * std::abs(along) + 1e-300);
}

} // namespace

RingLaplacian::RingLaplacian(const Eigen::Matrix3Xf& points, int neighbors,
                             const Progress& progress)
    : rings_(static_cast<std::size_t>(points.cols())),
      uses_(static_cast<std::size_t>(points.cols())) {
  const Neighborhoods near = nearestNeighborhoods(points, neighbors, progress.part(0, 0.4));
  const Eigen::Matrix3Xf across = normals(points, near, progress.part(0.4, 0.6));
  const auto findRing = [&](Eigen::Index i) {
    rings_[static_cast<std::size_t>(i)] = voronoiRing(points, i, across.col(i), near.of(i));
  };
  parallelFor(points.cols(), findRing, progress.part(0.6, 0.8));
  for (std::uint32_t row = 0; row < rings_.size(); ++row)
    for (std::uint32_t k = 0; k < rings_[row].size(); ++k)
      if (rings_[row][k] != noNeighbor) uses_[rings_[row][k]].push_back({row, k});
  findPattern(progress.part(0.8, 1));
}

void RingLaplacian::findPattern(const Progress& progress) {
  std::vector<std::vector<std::uint32_t>> rows(rings_.size());
  const auto addRing = [&](std::vector<std::uint32_t>& row, std::uint32_t of) {
    row.push_back(of);
    for (const std::uint32_t other : rings_[of])
      if (other != noNeighbor) row.push_back(other);
  };
  const auto findRow = [&](Eigen::Index i) {
    auto& row = rows[static_cast<std::size_t>(i)];
    addRing(row, static_cast<std::uint32_t>(i));
    for (const Use& use : uses_[static_cast<std::size_t>(i)])
      addRing(row, use.row);
    std::ranges::sort(row);
    row.erase(std::unique(row.begin(), row.end()), row.end());
  };
  parallelFor(static_cast<Eigen::Index>(rows.size()), findRow, progress);
  Neighborhoods joined = joinedLists(rows);
  pattern_ = {.begin = std::move(joined.begin), .columns = std::move(joined.members), .values = {}};
}

std::vector<double> RingLaplacian::extents(const Eigen::Matrix3Xd& places) const {
  std::vector<double> result(rings_.size(), 0);
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    int count = 0;
    for (const std::uint32_t other : rings_[i]) {
      if (other == noNeighbor) continue;
      result[i] += (places.col(other) - places.col(static_cast<Eigen::Index>(i))).norm();
      ++count;
    }
    if (count > 0) result[i] /= count;
  }
  return result;
}

std::vector<double> RingLaplacian::sizes(const Eigen::Matrix3Xd& places) const {
  std::vector<double> result = extents(places);
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const std::vector<std::uint32_t>& ring = rings_[i];
    const Eigen::Vector3d place = places.col(static_cast<Eigen::Index>(i));
    double area = 0;
    int triangles = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::uint32_t next = ring[(k + 1) % ring.size()];
      if (ring[k] == noNeighbor || next == noNeighbor || ring[k] == next) continue;
      area += (places.col(ring[k]) - place).cross(places.col(next) - place).norm() / 2;
      ++triangles;
    }
    if (triangles > 0) result[i] = std::sqrt(area);
  }
  return result;
}

std::vector<double> RingLaplacian::cotangents(const Eigen::Matrix3Xd& places,
                                              const Progress& progress) const {
  std::vector<std::size_t> begin(rings_.size() + 1, 0);
  for (std::size_t i = 0; i < rings_.size(); ++i)
    begin[i + 1] = begin[i] + rings_[i].size();
  std::vector<double> weights(begin.back(), 0);
  const auto weigh = [&](Eigen::Index row) {
    const auto i = static_cast<std::size_t>(row);
    const std::vector<std::uint32_t>& ring = rings_[i];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (ring[k] == noNeighbor) continue;
      const Eigen::Vector3d other = places.col(ring[k]);
      double sum = 0; // of the angles that look at the link from the two next to it in the ring
      for (const std::size_t beside : {(k + 1) % ring.size(), (k + ring.size() - 1) % ring.size()})
        if (ring[beside] != noNeighbor && ring[beside] != ring[k])
          sum += cotangent(places.col(ring[beside]), places.col(row), other);
      weights[begin[i] + k] = std::clamp(sum, 1e-3, 1e3);
    }
  };
  parallelFor(static_cast<Eigen::Index>(rings_.size()), weigh, progress);
  return weights;
}

SymmetricMatrix RingLaplacian::normalEquations(const Eigen::Matrix3Xd& places, double weight,
                                               const std::vector<double>& holds,
                                               const Progress& progress) const {
  const std::vector<double> weights = cotangents(places, progress.part(0, 0.3));
  std::vector<std::size_t> begin(rings_.size() + 1, 0);
  for (std::size_t i = 0; i < rings_.size(); ++i)
    begin[i + 1] = begin[i] + rings_[i].size();
  SymmetricMatrix matrix = pattern_;
  matrix.values.assign(matrix.columns.size(), 0);
  const auto fillRow = [&](Eigen::Index row) {
    const auto i = static_cast<std::size_t>(row);
    const auto first = matrix.columns.begin() + static_cast<std::ptrdiff_t>(matrix.begin[i]);
    const auto last = matrix.columns.begin() + static_cast<std::ptrdiff_t>(matrix.begin[i + 1]);
    const auto add = [&](std::uint32_t column, double value) {
      const auto at = std::lower_bound(first, last, column) - matrix.columns.begin();
      matrix.values[static_cast<std::size_t>(at)] += value;
    };
    // What equation `of` of the Laplacian, in which this unknown has the factor `factor`, adds.
    const auto addEquation = [&](std::uint32_t of, double factor) {
      double sum = 0;
      for (std::size_t k = 0; k < rings_[of].size(); ++k) {
        if (rings_[of][k] == noNeighbor) continue;
        add(rings_[of][k], factor * weights[begin[of] + k]);
        sum += weights[begin[of] + k];
      }
      add(of, -factor * sum);
    };
    const double squared = weight * weight;
    const double own =
        std::accumulate(weights.begin() + static_cast<std::ptrdiff_t>(begin[i]),
                        weights.begin() + static_cast<std::ptrdiff_t>(begin[i + 1]), 0.0);
    addEquation(static_cast<std::uint32_t>(i), -squared * own);
    for (const Use& use : uses_[i])
      addEquation(use.row, squared * weights[begin[use.row] + use.place]);
    add(static_cast<std::uint32_t>(i), holds[i] * holds[i]);
  };
  parallelFor(static_cast<Eigen::Index>(rings_.size()), fillRow, progress.part(0.3, 1));
  return matrix;
}

} // namespace espalier
