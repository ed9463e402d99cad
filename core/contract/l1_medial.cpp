#include "core/contract/l1_medial.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/spatial_index.h"
#include "core/contract/medial_branches.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace espalier {
namespace {

/// Fades from 1 to 0.02 at `radius`.
double fading(double squaredDistance, double radius) {
  return std::exp(-squaredDistance / (radius * radius / 4));
}

/// Columns drawn by chance, ascending.
std::vector<Eigen::Index> drawn(Eigen::Index count, const L1MedialOptions& options) {
  std::vector<Eigen::Index> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  const auto wanted = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::ceil(options.sampleShare * static_cast<double>(count))),
      std::min<std::size_t>(all.size(), 20), all.size());
  Random random(options.seed);
  for (std::size_t i = 0; i < wanted; ++i)
    std::swap(all[i], all[i + random.below(all.size() - i)]);
  all.resize(wanted);
  std::ranges::sort(all);
  return all;
}

/// The samples as they move.
class MedialFlow {
public:
  MedialFlow(const Eigen::Matrix3Xf& points, const L1MedialOptions& options,
             const Progress& progress)
      : points_(points), options_(options), index_(points, progress),
        places_(points(Eigen::all, drawn(points.cols(), options))),
        isDone_(static_cast<std::size_t>(places_.cols()), false) {}

  [[nodiscard]] const Eigen::Matrix3Xf& places() const { return places_; }

  /// Moves samples until they rest, then ties those on lines to branches.
  void runStage(double radius, const Progress& progress) {
    weighPoints(radius, progress.part(0, 0.2));
    for (int round = 0; round < options_.roundsPerStage; ++round) {
      const double share = 0.2 + 0.8 * round / options_.roundsPerStage;
      const double shift =
          moveOnce(radius, progress.part(share, share + 0.8 / options_.roundsPerStage));
      if (shift < 0.01 * radius) break;
    }
    markBranches(places_, linesThrough(radius, progress), radius, options_.leastDirection, isDone_,
                 progress);
  }
  [[nodiscard]] bool isFinished() const {
    return std::ranges::all_of(isDone_, [](bool done) { return done; });
  }

private:
  /// Points where many lie weigh less, so that the scanner's density does not pull.
  void weighPoints(double radius, const Progress& progress) {
    weights_.resize(static_cast<std::size_t>(points_.cols()));
    const auto weigh = [&](Eigen::Index i) {
      double density = 0;
      for (const Neighbor& other : index_.within(points_.col(i), static_cast<float>(radius / 2)))
        density += fading(static_cast<double>(other.squaredDistance), radius / 2);
      weights_[static_cast<std::size_t>(i)] = 1 / std::max(density, 1.0);
    };
    parallelFor(points_.cols(), weigh, progress, 64);
  }

  /// The lines of the samples that are free to move.
  [[nodiscard]] std::vector<SampleLine> linesThrough(double radius,
                                                     const Progress& progress) const {
    const SpatialIndex samples(places_, progress);
    std::vector<SampleLine> lines(static_cast<std::size_t>(places_.cols()));
    const auto find = [&](Eigen::Index i) {
      progress.check();
      if (isDone_[static_cast<std::size_t>(i)]) return;
      const auto about = samples.within(places_.col(i), static_cast<float>(radius));
      lines[static_cast<std::size_t>(i)] = lineThrough(i, about, radius);
    };
    parallelFor(places_.cols(), find, {}, 64);
    return lines;
  }

  /// @return the mean distance that a sample moved
  double moveOnce(double radius, const Progress& progress) {
    const SpatialIndex samples(places_, progress);
    Eigen::Matrix3Xf moved = places_;
    const auto move = [&](Eigen::Index i) {
      if (isDone_[static_cast<std::size_t>(i)]) return;
      const auto about = samples.within(places_.col(i), static_cast<float>(radius));
      const double share = lineThrough(i, about, radius).share;
      const Eigen::Vector3d to =
          median(i, radius) + options_.repulsion * share * push(i, about, radius);
      moved.col(i) = to.cast<float>();
    };
    parallelFor(places_.cols(), move, progress, 32);
    const auto free = std::ranges::count(isDone_, false);
    const double total = static_cast<double>((moved - places_).colwise().norm().sum());
    places_ = std::move(moved);
    return free > 0 ? total / static_cast<double>(free) : 0;
  }

  /// The line that the samples about one form, and how much they spread along it.
  [[nodiscard]] SampleLine lineThrough(Eigen::Index sample, const std::vector<Neighbor>& about,
                                       double radius) const {
    const Eigen::Vector3d place = places_.col(sample).cast<double>();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Neighbor& other : about) {
      const Eigen::Vector3d d = places_.col(other.index).cast<double>() - place;
      spread += fading(static_cast<double>(other.squaredDistance), radius) * d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const double sum = solver.eigenvalues().sum();
    if (!(sum > 0)) return {};
    return {.direction = solver.eigenvectors().col(2), .share = solver.eigenvalues()[2] / sum};
  }

  /// One step of Weiszfeld's method towards the median of the points about a sample.
  [[nodiscard]] Eigen::Vector3d median(Eigen::Index sample, double radius) const {
    const double nearest = 1e-3 * radius; // what is nearer is as good as there
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (const Neighbor& point : index_.within(places_.col(sample), static_cast<float>(radius))) {
      const auto squared = static_cast<double>(point.squaredDistance);
      const double weight = weights_[static_cast<std::size_t>(point.index)] *
                            fading(squared, radius) / std::max(std::sqrt(squared), nearest);
      sum += weight * points_.col(point.index).cast<double>();
      total += weight;
    }
    return total > 0 ? Eigen::Vector3d(sum / total) : places_.col(sample).cast<double>();
  }

  /// Away from the other samples, by their means.
  [[nodiscard]] Eigen::Vector3d push(Eigen::Index sample, const std::vector<Neighbor>& about,
                                     double radius) const {
    const double nearest = 1e-3 * radius;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (const Neighbor& other : about) {
      if (other.index == sample) continue;
      const auto squared = static_cast<double>(other.squaredDistance);
      const double weight = fading(squared, radius) / std::max(squared, nearest * nearest);
      sum += weight * (places_.col(sample) - places_.col(other.index)).cast<double>();
      total += weight;
    }
    return total > 0 ? Eigen::Vector3d(sum / total) : Eigen::Vector3d::Zero();
  }

  const Eigen::Matrix3Xf& points_;
  const L1MedialOptions& options_;
  SpatialIndex index_; // of the points
  Eigen::Matrix3Xf places_;
  std::vector<bool> isDone_; // by sample: part of a branch
  std::vector<double> weights_;
};

} // namespace

Eigen::Matrix3Xf contractedToL1Medial(const Eigen::Matrix3Xf& points,
                                      const L1MedialOptions& options, const Progress& progress) {
  if (points.cols() < 2) return points;
  MedialFlow flow(points, options, progress);
  const Eigen::Matrix3Xf start = flow.places();
  const double step = options.firstRadius / 2;
  const int stages = 1 + static_cast<int>((options.lastRadius - options.firstRadius) / step + 1e-6);
  for (int stage = 0; stage < stages && !flow.isFinished(); ++stage)
    flow.runStage(options.firstRadius + stage * step,
                  progress.part(0.95 * stage / stages, 0.95 * (stage + 1) / stages));
  Eigen::Matrix3Xf result = carriedAlong(points, start, flow.places(), progress.part(0.95, 1));
  progress.update(1);
  return result;
}

} // namespace espalier
