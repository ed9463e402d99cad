#include "core/contract/ring_laplacian.h"

#include "core/base/paced_check.h"
#include "core/base/parallel.h"
#include "core/graph/normals.h"
#include "core/graph/tangent_neighbors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {
namespace {

/// Of the angle at `tip` between the directions to a and b.
double cotangent(const Eigen::Vector3d& tip, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double across = (a - tip).cross(b - tip).norm();
  const double along = (a - tip).dot(b - tip);
  return along / std::max(across, 1e-3 * std::abs(along) + 1e-300);
}

Neighborhoods ringsOf(const Eigen::Matrix3Xf& points, int neighbors, const Progress& progress) {
  const Neighborhoods near = nearestNeighborhoods(points, neighbors, progress.part(0, 0.5));
  const Eigen::Matrix3Xf across = normals(points, near, progress.part(0.5, 0.75));
  std::vector<std::vector<std::uint32_t>> rings(static_cast<std::size_t>(points.cols()));
  const auto findRing = [&](Eigen::Index i) {
    rings[static_cast<std::size_t>(i)] = voronoiRing(points, i, across.col(i), near.of(i));
  };
  parallelFor(points.cols(), findRing, progress.part(0.75, 1));
  return joinedLists(rings, progress);
}

} // namespace

RingLaplacian::RingLaplacian(const Eigen::Matrix3Xf& points, int neighbors,
                             const Progress& progress)
    : rings_(ringsOf(points, neighbors, progress.part(0, 0.8))) {
  findUses(progress);
  findPattern(progress.part(0.8, 1));
}

void RingLaplacian::findUses(const Progress& progress) {
  PacedCheck pace(progress);
  usesBegin_.assign(rings_.size() + 1, 0);
  for (const std::uint32_t other : rings_.members) {
    pace.after(1);
    if (other != noNeighbor) ++usesBegin_[other + 1];
  }
  std::partial_sum(usesBegin_.begin(), usesBegin_.end(), usesBegin_.begin());
  uses_.resize(usesBegin_.back());
  std::vector<std::size_t> next(usesBegin_.begin(), usesBegin_.end() - 1);
  for (std::uint32_t row = 0; row < rings_.size(); ++row) {
    const auto ring = rings_.of(row);
    pace.after(ring.size());
    for (std::uint32_t k = 0; k < ring.size(); ++k)
      if (ring[k] != noNeighbor) uses_[next[ring[k]]++] = {row, k};
  }
}

void RingLaplacian::findPattern(const Progress& progress) {
  PacedCheck pace(progress);
  // Room for each row with all that is named twice: as lists, freeing them would outlast a stop.
  std::vector<std::size_t> room(rings_.size() + 1, 0);
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const auto point = static_cast<Eigen::Index>(i);
    pace.after(usesOf(point).size());
    room[i + 1] = room[i] + 1 + rings_.of(point).size();
    for (const Use& use : usesOf(point))
      room[i + 1] += 1 + rings_.of(use.row).size();
  }
  Eigen::Array<std::uint32_t, Eigen::Dynamic, 1> columns(static_cast<Eigen::Index>(room.back()));
  std::vector<std::size_t> ends(rings_.size());
  const auto findRow = [&](Eigen::Index i) {
    std::uint32_t* const begin = columns.data() + room[static_cast<std::size_t>(i)];
    std::uint32_t* end = begin;
    const auto addRing = [&](std::uint32_t of) {
      *end++ = of;
      end = std::ranges::remove_copy(rings_.of(of), end, noNeighbor).out;
    };
    addRing(static_cast<std::uint32_t>(i));
    for (const Use& use : usesOf(i))
      addRing(use.row);
    std::sort(begin, end);
    ends[static_cast<std::size_t>(i)] =
        static_cast<std::size_t>(std::unique(begin, end) - columns.data());
  };
  parallelFor(static_cast<Eigen::Index>(ends.size()), findRow, progress);
  pattern_.begin.assign(1, 0);
  for (std::size_t i = 0; i < ends.size(); ++i)
    pattern_.begin.push_back(pattern_.begin.back() + ends[i] - room[i]);
  pattern_.columns.reserve(pattern_.begin.back());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    pace.after(ends[i] - room[i]);
    pattern_.columns.insert(pattern_.columns.end(), columns.data() + room[i],
                            columns.data() + ends[i]);
  }
}

