// Fits the odds of links over gaps, the numbers in core/decide/gap_odds.cpp, on simulated scans,
// and shows on others how often links are right of which the odds say so.
//
//   espalier_fit_gaps [--plants N] [--others M]
//
// N plants, 120 if it is not said, are fitted on, the next M, 60, are judged by. A link is right if
// in the truth the wood that it bears is attached to the place it comes from, with hardly any other
// scanned wood between; fragments that no link bears so are passed over. Each plant weighs as the
// root of its fragments.
#include "core/decide/gap_odds.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/pipeline.h"
#include "core/skeleton/edge_index.h"
#include "tests/bench/simulated_scans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr auto features = static_cast<Eigen::Index>(GapOdds().weights.size());
constexpr Eigen::Index terms = 2 * features;

/// The links that may bear one fragment.
struct Choice {
  std::vector<std::array<double, 10>> links;
  std::vector<bool> isRight;
  double weight = 1;
};

/// Where things lie on the plant that was scanned.
class Truth {
public:
  explicit Truth(const Skeleton& plant) : plant_(plant), index_(plant), depths_(plant.idEnd()) {
    for (const NodeId id : plant.ids())
      if (const auto parent = plant[id].parent)
        depths_[indexOf(id)] =
            depths_[indexOf(*parent)] + (plant[id].position - plant[*parent].position).norm();
  }

  struct Place {
    NodeId node;              // above it
    double depth;             // [L], along the plant from its root
    Eigen::Vector3d position; // [L]
  };
  [[nodiscard]] Place placeOf(const Eigen::Vector3d& point) const {
    const auto nearest = index_.nearest(point);
    const NodeId node = nearest->node;
    return {node, depths_[indexOf(node)] - (1 - nearest->share) * lengthBelow(node),
            nearest->position};
  }
  [[nodiscard]] double radiusAt(const Place& place) const { return plant_[place.node].radius; }

  /// How far a point is from the wood between a place and the root [L], and the depth there.
  [[nodiscard]] std::pair<double, double> below(const Place& from,
                                                const Eigen::Vector3d& point) const {
    std::pair<double, double> best((from.position - point).norm(), from.depth);
    Eigen::Vector3d upper = from.position;
    NodeId id = from.node;
    while (const auto parent = plant_[id].parent) {
      const Eigen::Vector3d lower = plant_[*parent].position;
      const Eigen::Vector3d edge = lower - upper;
      const double length = edge.squaredNorm();
      const double share = length > 0 ? std::clamp(edge.dot(point - upper) / length, 0.0, 1.0) : 0;
      const double distance = (upper + share * edge - point).norm();
      if (distance < best.first)
        best = {distance, depths_[indexOf(*parent)] + (1 - share) * edge.norm()};
      upper = lower;
      id = *parent;
    }
    return best;
  }

private:
  [[nodiscard]] double lengthBelow(NodeId id) const {
    const auto parent = plant_[id].parent;
    return parent ? (plant_[id].position - plant_[*parent].position).norm() : 0;
  }

  const Skeleton& plant_;
  EdgeIndex index_;
  std::vector<double> depths_; // by id
};

/// Which links are right; none where that cannot be said.
std::vector<bool> rightOf(const std::vector<const GapLink*>& links, const Skeleton& skeleton,
                          const Truth& truth, double spacing) {
  double lowest = std::numeric_limits<double>::infinity(); // where the fragment may be entered
  for (const GapLink* link : links)
    lowest = std::min(lowest, truth.placeOf(skeleton[link->to].position).depth);
  std::vector<double> lengths; // along the plant, of those that it has
  for (const GapLink* link : links) {
    const auto to = truth.placeOf(skeleton[link->to].position);
    const Eigen::Vector3d from = skeleton[link->from].position;
    const auto [distance, depth] = truth.below(to, from);
    const double near = 3 * spacing + 1.5 * truth.radiusAt(truth.placeOf(from));
    const bool isOn = distance < near && to.depth < lowest + 6 * spacing;
    lengths.push_back(isOn ? to.depth - depth : std::numeric_limits<double>::infinity());
  }
  const double least = *std::ranges::min_element(lengths);
  if (!std::isfinite(least)) return {};
  std::vector<bool> isRight;
  for (const double length : lengths)
    isRight.push_back(std::isfinite(length) && length < 1.2 * least + 4 * spacing);
  return isRight;
}

