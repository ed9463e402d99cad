// Fits the odds of the kinds of plants, the numbers in core/clean/fitted_kind_odds.cpp, on
// simulated scans, whose organs are found by the program, and shows on others how often each kind
// is taken for each: on plants of all kinds (organ_scans.h), on trees and shrubs as other odds are
// fitted on (simulated_scans.h), and on such with wide noise.
//
//   espalier_fit_kinds [--plants N] [--others M] [--first I]
//
// N plants, 440 if it is not said, from number 3001 on are fitted on, which espalier_fit_organs has
// not seen, N trees and shrubs, and half as many with noise; M, 220, from number I, 5001, on are
// judged by, likewise. With N 0 the numbers that are in the program are judged.
#include "core/clean/organs.h"
#include "core/clean/plant_kind.h"
#include "tests/bench/organ_scans.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr auto count = static_cast<Eigen::Index>(std::tuple_size_v<KindFeatures>);

struct Example {
  KindFeatures features;
  PlantKind kind;
};

PlantKind kindNamed(const std::string& name) {
  if (name.starts_with("bare")) return PlantKind::bareTree;
  if (name.ends_with("needles")) return PlantKind::needleTree;
  if (name.ends_with("in leaf")) return PlantKind::leafyTree;
  return name == "grass" ? PlantKind::grass : PlantKind::herb;
}

Example exampleOf(const PointCloud& cloud, PlantKind kind) {
  const Eigen::Matrix3Xf& points = cloud.positions();
  const double spacing = pointSpacing(points);
  return {kindFeatures(points, organsAmong(points, {}, spacing).ofPoint, spacing), kind};
}

Example exampleOf(const OrganScan& scan) {
  return exampleOf(*scan.cloud, kindNamed(scan.kind));
}

/// @return none of a herb, and of few points
std::optional<Example> exampleOf(const ScannedPlant& plant) {
  const auto is = [&](const char* name) { return plant.name.starts_with(name); };
  if (plant.isLeafy || is("herb") || is("arabidopsis") || plant.cloud->size() < 200)
    return std::nullopt;
  return exampleOf(*plant.cloud, plant.foliage == 0            ? PlantKind::bareTree
                                 : is("conifer") || is("puu3") ? PlantKind::needleTree
                                                               : PlantKind::leafyTree);
}

struct Examples {
  std::vector<Example> ofAllKinds;
  std::vector<Example> trees;
  std::vector<Example> noisy;

  [[nodiscard]] std::vector<Example> all() const {
    std::vector<Example> all = ofAllKinds;
    all.insert(all.end(), trees.begin(), trees.end());
    all.insert(all.end(), noisy.begin(), noisy.end());
    return all;
  }
};

Examples examplesFrom(std::uint64_t first, std::uint64_t plants) {
  Examples examples;
  for (std::uint64_t number = first; number < first + plants; ++number) {
    examples.ofAllKinds.push_back(exampleOf(organScan(number)));
    if (const auto tree = exampleOf(scannedPlant(number))) examples.trees.push_back(*tree);
    if (number >= first + plants / 2) continue;
    if (const auto noisy = exampleOf(noisyPlant(number))) examples.noisy.push_back(*noisy);
  }
  return examples;
}

/// Weights of a logistic regression of `labels`, by Newton's method; small ones are preferred, the
/// scale of each column being one. Each example weighs `weights`.
Eigen::VectorXd fittedTo(const Eigen::MatrixXd& rows, const Eigen::VectorXd& labels,
                         const Eigen::VectorXd& weights) {
  constexpr double ridge = 0.5;
  Eigen::VectorXd found = Eigen::VectorXd::Zero(rows.cols());
  for (int round = 0; round < 60; ++round) {
    const Eigen::ArrayXd probable = 1 / (1 + (-(rows * found).array()).exp());
    const Eigen::VectorXd slope =
        rows.transpose() * (weights.array() * (labels.array() - probable)).matrix() - ridge * found;
    const Eigen::VectorXd spread = (weights.array() * probable * (1 - probable)).matrix();
    Eigen::MatrixXd curvature = rows.transpose() * (spread.asDiagonal() * rows);
    curvature.diagonal().array() += ridge;
    const Eigen::VectorXd change = curvature.ldlt().solve(slope);
    found += change;
    if (change.cwiseAbs().maxCoeff() < 1e-8) break;
  }
  return found;
}

