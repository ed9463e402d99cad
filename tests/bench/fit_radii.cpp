// Fits what the errors of fused radii follow from, the numbers in
// core/radius/radius_regression.cpp, on simulated scans, and shows on others how often the true
// radius lies in its interval.
//
//   espalier_fit_radii [--plants N] [--others M] [--first I]
//
// N plants, 120 if it is not said, are fitted on, M, 120, from number I, 121, on are judged by.
// With N 0 the numbers that are in the program are judged. Judged are nodes
// within the true wood or a spacing off it. Each plant weighs as the root of its nodes.
#include "core/base/quantile.h"
#include "core/cloud/spacing_of_places.h"
#include "core/pipeline/cleaned_scan.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline.h"
#include "core/radius/wood_radii.h"
#include "core/skeleton/length_along.h"
#include "tests/bench/judged_radii.h"
#include "tests/bench/simulated_scans.h"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using Features = decltype(featuresOf(RadiusEvidence()));
constexpr auto features = static_cast<Eigen::Index>(std::tuple_size_v<Features>);
constexpr Eigen::Index terms = 1 + 2 * features;

/// A plant whose radii are to be judged.
struct Case {
  bool isSparse = false;
  bool hasFoliage = false;
  double spacing = 0;
  Skeleton skeleton;                          // found, without radii
  std::vector<RadiusEvidence> evidence;       // by id
  std::vector<std::optional<TrueWood>> truth; // by id; none: not judged
  double weight = 1;                          // of a node

  [[nodiscard]] double error(NodeId id) const { // logarithm of true to found
    return std::log(truth[indexOf(id)]->radius / (spacing * evidence[indexOf(id)].radius));
  }
};

std::optional<Case> caseOf(std::uint64_t number) try {
  const ScannedPlant plant = scannedPlant(number);
  const Reconstruction result = Pipeline().run(plant.cloud, {}, {}, "nodes");
  const Eigen::Matrix3Xf points = keptPositions(cleanedScan(plant.cloud, {}).state);
  Case found{.isSparse = plant.pointsPerSegment<60, .hasFoliage = plant.foliage> 0,
             .spacing = pointSpacing(points),
             .skeleton = *result.skeleton,
             .evidence = {},
             .truth = trueWood(*result.skeleton, plant.truth, result.scale.spacing)};
  const AssignedPoints assigned(found.skeleton, points, plant.cloud->origin());
  const WoodMeasurements measured =
      measuredWood(found.skeleton, assigned, {.spacing = found.spacing});
  found.evidence = fusedWood(found.skeleton, assigned, measured, found.spacing);
  const auto judged =
      std::ranges::count_if(found.truth, [](const auto& each) { return each.has_value(); });
  found.weight = 1 / std::sqrt(std::max(1.0, static_cast<double>(judged)));
  return found;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%d: %s\n", static_cast<int>(number), error.what());
  return std::nullopt;
}

std::vector<Case> casesOf(int from, int to) {
  std::vector<Case> cases;
  for (int number = from; number < to; ++number)
    if (auto found = caseOf(static_cast<std::uint64_t>(number))) cases.push_back(std::move(*found));
  return cases;
}

/// What is fitted: a row for each node that is judged.
struct Examples {
  std::vector<Features> values;
  std::vector<double> errors;
  std::vector<double> weights;
};

Examples examplesOf(const std::vector<Case>& cases) {
  Examples examples;
  for (const Case& each : cases)
    for (const NodeId id : each.skeleton.ids()) {
      if (!each.truth[indexOf(id)]) continue;
      examples.values.push_back(featuresOf(each.evidence[indexOf(id)]));
      examples.errors.push_back(each.error(id));
      examples.weights.push_back(each.weight);
    }
  return examples;
}

