#include "core/radius/node_count_pipe_model.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

/// Number of nodes that each node carries, itself included, by id.
std::vector<double> carriedNodes(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<double> carried(skeleton.idEnd(), 1);
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (skeleton[*id].parent) carried[indexOf(*skeleton[*id].parent)] += carried[indexOf(*id)];
  return carried;
}

double most(const std::vector<double>& carried, const std::vector<NodeId>& ids) {
  double result = 1;
  for (const NodeId id : ids)
    result = std::max(result, carried[indexOf(id)]);
  return result;
}

double median(std::vector<double> values, double otherwise) {
  if (values.empty()) return otherwise;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

Skeleton withNodeCountPipeRadii(const Skeleton& skeleton, const NodeCountPipeOptions& options) {
  Skeleton result = skeleton;
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<double> carried = carriedNodes(skeleton, ids);
  const double heaviest = most(carried, ids);
  const double exponent =
      heaviest > 1 ? std::log(options.rootRadius / options.apexRadius) / std::log(heaviest) : 0;
  for (const NodeId id : ids)
    result.setRadius(id, options.apexRadius * std::pow(carried[indexOf(id)], exponent));
  return result;
}

NodeCountPipeOptions pipeEndRadii(const Skeleton& skeleton, const std::vector<double>& measured) {
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<double> carried = carriedNodes(skeleton, ids);
  const double heaviest = most(carried, ids);
  std::vector<double> foot;
  std::vector<double> tips;
  std::vector<double> all;
  for (const NodeId id : ids) {
    const double radius = measured[indexOf(id)];
    if (radius <= 0) continue;
    all.push_back(radius);
    if (carried[indexOf(id)] >= heaviest / 2) foot.push_back(radius);
    if (skeleton.children(id).empty()) tips.push_back(radius);
  }
  const double middle = median(all, 1);
  const double apex = std::min(median(foot, middle), median(tips, middle));
  // What was measured about the foot is of nodes that carry less than the root: the law leads on.
  std::vector<double> exponents;
  for (const NodeId id : ids)
    if (measured[indexOf(id)] > 0 && carried[indexOf(id)] >= std::max(2.0, heaviest / 2))
      exponents.push_back(std::log(measured[indexOf(id)] / apex) / std::log(carried[indexOf(id)]));
  const double exponent = std::max(0.0, median(exponents, 0));
  return {.rootRadius = exponents.empty() ? std::max(apex, median(foot, middle))
                                          : apex * std::pow(heaviest, exponent),
          .apexRadius = apex};
}

} // namespace espalier
