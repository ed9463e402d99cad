#include "core/radius/fused_radii.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace espalier {
namespace {

double inverseSquare(double value) {
  return 1 / (value * value);
}

/// The least squares of numbers on a forest that are drawn to values of their own and to those of
/// their parents.
struct TreeSystem {
  std::vector<double> weight;  // by id, of the pull to its own value
  std::vector<double> pull;    // by id, weight times value
  std::vector<double> tie;     // by id, of the tie to the parent
  std::vector<double> surplus; // by id, of the parent over it that the tie asks for

  explicit TreeSystem(std::size_t size)
      : weight(size, 0), pull(size, 0), tie(size, 0), surplus(size, 0) {}

  /// By id. @param ids parents first
  [[nodiscard]] std::vector<double> solved(const Skeleton& skeleton,
                                           const std::vector<NodeId>& ids) const {
    const std::vector<double> sum = eliminated(skeleton, ids);
    std::vector<double> right = pull;
    for (auto id = ids.rbegin(); id != ids.rend(); ++id)
      if (const auto parent = skeleton[*id].parent) {
        const std::size_t i = indexOf(*id);
        const double share = tie[i] / (sum[i] + tie[i]);
        right[indexOf(*parent)] += share * (right[i] + sum[i] * surplus[i]);
      }
    std::vector<double> values(weight.size(), 0);
    for (const NodeId id : ids) {
      const std::size_t i = indexOf(id);
      const auto parent = skeleton[id].parent;
      values[i] =
          parent ? (right[i] + tie[i] * (values[indexOf(*parent)] - surplus[i])) / (sum[i] + tie[i])
                 : right[i] / sum[i];
    }
    return values;
  }

  /// Standard deviations of the values, by id. @param ids parents first
  [[nodiscard]] std::vector<double> deviations(const Skeleton& skeleton,
                                               const std::vector<NodeId>& ids) const {
    const std::vector<double> sum = eliminated(skeleton, ids);
    std::vector<double> variances(weight.size(), 0);
    for (const NodeId id : ids) {
      const std::size_t i = indexOf(id);
      const auto parent = skeleton[id].parent;
      const double share = parent ? tie[i] / (sum[i] + tie[i]) : 0;
      variances[i] =
          parent ? 1 / (sum[i] + tie[i]) + share * share * variances[indexOf(*parent)] : 1 / sum[i];
    }
    for (double& variance : variances)
      variance = std::sqrt(variance);
    return variances;
  }

private:
  /// The weights, by id, of the pulls to own values once the nodes that each carries are
  /// eliminated.
  [[nodiscard]] std::vector<double> eliminated(const Skeleton& skeleton,
                                               const std::vector<NodeId>& ids) const {
    std::vector<double> sum = weight;
    for (auto id = ids.rbegin(); id != ids.rend(); ++id)
      if (const auto parent = skeleton[*id].parent) {
        const std::size_t i = indexOf(*id);
        sum[indexOf(*parent)] += tie[i] / (sum[i] + tie[i]) * sum[i];
      }
    return sum;
  }
};

/// The system of the differences to the model, but for what holds nodes to their parents' radii.
TreeSystem systemOf(const Skeleton& skeleton, const std::vector<NodeId>& ids,
                    const std::vector<MeasuredRadius>& measured, const std::vector<double>& model,
                    const FusionOptions& options) {
  TreeSystem system(skeleton.idEnd());
  for (const NodeId id : ids) {
    const std::size_t i = indexOf(id);
    system.weight[i] = inverseSquare(options.modelSpread);
    if (measured[i].radius > 0) {
      const double weight = inverseSquare(measured[i].deviation);
      system.weight[i] += weight;
      system.pull[i] = weight * std::log(measured[i].radius / model[i]);
    }
    if (skeleton[id].parent)
      system.tie[i] = inverseSquare(skeleton[id].edge == EdgeType::successor ? options.axisStep
                                                                             : options.branchStep);
  }
  return system;
}

/// `system` with ties for all that is thicker than its parent.
/// @return whether there is any that was not tied before
bool holdToParents(TreeSystem& system, const Skeleton& skeleton, const std::vector<NodeId>& ids,
                   const std::vector<double>& model, const std::vector<double>& values,
                   std::vector<bool>& isTied) {
  constexpr double strength = 1 / (0.02 * 0.02);
  bool isNew = false;
  for (const NodeId id : ids) {
    const auto parent = skeleton[id].parent;
    if (!parent || isTied[indexOf(id)]) continue;
    const std::size_t i = indexOf(id);
    const std::size_t p = indexOf(*parent);
    const double growth = std::log(model[i] / model[p]); // of the model
    if (values[i] + growth <= values[p] + 1e-9) continue;
    isTied[i] = isNew = true;
    const double all = system.tie[i] + strength;
    system.surplus[i] = strength * growth / all; // the other tie asks for 0
    system.tie[i] = all;
  }
  return isNew;
}

/// How much measurements count at each node, in [0, 1], by id.
std::vector<double> sharesOf(TreeSystem system, const Skeleton& skeleton,
                             const std::vector<NodeId>& ids, double modelSpread) {
  for (const NodeId id : ids) {
    const std::size_t i = indexOf(id);
    system.pull[i] = system.weight[i] - inverseSquare(modelSpread);
    system.surplus[i] = 0;
  }
  return system.solved(skeleton, ids);
}

/// `model` without zeros, of which there is no logarithm; none if no radius is known.
std::optional<std::vector<double>> withoutZeros(std::vector<double> model,
                                                const std::vector<NodeId>& ids,
                                                const std::vector<MeasuredRadius>& measured) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double least = none;
  for (const NodeId id : ids)
    for (const double radius : {model[indexOf(id)], measured[indexOf(id)].radius})
      if (radius > 0) least = std::min(least, radius);
  if (least == none) return std::nullopt;
  for (const NodeId id : ids)
    if (!(model[indexOf(id)] > 0)) model[indexOf(id)] = least;
  return model;
}

} // namespace