std::vector<Choice> choicesOf(std::uint64_t number) try {
  const ScannedPlant plant = scannedPlant(number);
  const Reconstruction found = Pipeline().run(plant.cloud, {}, {}, "skeleton");
  const Skeleton& skeleton = *found.skeleton;
  const double spacing = found.scale.spacing;
  GapOptions options;
  options.widest = options.widest.rule().value(found.scale);
  options.reach = options.reach.rule().value(found.scale);
  options.backCost = options.backCost.rule().value(found.scale);
  const Gaps gaps = gapsIn(skeleton, options);
  const Truth truth(plant.truth);
  std::map<std::uint32_t, std::vector<const GapLink*>> byFragment;
  for (const GapLink& link : gaps.links)
    byFragment[link.borne].push_back(&link);
  std::vector<Choice> choices;
  for (const auto& [fragment, links] : byFragment) {
    Choice choice{.links = {}, .isRight = rightOf(links, skeleton, truth, spacing)};
    if (choice.isRight.empty()) continue;
    for (const GapLink* link : links)
      choice.links.push_back(featuresOf(link->evidence, spacing, Eigen::Vector3d::UnitZ()));
    choices.push_back(std::move(choice));
  }
  for (Choice& choice : choices)
    choice.weight = 1 / std::sqrt(static_cast<double>(choices.size()));
  return choices;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%d: %s\n", static_cast<int>(number), error.what());
  return {};
}

std::vector<Choice> choicesOf(std::uint64_t from, std::uint64_t to) {
  std::vector<Choice> all;
  for (std::uint64_t number = from; number < to; ++number)
    std::ranges::move(choicesOf(number), std::back_inserter(all));
  return all;
}

/// Between which all but two in a hundred links lie.
GapOdds boundsOf(const std::vector<Choice>& choices) {
  GapOdds bounds;
  for (std::size_t i = 0; i < bounds.least.size(); ++i) {
    std::vector<double> values;
    for (const Choice& choice : choices)
      for (const auto& link : choice.links)
        values.push_back(link[i]);
    std::ranges::sort(values);
    bounds.least[i] = values[values.size() / 100];
    bounds.most[i] = values[values.size() - 1 - values.size() / 100];
  }
  return bounds;
}

/// Terms of each link, a row each.
Eigen::MatrixXd termsOf(const Choice& choice, const GapOdds& bounds) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(choice.links.size()), terms);
  for (Eigen::Index row = 0; row < rows.rows(); ++row)
    for (Eigen::Index i = 0; i < features; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double value = std::clamp(choice.links[static_cast<std::size_t>(row)][k],
                                      bounds.least[k], bounds.most[k]);
      rows(row, i) = value;
      rows(row, features + i) = value * value;
    }
  return rows;
}