KindOdds fittedOn(const std::vector<Example>& examples) {
  KindOdds odds;
  Eigen::MatrixXd rows(examples.size(), 1 + 2 * count);
  Quadratic<static_cast<std::size_t>(count)> bounds;
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    std::vector<double> values;
    for (const Example& each : examples)
      values.push_back(each.features[at]);
    std::ranges::sort(values);
    bounds.least[at] = values[values.size() / 100];
    bounds.most[at] = values[values.size() - 1 - values.size() / 100];
  }
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    rows(i, 0) = 1;
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double value = std::clamp(examples[static_cast<std::size_t>(i)].features[at],
                                      bounds.least[at], bounds.most[at]);
      rows(i, 1 + k) = value;
      rows(i, 1 + count + k) = value * value;
    }
  }
  const Eigen::VectorXd scales = rows.cwiseAbs2().colwise().mean().cwiseSqrt().transpose();
  rows = rows * scales.cwiseInverse().asDiagonal();
  std::map<PlantKind, double> sizes;
  for (const Example& each : examples)
    ++sizes[each.kind];
  Eigen::VectorXd weights(rows.rows()); // of each kind alike
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    weights[i] = static_cast<double>(examples.size()) / 5 /
                 sizes[examples[static_cast<std::size_t>(i)].kind];
  for (std::size_t kind = 0; kind < odds.size(); ++kind) {
    Eigen::VectorXd labels(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      labels[i] = examples[static_cast<std::size_t>(i)].kind == allPlantKinds[kind];
    const Eigen::VectorXd found = fittedTo(rows, labels, weights).cwiseQuotient(scales);
    odds[kind] = bounds;
    odds[kind].constant = found[0];
    for (Eigen::Index k = 0; k < count; ++k) {
      odds[kind].weights[static_cast<std::size_t>(k)] = found[1 + k];
      odds[kind].squareWeights[static_cast<std::size_t>(k)] = found[1 + count + k];
    }
  }
  return odds;
}

constexpr const char* names[] = {"bare tree", "tree with needles", "tree in leaf", "herb", "grass"};

void print(const KindOdds& odds) {
  const auto list = [](const char* member, const auto& values) {
    std::printf("       .%s = {", member);
    for (std::size_t i = 0; i < values.size(); ++i)
      std::printf("%s%.5g", i ? ", " : "", values[i]);
    std::printf("},\n");
  };
  for (std::size_t kind = 0; kind < odds.size(); ++kind) {
    std::printf("      // %s\n      {.constant = %.5g,\n", names[kind], odds[kind].constant);
    list("weights", odds[kind].weights);
    list("squareWeights", odds[kind].squareWeights);
    list("least", odds[kind].least);
    list("most", odds[kind].most);
    std::printf("      },\n");
  }
}

void judge(const KindOdds& odds, const std::vector<Example>& examples) {
  std::array<std::array<int, allPlantKinds.size()>, allPlantKinds.size()> counts = {};
  int right = 0;
  double sure = 0;
  std::array<std::pair<int, int>, 2> bySureness = {}; // below and from 0.8: all, right
  for (const Example& each : examples) {
    const LikelyKind found = likelyKind(each.features, odds);
    ++counts[static_cast<std::size_t>(each.kind)][static_cast<std::size_t>(found.kind)];
    right += each.kind == found.kind;
    sure += found.probability;
    auto& [all, good] = bySureness[found.probability >= 0.8 ? 1 : 0];
    ++all;
    good += each.kind == found.kind;
  }
  std::printf("%d of %zu right, %.1f expected; from 0.8 on %d of %d, below %d of %d\n", right,
              examples.size(), sure, bySureness[1].second, bySureness[1].first,
              bySureness[0].second, bySureness[0].first);
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    std::printf("%-18s", names[kind]);
    for (const int number : counts[kind])
      std::printf(" %4d", number);
    std::printf("\n");
  }
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  int plants = 440, others = 220, first = 5001;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    int& value = name == "--plants" ? plants : name == "--others" ? others : first;
    value = std::atoi(argv[i + 1]);
  }
  using namespace espalier;
  KindOdds odds = fittedKindOdds();
  if (plants > 0) {
    const std::vector<Example> examples =
        examplesFrom(3001, static_cast<std::uint64_t>(plants)).all();
    odds = fittedOn(examples);
    print(odds);
    std::printf("of those fitted on: ");
    judge(odds, examples);
  }
  const Examples judged =
      examplesFrom(static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(others));
  judge(odds, judged.ofAllKinds);
  judge(odds, judged.trees);
  judge(odds, judged.noisy);
  return 0;
}
