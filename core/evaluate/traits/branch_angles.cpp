#include "core/evaluate/traits/branch_angles.h"

#include "core/evaluate/traits/internodes.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

AngleSummary summaryOf(const std::vector<double>& angles) {
  AngleSummary summary{.count = angles.size()};
  const auto count = static_cast<double>(angles.size());
  for (const double angle : angles)
    summary.mean += angle / count;
  double squares = 0;
  for (const double angle : angles)
    squares += std::pow(angle - summary.mean, 2);
  if (angles.size() > 1) summary.deviation = std::sqrt(squares / (count - 1));
  return summary;
}

} // namespace

BranchAngles branchAngles(const Skeleton& skeleton) {
  constexpr double pi = std::numbers::pi;
  const std::vector<Internode> entries = internodes(skeleton);
  const std::vector<int> orderOf = orders(skeleton);
  std::vector<std::vector<double>> byOrder;
  std::vector<double> divergences;
  BranchAngles angles;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (!node.parent || node.edge != EdgeType::branching) continue;
    const auto order = static_cast<std::size_t>(orderOf[indexOf(id)]);
    if (order > byOrder.size()) byOrder.resize(order);
    const Internode& entry = entries[indexOf(id)];
    if (entry.turn) byOrder[order - 1].push_back(*entry.turn);
    if (!entry.divergence) continue;
    const double divergence = std::min(*entry.divergence, 2 * pi - *entry.divergence);
    divergences.push_back(divergence);
    ++angles.divergences[std::min<std::size_t>(5, static_cast<std::size_t>(divergence / (pi / 6)))];
  }
  for (const std::vector<double>& ofOrder : byOrder)
    angles.byOrder.push_back(summaryOf(ofOrder));
  angles.divergence = summaryOf(divergences);
  return angles;
}

} // namespace espalier
