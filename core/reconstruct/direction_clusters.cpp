#include "core/reconstruct/direction_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {
namespace {

using Directions = std::vector<Eigen::Vector3d>;

constexpr std::size_t mostFitted = 120;
constexpr int mostFits = 40;
constexpr double greatestConcentration = 205; // 1 / (4 degrees)^2
constexpr double leastConcentration = 1e-3;
const double narrow = std::cos(30 * std::numbers::pi / 180);

struct Cluster {
  Eigen::Vector3d mean; // unit
  double concentration = 10;
  double weight = 1;

  /// Of the density at the mean, weighted: log(w k / (4 pi sinh k)) + k, which does not overflow.
  [[nodiscard]] double logPeak() const {
    const double k = concentration;
    return std::log(weight) + std::log(k) - std::log(2 * std::numbers::pi) -
           std::log1p(-std::exp(-2 * k));
  }
  /// The logarithm of the density falls from its peak by this.
  [[nodiscard]] double fall(const Eigen::Vector3d& direction) const {
    return concentration * (1 - mean.dot(direction));
  }
};

struct Mixture {
  std::vector<Cluster> clusters;
  double logLikelihood = -std::numeric_limits<double>::infinity();
  double entropy = 0;

  [[nodiscard]] double criterion(std::size_t count) const {
    const auto parameters = static_cast<double>(4 * clusters.size() - 1);
    return -2 * logLikelihood + parameters * std::log(static_cast<double>(count)) + 2 * entropy;
  }
};

/// Each seed as far as can be from those before it.
Mixture spreadSeeds(const Directions& directions, std::size_t first, std::size_t count) {
  Mixture mixture;
  std::vector<double> nearest(directions.size(), -1); // cosine to the nearest seed
  std::size_t next = first;
  for (std::size_t k = 0; k < count; ++k) {
    mixture.clusters.push_back(
        {.mean = directions[next], .weight = 1 / static_cast<double>(count)});
    for (std::size_t i = 0; i < directions.size(); ++i)
      nearest[i] = std::max(nearest[i], directions[i].dot(directions[next]));
    next = static_cast<std::size_t>(std::ranges::min_element(nearest) - nearest.begin());
  }
  return mixture;
}

/// How much each direction belongs to each cluster: a row per direction. Sets the likelihood and
/// the entropy of the mixture.
Eigen::ArrayXXd expected(Mixture& mixture, const Directions& directions) {
  const auto count = static_cast<Eigen::Index>(directions.size());
  Eigen::ArrayXXd shares(count, static_cast<Eigen::Index>(mixture.clusters.size()));
  mixture.logLikelihood = 0;
  mixture.entropy = 0;
  std::vector<double> peaks; // logarithms are slow
  for (const Cluster& cluster : mixture.clusters)
    peaks.push_back(cluster.logPeak());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < shares.cols(); ++k) {
      const auto cluster = static_cast<std::size_t>(k);
      shares(i, k) =
          peaks[cluster] - mixture.clusters[cluster].fall(directions[static_cast<std::size_t>(i)]);
    }
    const double greatest = shares.row(i).maxCoeff();
    shares.row(i) = (shares.row(i) - greatest).exp();
    const double sum = shares.row(i).sum();
    shares.row(i) /= sum;
    mixture.logLikelihood += greatest + std::log(sum);
    for (Eigen::Index k = 0; k < shares.cols(); ++k)
      if (shares(i, k) > 0) mixture.entropy -= shares(i, k) * std::log(shares(i, k));
  }
  return shares;
}

void maximize(Mixture& mixture, const Directions& directions, const Eigen::ArrayXXd& shares) {
  for (Eigen::Index k = 0; k < shares.cols(); ++k) {
    Cluster& cluster = mixture.clusters[static_cast<std::size_t>(k)];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < directions.size(); ++i)
      sum += shares(static_cast<Eigen::Index>(i), k) * directions[i];
    const double all = std::max(shares.col(k).sum(), 1e-9); // an empty cluster fades away
    const double r = std::min(sum.norm() / all, 1.0);
    if (sum.norm() > 0) cluster.mean = sum.normalized();
    const double k3 = r * (3 - r * r) / std::max(1 - r * r, 1e-12);
    cluster.concentration = std::clamp(k3, leastConcentration, greatestConcentration);
    cluster.weight = all / static_cast<double>(directions.size());
  }
}

Mixture fitted(const Directions& directions, std::size_t count, int starts) {
  Mixture best;
  for (int start = 0; start < starts; ++start) {
    const std::size_t first =
        directions.size() * static_cast<std::size_t>(start) / static_cast<std::size_t>(starts);
    Mixture mixture = spreadSeeds(directions, first, count);
    double before = -std::numeric_limits<double>::infinity();
    for (int round = 0; round < mostFits; ++round) {
      const Eigen::ArrayXXd shares = expected(mixture, directions);
      if (mixture.logLikelihood - before < 1e-4) break;
      before = mixture.logLikelihood;
      maximize(mixture, directions, shares);
    }
    (void)expected(mixture, directions);
    if (mixture.logLikelihood > best.logLikelihood) best = std::move(mixture);
    if (count == 1) break; // all starts end the same
  }
  return best;
}

bool areNarrow(const Directions& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = i + 1; j < directions.size(); ++j)
      if (directions[i].dot(directions[j]) < narrow) return false;
  return true;
}

/// As many clusters as the criterion calls for; those that are near each other are one.
std::vector<Cluster> clustersOf(const Directions& directions,
                                const DirectionClusterOptions& options) {
  const auto most = std::min(static_cast<std::size_t>(options.most), directions.size());
  Mixture best = fitted(directions, 1, 1);
  if (areNarrow(directions)) return best.clusters;
  for (std::size_t count = 2; count <= most; ++count) {
    Mixture mixture = fitted(directions, count, options.starts);
    if (mixture.criterion(directions.size()) < best.criterion(directions.size()))
      best = std::move(mixture);
  }
  return best.clusters;
}

} // namespace

std::vector<std::vector<std::size_t>> directionClusters(const Directions& directions,
                                                        const DirectionClusterOptions& options) {
  Directions fit;
  const std::size_t stride = (directions.size() + mostFitted - 1) / mostFitted;
  for (std::size_t i = 0; i < directions.size(); i += stride)
    if (directions[i].squaredNorm() > 0.5) fit.push_back(directions[i]);
  if (fit.empty()) return {};
  const std::vector<Cluster> clusters = clustersOf(fit, options);
  std::vector<std::size_t> groupOf(clusters.size()); // of clusters that are near each other
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    groupOf[k] = k;
    for (std::size_t other = 0; other < k; ++other)
      if (clusters[k].mean.dot(clusters[other].mean) > std::cos(options.mergeAngle)) {
        const std::size_t from = groupOf[k];
        for (std::size_t each = 0; each <= k; ++each)
          if (groupOf[each] == from) groupOf[each] = groupOf[other];
      }
  }
  std::vector<std::vector<std::size_t>> groups(clusters.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i].squaredNorm() <= 0.5) continue;
    const auto better = [&](const Cluster& a, const Cluster& b) {
      return a.logPeak() - a.fall(directions[i]) < b.logPeak() - b.fall(directions[i]);
    };
    const auto place = std::ranges::max_element(clusters, better) - clusters.begin();
    groups[groupOf[static_cast<std::size_t>(place)]].push_back(i);
  }
  std::erase_if(groups, [](const std::vector<std::size_t>& group) { return group.empty(); });
  std::ranges::stable_sort(groups,
                           [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return groups;
}

} // namespace espalier