RadiusSource sourceOf(double share) {
  if (share < 0.25) return RadiusSource::extrapolated;
  return share > 0.75 ? RadiusSource::measured : RadiusSource::corrected;
}

FusedRadii fusedRadii(const Skeleton& skeleton, const std::vector<MeasuredRadius>& measured,
                      const std::vector<double>& given, const FusionOptions& options) {
  const std::vector<NodeId> ids = skeleton.ids();
  const std::size_t size = skeleton.idEnd();
  FusedRadii result{.radii = std::vector<double>(size, 0),
                    .shares = std::vector<double>(size, 0),
                    .deviations = std::vector<double>(size, 0)};
  const std::optional<std::vector<double>> known = withoutZeros(given, ids, measured);
  if (!known) return result;
  const std::vector<double>& model = *known;
  TreeSystem system = systemOf(skeleton, ids, measured, model, options);
  std::vector<double> values = system.solved(skeleton, ids);
  std::vector<bool> isTied(skeleton.idEnd(), false);
  constexpr int rounds = 8;
  for (int i = 0; i < rounds && holdToParents(system, skeleton, ids, model, values, isTied); ++i)
    values = system.solved(skeleton, ids);
  result.shares = sharesOf(system, skeleton, ids, options.modelSpread);
  result.deviations = system.deviations(skeleton, ids);
  for (const NodeId id : ids)
    result.radii[indexOf(id)] = model[indexOf(id)] * std::exp(values[indexOf(id)]);
  result.radii = limitedRadii(skeleton, std::move(result.radii));
  return result;
}

std::vector<double> limitedRadii(const Skeleton& skeleton, std::vector<double> radii,
                                 double branchShare) {
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (!node.parent) continue;
    const double share = node.edge == EdgeType::successor ? 1 : branchShare;
    radii[indexOf(id)] = std::min(radii[indexOf(id)], share * radii[indexOf(*node.parent)]);
  }
  return radii;
}

} // namespace espalier
