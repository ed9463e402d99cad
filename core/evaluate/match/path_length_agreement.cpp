#include "core/evaluate/match/path_length_agreement.h"

#include "core/base/random.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/even_samples.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace espalier {
namespace {

/// Lengths of paths along a skeleton.
class PathsAlong {
public:
  explicit PathsAlong(const Skeleton& skeleton)
      : skeleton_(skeleton), height_(skeleton.idEnd(), 0), level_(skeleton.idEnd(), 0) {
    for (const NodeId id : skeleton.ids()) {
      const Node& node = skeleton[id];
      if (!node.parent) continue;
      const Node& parent = skeleton[*node.parent];
      height_[indexOf(id)] =
          height_[indexOf(*node.parent)] + (node.position - parent.position).norm();
      level_[indexOf(id)] = level_[indexOf(*node.parent)] + 1;
    }
  }

  /// Between two places, each on the edge from its node to the parent [L]; none if they are on
  /// different trees.
  [[nodiscard]] std::optional<double> between(const EvenSample& a, const EvenSample& b) const {
    const std::optional<NodeId> meet = meetingOf(a.node, b.node);
    if (!meet) return std::nullopt;
    const double heightA = heightOf(a);
    const double heightB = heightOf(b);
    if (*meet == a.node || *meet == b.node) return std::abs(heightA - heightB);
    return heightA + heightB - 2 * height_[indexOf(*meet)];
  }

private:
  [[nodiscard]] double heightOf(const EvenSample& place) const { // along the tree
    return height_[indexOf(place.node)] - (skeleton_[place.node].position - place.position).norm();
  }

  [[nodiscard]] std::optional<NodeId> meetingOf(NodeId a, NodeId b) const {
    while (a != b) {
      NodeId& higher = level_[indexOf(a)] >= level_[indexOf(b)] ? a : b;
      const std::optional<NodeId> parent = skeleton_[higher].parent;
      if (!parent) return std::nullopt;
      higher = *parent;
    }
    return a;
  }

  const Skeleton& skeleton_;
  std::vector<double> height_; // by id, along the tree from the root [L]
  std::vector<int> level_;     // by id: edges to the root
};

double shareOf(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 1;
}

void summarize(PathLengthAgreement& agreed, std::vector<double> errors) {
  agreed.connected = errors.size();
  if (errors.empty()) {
    agreed.withinTenth = agreed.pairs > 0 ? 0 : 1;
    return;
  }
  std::ranges::sort(errors);
  double sum = 0;
  for (const double error : errors)
    sum += error;
  agreed.meanError = sum / static_cast<double>(errors.size());
  agreed.medianError = errors[(errors.size() - 1) / 2];
  const auto within = std::ranges::upper_bound(errors, 0.1) - errors.begin();
  agreed.withinTenth = shareOf(static_cast<std::size_t>(within), agreed.pairs);
}

} // namespace

PathLengthAgreement pathLengthAgreement(const Skeleton& result, const Skeleton& reference,
                                        const PathLengthOptions& options,
                                        const Progress& progress) {
  assert(options.distance > 0 && options.step > 0);
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const PathsAlong found(result);
  const PathsAlong truth(reference);
  const EdgeIndex index(result);
  const std::vector<EvenSample> samples = evenSamples(reference, options.step);
  Random random(options.seed);
  PathLengthAgreement agreed{.distance = options.distance};
  std::vector<double> errors;
  const auto near = [&](const EvenSample& sample) -> std::optional<EvenSample> {
    const auto place = index.nearest(sample.position);
    if (place->distance > options.distance) return std::nullopt;
    return EvenSample{place->node, place->position};
  };
  for (std::size_t k = 0; k < options.pairs; ++k) {
    if (k % 64 == 0) progress.update(static_cast<double>(k) / static_cast<double>(options.pairs));
    const EvenSample& from = samples[random.below(samples.size())];
    const EvenSample& to = samples[random.below(samples.size())];
    const auto trueLength = truth.between(from, to);
    if (!trueLength || *trueLength < options.distance) continue;
    ++agreed.pairs;
    const auto foundFrom = near(from);
    const auto foundTo = near(to);
    if (!foundFrom || !foundTo) continue;
    ++agreed.found;
    if (const auto foundLength = found.between(*foundFrom, *foundTo))
      errors.push_back(std::abs(*foundLength / *trueLength - 1));
  }
  summarize(agreed, std::move(errors));
  return agreed;
}

} // namespace espalier