/// Maximum likelihood of a conditional logit by Newton's method, with a ridge on scaled terms.
GapOdds fitted(const std::vector<Choice>& choices) {
  GapOdds odds = boundsOf(choices);
  std::vector<Eigen::MatrixXd> rows;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(terms);
  double count = 0;
  for (const Choice& choice : choices) {
    rows.push_back(termsOf(choice, odds));
    squares += rows.back().cwiseAbs2().colwise().sum().transpose();
    count += static_cast<double>(rows.back().rows());
  }
  const Eigen::VectorXd scales = (squares / count).cwiseSqrt().cwiseMax(1e-9);
  for (Eigen::MatrixXd& some : rows)
    some = some * scales.cwiseInverse().asDiagonal();
  Eigen::VectorXd found = Eigen::VectorXd::Zero(terms);
  for (int step = 0; step < 200; ++step) {
    Eigen::VectorXd slope = -1e-3 * found;
    Eigen::MatrixXd curvature = 1e-3 * Eigen::MatrixXd::Identity(terms, terms);
    for (std::size_t i = 0; i < choices.size(); ++i) {
      Eigen::VectorXd share = rows[i] * found;
      share = (share.array() - share.maxCoeff()).exp();
      share /= share.sum();
      Eigen::VectorXd right = share;
      for (Eigen::Index k = 0; k < right.size(); ++k)
        if (!choices[i].isRight[static_cast<std::size_t>(k)]) right[k] = 0;
      right /= std::max(right.sum(), 1e-12);
      const Eigen::VectorXd mean = rows[i].transpose() * share;
      slope += choices[i].weight * (rows[i].transpose() * right - mean);
      curvature += choices[i].weight *
                   (rows[i].transpose() * share.asDiagonal() * rows[i] - mean * mean.transpose());
    }
    const Eigen::VectorXd change = curvature.ldlt().solve(slope);
    const double largest = change.cwiseAbs().maxCoeff();
    found += change * std::min(1.0, 1 / largest);
    if (largest < 1e-8) break;
  }
  found = found.cwiseQuotient(scales);
  for (Eigen::Index i = 0; i < features; ++i) {
    odds.weights[static_cast<std::size_t>(i)] = found[i];
    odds.squareWeights[static_cast<std::size_t>(i)] = found[features + i];
  }
  return odds;
}

void print(const GapOdds& odds) {
  const auto list = [](const char* name, const auto& values) {
    std::printf("      .%s = {", name);
    for (std::size_t i = 0; i < values.size(); ++i)
      std::printf("%s%.4f", i ? ", " : "", values[i]);
    std::printf("},\n");
  };
  list("weights", odds.weights);
  list("squareWeights", odds.squareWeights);
  list("least", odds.least);
  list("most", odds.most);
}

/// Of the most probable link of each fragment: a reliability diagram as a table, the expected
/// calibration error, and how many are right, beside the cheapest ones.
void printReliability(const std::vector<Choice>& choices, const GapOdds& odds) {
  struct Bin {
    double said = 0, were = 0;
    int count = 0;
  };
  std::array<Bin, 10> bins;
  double right = 0, cheapestRight = 0;
  for (const Choice& choice : choices) {
    std::vector<double> values;
    for (const auto& link : choice.links)
      values.push_back(odds.value(link));
    const auto best = std::ranges::max_element(values);
    const auto place = static_cast<std::size_t>(best - values.begin());
    double sum = 0;
    for (const double value : values)
      sum += std::exp(value - *best);
    const double probability = 1 / sum;
    Bin& bin = bins[std::min<std::size_t>(9, static_cast<std::size_t>(10 * probability))];
    bin.said += probability;
    bin.were += choice.isRight[place];
    ++bin.count;
    right += choice.isRight[place];
    const auto cheapest =
        std::ranges::min_element(choice.links, {}, [](const auto& link) { return link.back(); });
    cheapestRight += choice.isRight[static_cast<std::size_t>(cheapest - choice.links.begin())];
  }
  const auto all = static_cast<double>(choices.size());
  double error = 0;
  std::printf("fragments  said  were\n");
  for (const Bin& bin : bins) {
    if (bin.count == 0) continue;
    std::printf("%9d  %.3f %.3f\n", bin.count, bin.said / bin.count, bin.were / bin.count);
    error += std::abs(bin.said - bin.were) / all;
  }
  std::printf("expected calibration error %.3f; right %.3f, of the cheapest %.3f\n", error,
              right / all, cheapestRight / all);
}

int fitGaps(int plants, int others) {
  const auto count = static_cast<std::uint64_t>(plants);
  const std::vector<Choice> choices = choicesOf(1, count + 1);
  const GapOdds odds = fitted(choices);
  std::printf("%zu fragments\n", choices.size());
  print(odds);
  printReliability(choices, odds);
  std::printf("of others:\n");
  printReliability(choicesOf(count + 1, count + 1 + static_cast<std::uint64_t>(others)), odds);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  int plants = 120, others = 60;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    int& value = name == "--plants" ? plants : others;
    value = std::atoi(argv[i + 1]);
  }
  return espalier::fitGaps(plants, others);
}