/// Between which all but two in a hundred examples lie.
Quadratic<features> boundsOf(const Examples& examples) {
  Quadratic<features> bounds;
  for (std::size_t i = 0; i < bounds.least.size(); ++i) {
    std::vector<double> values;
    for (const Features& each : examples.values)
      values.push_back(each[i]);
    std::ranges::sort(values);
    const auto place = [&](double share) {
      return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    bounds.least[i] = place(0.01);
    bounds.most[i] = place(0.99);
  }
  return bounds;
}

Eigen::MatrixXd rowsOf(const Examples& examples, const Quadratic<features>& bounds) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(examples.values.size()), terms);
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    rows(row, 0) = 1;
    for (Eigen::Index i = 0; i < features; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double value = std::clamp(examples.values[static_cast<std::size_t>(row)][k],
                                      bounds.least[k], bounds.most[k]);
      rows(row, 1 + i) = value;
      rows(row, 1 + features + i) = value * value;
    }
  }
  return rows;
}

/// Which `share` of the errors lies below, by quantile regression, with a ridge of 1e-4 on scaled
/// terms.
/// Source: D. R. Hunter, K. Lange, "Quantile regression via an MM algorithm", J. Comput. Graph.
/// Stat. 9, 2000.
Quadratic<features> fitted(const Examples& examples, Eigen::MatrixXd rows,
                           Quadratic<features> bounds, double share) {
  const auto count = static_cast<Eigen::Index>(examples.errors.size());
  const Eigen::VectorXd errors = Eigen::Map<const Eigen::VectorXd>(examples.errors.data(), count);
  Eigen::VectorXd weights = Eigen::Map<const Eigen::VectorXd>(examples.weights.data(), count);
  weights /= weights.mean();
  const Eigen::RowVectorXd scales = rows.cwiseAbs2().colwise().mean().cwiseSqrt();
  rows = rows * scales.cwiseInverse().asDiagonal();
  const Eigen::VectorXd pull = (2 * share - 1) * rows.transpose() * weights;
  Eigen::VectorXd found = Eigen::VectorXd::Zero(terms);
  const double ridge = 1e-4 * static_cast<double>(count);
  for (int step = 0; step < 300; ++step) {
    constexpr double smallest = 0.005; // errors below are as good as none
    const Eigen::VectorXd own =
        weights.array() / ((errors - rows * found).array().abs() + smallest);
    Eigen::MatrixXd curvature = rows.transpose() * own.asDiagonal() * rows;
    curvature.diagonal().array() += ridge;
    const Eigen::VectorXd next =
        curvature.ldlt().solve(rows.transpose() * own.cwiseProduct(errors) + pull);
    const double change = (next - found).cwiseAbs().maxCoeff();
    found = next;
    if (change < 1e-6) break;
  }
  found = found.cwiseQuotient(scales.transpose());
  bounds.constant = found[0];
  for (Eigen::Index i = 0; i < features; ++i) {
    bounds.weights[static_cast<std::size_t>(i)] = found[1 + i];
    bounds.squareWeights[static_cast<std::size_t>(i)] = found[1 + features + i];
  }
  return bounds;
}

RadiusRegression fitted(const Examples& examples) {
  const Quadratic<features> bounds = boundsOf(examples);
  const Eigen::MatrixXd rows = rowsOf(examples, bounds);
  return {.low = fitted(examples, rows, bounds, 0.05),
          .middle = fitted(examples, rows, bounds, 0.5),
          .high = fitted(examples, rows, bounds, 0.95)};
}

