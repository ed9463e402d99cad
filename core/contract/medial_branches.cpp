#include "core/contract/medial_branches.h"

#include "core/base/parallel.h"
#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace espalier {
namespace {

/// Follows rows of samples.
class RowTracer {
public:
  RowTracer(const Eigen::Matrix3Xf& places, const std::vector<SampleLine>& lines, double radius,
            double leastShare, const Progress& progress)
      : places_(places), lines_(lines), index_(places, progress), radius_(radius),
        leastShare_(leastShare) {}

  [[nodiscard]] bool isDirected(Eigen::Index sample) const {
    return lines_[static_cast<std::size_t>(sample)].share >= leastShare_;
  }

  /// The samples that follow `first` towards `direction`, itself not among them.
  /// @param isTaken those that are not to be met; the same again when this returns
  [[nodiscard]] std::vector<Eigen::Index> from(Eigen::Index first, Eigen::Vector3d direction,
                                               std::vector<bool>& isTaken) const {
    std::vector<Eigen::Index> row = {first};
    isTaken[static_cast<std::size_t>(first)] = true;
    while (const std::optional<Eigen::Index> next = nextAfter(row.back(), direction, isTaken)) {
      direction = (places_.col(*next) - places_.col(row.back())).cast<double>().normalized();
      row.push_back(*next);
      isTaken[static_cast<std::size_t>(*next)] = true;
    }
    for (const Eigen::Index met : row)
      isTaken[static_cast<std::size_t>(met)] = false;
    row.erase(row.begin());
    return row;
  }

private:
  /// The nearest one ahead. (Samples at one place, which have none to go to, are passed over.)
  [[nodiscard]] std::optional<Eigen::Index> nextAfter(Eigen::Index at,
                                                      const Eigen::Vector3d& direction,
                                                      const std::vector<bool>& isMet) const {
    constexpr double leastCosine = 0.9;
    std::optional<Neighbor> best;
    for (const Neighbor& other : index_.within(places_.col(at), static_cast<float>(radius_))) {
      if (isMet[static_cast<std::size_t>(other.index)] || !isDirected(other.index)) continue;
      const Eigen::Vector3d toOther = (places_.col(other.index) - places_.col(at)).cast<double>();
      if (!(toOther.dot(direction) > leastCosine * toOther.norm())) continue;
      if (!best || other.squaredDistance < best->squaredDistance ||
          (other.squaredDistance == best->squaredDistance && other.index < best->index))
        best = other;
    }
    return best ? std::optional(best->index) : std::nullopt;
  }

  const Eigen::Matrix3Xf& places_;
  const std::vector<SampleLine>& lines_;
  SpatialIndex index_;
  double radius_;
  double leastShare_;
};

} // namespace

void markBranches(const Eigen::Matrix3Xf& places, const std::vector<SampleLine>& lines,
                  double radius, double leastShare, std::vector<bool>& isDone,
                  const Progress& progress) {
  constexpr std::size_t fewest = 5;
  const RowTracer tracer(places, lines, radius, leastShare, progress);
  std::vector<Eigen::Index> seeds(lines.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  std::ranges::stable_sort(seeds, std::greater<>(), [&](Eigen::Index i) {
    return lines[static_cast<std::size_t>(i)].share;
  });
  for (const Eigen::Index seed : seeds) {
    progress.check();
    if (!tracer.isDirected(seed)) break;
    if (isDone[static_cast<std::size_t>(seed)]) continue;
    const Eigen::Vector3d direction = lines[static_cast<std::size_t>(seed)].direction;
    std::vector<Eigen::Index> row = tracer.from(seed, direction, isDone);
    const std::vector<Eigen::Index> back = tracer.from(seed, -direction, isDone);
    row.insert(row.end(), back.begin(), back.end());
    row.push_back(seed);
    if (row.size() < fewest) continue;
    for (const Eigen::Index sample : row)
      isDone[static_cast<std::size_t>(sample)] = true;
  }
}

Eigen::Matrix3Xf carriedAlong(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& start,
                              const Eigen::Matrix3Xf& end, const Progress& progress) {
  const SpatialIndex index(start, progress);
  Eigen::Matrix3Xf result(3, points.cols());
  const auto carry = [&](Eigen::Index i) {
    const std::vector<Neighbor> near = index.nearest(points.col(i), 3);
    const auto farthest = static_cast<double>(near.back().squaredDistance);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (const Neighbor& sample : near) {
      const double weight =
          farthest > 0 ? 1 / (static_cast<double>(sample.squaredDistance) + 0.01 * farthest) : 1;
      sum += weight * end.col(sample.index).cast<double>();
      total += weight;
    }
    result.col(i) = (sum / total).cast<float>();
  };
  parallelFor(points.cols(), carry, progress);
  return result;
}

} // namespace espalier
