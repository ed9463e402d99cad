// Fits the odds of organs, the numbers in core/clean/organ_odds.cpp, on simulated scans, and shows
// on others what is found of each organ, and how much of what is found is right.
//
//   espalier_fit_organs [--plants N] [--others M] [--first I]
//
// N plants, 132 if it is not said, are fitted on, the next M, 66, are judged by. Each plant lends
// up to 2000 of its points. With N 0 the numbers that are in the program are judged, on plants
// from 1001 on.
#include "core/clean/organ_odds.h"
#include "core/graph/find_root.h"
#include "tests/bench/organ_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr std::size_t organs = organCount;

struct Features {
  OrganScan scan;
  PointPyramid pyramid;
  std::vector<OrganFeatures> ofPoint;
};

Features featuresOfScan(std::uint64_t number) {
  OrganScan scanned = organScan(number);
  const Eigen::Matrix3Xf& points = scanned.cloud->positions();
  PointPyramid pyramid = organPyramid(points);
  auto features = organFeatures(pyramid, findRoot(points), pointSpacing(points));
  return {std::move(scanned), std::move(pyramid), std::move(features)};
}

template <std::size_t Count> struct Examples {
  std::vector<std::array<float, Count>> features;
  std::vector<Organ> organs;

  void append(const std::vector<std::array<float, Count>>& ofPoint, const std::vector<Organ>& are) {
    constexpr std::size_t most = 2000; // points of a plant
    const std::size_t step = std::max<std::size_t>(1, ofPoint.size() / most);
    for (std::size_t i = 0; i < ofPoint.size(); i += step) {
      features.push_back(ofPoint[i]);
      organs.push_back(are[i]);
    }
  }
};

/// Bounds between which all but two in a hundred examples lie.
template <std::size_t Count> Quadratic<Count> boundsOf(const Examples<Count>& examples) {
  Quadratic<Count> bounds;
  std::vector<float> values(examples.features.size());
  for (std::size_t k = 0; k < Count; ++k) {
    std::ranges::transform(examples.features, values.begin(),
                           [k](const auto& features) { return features[k]; });
    std::ranges::sort(values);
    bounds.least[k] = static_cast<double>(values[values.size() / 100]);
    bounds.most[k] = static_cast<double>(values[values.size() - 1 - values.size() / 100]);
  }
  return bounds;
}

template <std::size_t Count>
Eigen::MatrixXd rowsOf(const Examples<Count>& examples, const Quadratic<Count>& bounds) {
  constexpr auto count = static_cast<Eigen::Index>(Count);
  Eigen::MatrixXd rows(examples.features.size(), 1 + 2 * count);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    rows(i, 0) = 1;
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double value =
          std::clamp(static_cast<double>(examples.features[static_cast<std::size_t>(i)][at]),
                     bounds.least[at], bounds.most[at]);
      rows(i, 1 + k) = value;
      rows(i, 1 + count + k) = value * value;
    }
  }
  return rows;
}

/// Each organ weighs one, and wood as much as blades and needles together, but no point more than 4
/// times the mean.
Eigen::VectorXd weightsOf(const std::vector<Organ>& are) {
  std::array<double, organs> counts = {};
  for (const Organ organ : are)
    ++counts[static_cast<std::size_t>(organ)];
  Eigen::VectorXd weights(are.size());
  for (std::size_t i = 0; i < are.size(); ++i)
    weights[static_cast<Eigen::Index>(i)] =
        (are[i] == Organ::wood ? 2 : 1) *
        std::min(4.0, static_cast<double>(are.size()) / organs /
                          counts[static_cast<std::size_t>(are[i])]);
  return weights;
}

/// Maximum likelihood by Newton's method, with a ridge of a ten-thousandth on scaled terms.
Eigen::VectorXd fittedTo(const Eigen::MatrixXd& rows, const Eigen::VectorXd& labels,
                         const Eigen::VectorXd& weights) {
  const double ridge = 1e-4 * static_cast<double>(rows.rows());
  Eigen::VectorXd found = Eigen::VectorXd::Zero(rows.cols());
  for (int step = 0; step < 30; ++step) {
    const Eigen::VectorXd said = 1 / (1 + (-(rows * found)).array().exp());
    const Eigen::VectorXd slope =
        rows.transpose() * (weights.array() * (labels - said).array()).matrix() - ridge * found;
    const Eigen::VectorXd spread = weights.array() * said.array() * (1 - said.array());
    Eigen::MatrixXd curvature = rows.transpose() * (spread.asDiagonal() * rows);
    curvature.diagonal().array() += ridge;
    const Eigen::VectorXd change = curvature.ldlt().solve(slope);
    found += change;
    if (change.cwiseAbs().maxCoeff() < 1e-6) break;
  }
  return found;
}