void print(const char* name, const std::array<double, features>& values) {
  std::printf("    .%s = {", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.4f", i ? ", " : "", values[i]);
  std::printf("},\n");
}

void print(const char* name, const Quadratic<features>& of) {
  std::printf("%s\n    .constant = %.4f,\n", name, of.constant);
  print("weights", of.weights);
  print("squareWeights", of.squareWeights);
}

/// What a plant shows of its radii.
struct Verdict {
  double before = 0; // median relative error as fused
  double after = 0;  // as corrected
  double held = 0;   // share of the nodes whose interval holds the true radius
  double volume = 0; // logarithm of true to found, of the wood of the nodes that are judged
  double least = 0;  // logarithms of the volume's interval if all radii err together
  double most = 0;
};

Verdict judged(const Case& of, const RadiusRegression& regression) {
  const std::vector<KnownRadius> known =
      knownRadii(of.skeleton, of.evidence, of.spacing, regression);
  std::vector<double> before, after;
  double held = 0, truth = 0, found = 0, least = 0, most = 0;
  for (const NodeId id : of.skeleton.ids()) {
    if (!of.truth[indexOf(id)]) continue;
    const double radius = of.truth[indexOf(id)]->radius;
    const auto& [radiusFound, origin] = known[indexOf(id)];
    before.push_back(std::abs(of.spacing * of.evidence[indexOf(id)].radius / radius - 1));
    after.push_back(std::abs(radiusFound / radius - 1));
    held += radius >= origin.least * radiusFound && radius <= origin.most * radiusFound;
    const double length = edgeLength(of.skeleton, id);
    truth += length * radius * radius;
    found += length * radiusFound * radiusFound;
    least += length * std::pow(origin.least * radiusFound, 2);
    most += length * std::pow(origin.most * radiusFound, 2);
  }
  return {.before = quantile(before, 0.5).value_or(0),
          .after = quantile(after, 0.5).value_or(0),
          .held = held / std::max<double>(1, static_cast<double>(after.size())),
          .volume = std::log(truth / found),
          .least = std::log(least / found),
          .most = std::log(most / found)};
}

void print(const char* name, const std::vector<Verdict>& verdicts) {
  if (verdicts.empty()) return;
  const auto of = [&](auto member) {
    std::vector<double> values(verdicts.size());
    std::ranges::transform(verdicts, values.begin(), member);
    std::ranges::sort(values);
    return values;
  };
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
      sum += value;
    return sum / static_cast<double>(values.size());
  };
  const std::vector<double> held = of(&Verdict::held);
  std::printf(
      "  %-22s %3zu plants: median error %.3f as fused, %.3f corrected; intervals hold %.3f, "
      "median plant %.3f, worst tenth %.3f\n",
      name, verdicts.size(), mean(of(&Verdict::before)), mean(of(&Verdict::after)), mean(held),
      held[held.size() / 2], held[held.size() / 10]);
}

/// How often the interval of the volume holds it, if its logarithms are a share of those that it
/// would have if all radii erred together.
void printVolumes(const std::vector<Verdict>& verdicts) {
  for (const double share : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 1.0}) {
    int held = 0;
    for (const Verdict& each : verdicts)
      held += each.volume >= share * each.least && each.volume <= share * each.most;
    std::printf("  %.1f: %.3f", share,
                static_cast<double>(held) / static_cast<double>(verdicts.size()));
  }
  std::printf("\n");
}

void judge(const char* name, const std::vector<Case>& cases, const RadiusRegression& regression) {
  std::printf("%s\n", name);
  std::vector<Verdict> all, bare, leafy, sparse, dense;
  for (const Case& each : cases) {
    const Verdict verdict = judged(each, regression);
    all.push_back(verdict);
    (each.hasFoliage ? leafy : bare).push_back(verdict);
    (each.isSparse ? sparse : dense).push_back(verdict);
  }
  print("all", all);
  print("bare", bare);
  print("with foliage", leafy);
  print("under 60 points", sparse);
  print("more points", dense);
  std::printf("share of the widest interval of the volume: how many plants it holds\n");
  printVolumes(all);
}

int fitRadii(int plants, int others, int first) {
  if (plants == 0) {
    judge("others", casesOf(first, first + others), fittedRadiusRegression());
    return 0;
  }
  const std::vector<Case> cases = casesOf(1, plants + 1);
  const Examples examples = examplesOf(cases);
  std::printf("%zu nodes of %zu plants\n", examples.errors.size(), cases.size());
  const RadiusRegression regression = fitted(examples);
  print("low", regression.low);
  print("middle", regression.middle);
  print("high", regression.high);
  std::printf("all\n");
  print("least", regression.low.least);
  print("most", regression.low.most);
  judge("these plants", cases, regression);
  judge("others", casesOf(first, first + others), regression);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  int plants = 120, others = 120, first = 121;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    int& value = name == "--plants" ? plants : name == "--others" ? others : first;
    value = std::atoi(argv[i + 1]);
  }
  return espalier::fitRadii(plants, others, first);
}