std::vector<double> RingLaplacian::extents(const Eigen::Matrix3Xd& places,
                                           const Progress& progress) const {
  std::vector<double> result(rings_.size(), 0);
  const auto measure = [&](Eigen::Index i) {
    double& extent = result[static_cast<std::size_t>(i)];
    int count = 0;
    for (const std::uint32_t other : rings_.of(i)) {
      if (other == noNeighbor) continue;
      extent += (places.col(other) - places.col(i)).norm();
      ++count;
    }
    if (count > 0) extent /= count;
  };
  parallelFor(places.cols(), measure, progress);
  return result;
}

std::vector<double> RingLaplacian::sizes(const Eigen::Matrix3Xd& places,
                                         const Progress& progress) const {
  std::vector<double> result = extents(places, progress.part(0, 0.5));
  const auto measure = [&](Eigen::Index i) {
    const std::span<const std::uint32_t> ring = rings_.of(i);
    const Eigen::Vector3d place = places.col(i);
    double area = 0;
    int triangles = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::uint32_t next = ring[(k + 1) % ring.size()];
      if (ring[k] == noNeighbor || next == noNeighbor || ring[k] == next) continue;
      area += (places.col(ring[k]) - place).cross(places.col(next) - place).norm() / 2;
      ++triangles;
    }
    if (triangles > 0) result[static_cast<std::size_t>(i)] = std::sqrt(area);
  };
  parallelFor(places.cols(), measure, progress.part(0.5, 1));
  return result;
}

Eigen::VectorXd RingLaplacian::cotangents(const Eigen::Matrix3Xd& places,
                                          const Progress& progress) const {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(rings_.members.size()));
  const auto weigh = [&](Eigen::Index row) {
    const std::span<const std::uint32_t> ring = rings_.of(row);
    double* const own = weights.data() + rings_.begin[static_cast<std::size_t>(row)];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      own[k] = 0;
      if (ring[k] == noNeighbor) continue;
      const Eigen::Vector3d other = places.col(ring[k]);
      double sum = 0; // of the angles that look at the link from the two next to it in the ring
      for (const std::size_t beside : {(k + 1) % ring.size(), (k + ring.size() - 1) % ring.size()})
        if (ring[beside] != noNeighbor && ring[beside] != ring[k])
          sum += cotangent(places.col(ring[beside]), places.col(row), other);
      own[k] = std::clamp(sum, 1e-3, 1e3);
    }
  };
  parallelFor(places.cols(), weigh, progress);
  return weights;
}

Eigen::VectorXd RingLaplacian::normalEquations(const Eigen::Matrix3Xd& places, double weight,
                                               const std::vector<double>& holds,
                                               const Progress& progress) const {
  const Eigen::VectorXd weights = cotangents(places, progress.part(0, 0.3));
  const auto weightsOf = [&](Eigen::Index row) {
    const auto i = static_cast<std::size_t>(row);
    return std::span(weights.data() + rings_.begin[i], weights.data() + rings_.end[i]);
  };
  Eigen::VectorXd values(static_cast<Eigen::Index>(pattern_.columns.size()));
  const auto fillRow = [&](Eigen::Index row) {
    const auto i = static_cast<std::size_t>(row);
    const std::span columns(pattern_.columns.data() + pattern_.begin[i],
                            pattern_.columns.data() + pattern_.begin[i + 1]);
    double* const entries = values.data() + pattern_.begin[i];
    std::fill_n(entries, columns.size(), 0);
    const auto add = [&](std::uint32_t column, double value) {
      entries[std::ranges::lower_bound(columns, column) - columns.begin()] += value;
    };
    // What equation `of` of the Laplacian, in which this unknown has the factor `factor`, adds.
    const auto addEquation = [&](std::uint32_t of, double factor) {
      const std::span<const std::uint32_t> ring = rings_.of(of);
      const std::span<const double> ofRing = weightsOf(of);
      double sum = 0;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (ring[k] == noNeighbor) continue;
        add(ring[k], factor * ofRing[k]);
        sum += ofRing[k];
      }
      add(of, -factor * sum);
    };
    const double squared = weight * weight;
    const std::span<const double> own = weightsOf(row);
    addEquation(static_cast<std::uint32_t>(i),
                -squared * std::accumulate(own.begin(), own.end(), 0.0));
    for (const Use& use : usesOf(row))
      addEquation(use.row, squared * weightsOf(use.row)[use.place]);
    add(static_cast<std::uint32_t>(i), holds[i] * holds[i]);
  };
  parallelFor(places.cols(), fillRow, progress.part(0.3, 1));
  return values;
}

} // namespace espalier