template <std::size_t Count>
std::array<Quadratic<Count>, organs> fitted(const Examples<Count>& examples) {
  const Quadratic<Count> bounds = boundsOf(examples);
  Eigen::MatrixXd rows = rowsOf(examples, bounds);
  const Eigen::VectorXd scales = rows.cwiseAbs2().colwise().mean().cwiseSqrt().transpose();
  rows = rows * scales.cwiseInverse().asDiagonal();
  const Eigen::VectorXd weights = weightsOf(examples.organs);
  std::array<Quadratic<Count>, organs> odds;
  for (std::size_t organ = 0; organ < organs; ++organ) {
    Eigen::VectorXd labels(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      labels[i] = examples.organs[static_cast<std::size_t>(i)] == allOrgans[organ];
    const Eigen::VectorXd found = fittedTo(rows, labels, weights).cwiseQuotient(scales);
    odds[organ] = bounds;
    odds[organ].constant = found[0];
    for (std::size_t k = 0; k < Count; ++k) {
      odds[organ].weights[k] = found[static_cast<Eigen::Index>(1 + k)];
      odds[organ].squareWeights[k] = found[static_cast<Eigen::Index>(1 + Count + k)];
    }
  }
  return odds;
}

template <std::size_t Count> void print(const char* name, const Quadratic<Count>& odds) {
  const auto list = [](const char* member, const auto& values) {
    std::printf("           .%s = {", member);
    for (std::size_t i = 0; i < values.size(); ++i)
      std::printf("%s%.4g", i ? ", " : "", values[i]);
    std::printf("},\n");
  };
  std::printf("          // %s\n          {.constant = %.4g,\n", name, odds.constant);
  list("weights", odds.weights);
  list("squareWeights", odds.squareWeights);
  list("least", odds.least);
  list("most", odds.most);
  std::printf("          },\n");
}

constexpr const char* names[] = {"wood", "petiole", "blade", "needle"};

/// How often each organ was found to be each.
struct Confusion {
  std::array<std::array<double, organs>, organs> counts = {};

  void add(const std::vector<Organ>& are, const std::vector<Organ>& found) {
    for (std::size_t i = 0; i < are.size(); ++i)
      ++counts[static_cast<std::size_t>(are[i])][static_cast<std::size_t>(found[i])];
  }
  [[nodiscard]] double sum(bool isFoliage, bool isFound) const { // of blades and needles
    double all = 0;
    for (std::size_t i = 0; i < organs; ++i)
      for (std::size_t k = 0; k < organs; ++k)
        if ((i >= 2) == isFoliage && (k >= 2) == isFound) all += counts[i][k];
    return all;
  }
  /// Mean of the shares of wood and of foliage that are found as such; of one alone if there is no
  /// other.
  [[nodiscard]] double balanced() const {
    const double wood = sum(false, false) + sum(false, true);
    const double foliage = sum(true, true) + sum(true, false);
    const double ofWood = wood > 0 ? sum(false, false) / wood : 1;
    const double ofFoliage = foliage > 0 ? sum(true, true) / foliage : 1;
    if (wood == 0 || foliage == 0) return std::min(ofWood, ofFoliage);
    return (ofWood + ofFoliage) / 2;
  }
  void print(const std::string& title) const {
    std::printf("%-24s wood/foliage %.3f (of wood %.3f, of foliage %.3f) |", title.c_str(),
                balanced(), sum(false, false) / (sum(false, false) + sum(false, true)),
                sum(true, true) / (sum(true, true) + sum(true, false)));
    for (std::size_t i = 0; i < organs; ++i) {
      double are = 0, found = 0;
      for (std::size_t k = 0; k < organs; ++k) {
        are += counts[i][k];
        found += counts[k][i];
      }
      if (are > 0) std::printf(" %s %.2f/%.2f", names[i], counts[i][i] / are, counts[i][i] / found);
    }
    std::printf("\n");
  }
};

OrganOdds fittedOn(std::uint64_t plants) {
  std::vector<Features> all;
  OrganOdds odds;
  Examples<organFeatureCount> alone;
  for (std::uint64_t number = 1; number <= plants; ++number) {
    all.push_back(featuresOfScan(number));
    alone.append(all.back().ofPoint, all.back().scan.organs);
  }
  odds.alone = fitted(alone);
  Examples<std::tuple_size_v<FeaturesAround>> around;
  for (const Features& one : all)
    around.append(featuresAround(one.pyramid, one.ofPoint, sharesAlone(one.ofPoint, odds)),
                  one.scan.organs);
  odds.around = fitted(around);
  std::printf("%zu points of %zu plants\n      .alone = {{\n", alone.organs.size(), all.size());
  for (std::size_t organ = 0; organ < organs; ++organ)
    print(names[organ], odds.alone[organ]);
  std::printf("      }},\n      .around = {{\n");
  for (std::size_t organ = 0; organ < organs; ++organ)
    print(names[organ], odds.around[organ]);
  std::printf("      }},\n");
  return odds;
}

void judge(const OrganOdds& odds, std::uint64_t first, std::uint64_t end) {
  std::map<std::string, Confusion> byKind;
  std::map<std::string, std::pair<double, int>> balanced; // means over plants
  for (std::uint64_t number = first; number < end; ++number) {
    const Features one = featuresOfScan(number);
    const std::vector<Organ> found = organsBy(odds, one.pyramid, one.ofPoint);
    Confusion its;
    its.add(one.scan.organs, found);
    const std::string dense = one.scan.pointsPerSegment < 60 ? ", sparse" : "";
    its.print(std::to_string(number) + " " + one.scan.kind + dense);
    byKind[one.scan.kind + dense].add(one.scan.organs, found);
    byKind["all" + dense].add(one.scan.organs, found);
    for (const std::string& kind : {one.scan.kind + dense, "all" + dense}) {
      balanced[kind].first += its.balanced();
      ++balanced[kind].second;
    }
  }
  std::printf("recall/precision of points; mean of balanced accuracies of plants\n");
  for (const auto& [kind, its] : byKind) {
    const auto& [sum, count] = balanced[kind];
    its.print(kind + " " + std::to_string(sum / count).substr(0, 5));
  }
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  int plants = 132, others = 66, first = 0;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    int& value = name == "--plants" ? plants : name == "--others" ? others : first;
    value = std::atoi(argv[i + 1]);
  }
  using namespace espalier;
  const OrganOdds odds =
      plants > 0 ? fittedOn(static_cast<std::uint64_t>(plants)) : fittedOrganOdds();
  if (first == 0) first = plants > 0 ? plants + 1 : 1001;
  judge(odds, static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(first + others));
  return 0;
}
