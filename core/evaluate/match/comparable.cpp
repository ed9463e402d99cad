#include "core/evaluate/match/comparable.h"

#include "core/base/error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace espalier {
namespace {

std::vector<double> edgeLengths(const Skeleton& skeleton) {
  std::vector<double> lengths;
  lengths.reserve(skeleton.size());
  for (const NodeId id : skeleton.ids())
    if (const Node& node = skeleton[id]; node.parent)
      lengths.push_back((node.position - skeleton[*node.parent].position).norm());
  return lengths;
}

} // namespace

void requireComparable(const Skeleton& skeleton, std::string_view role) {
  const std::string name(role);
  if (skeleton.isEmpty()) throw Error(name + " has no nodes: choose a structure with positions");
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].position.allFinite())
      throw Error(name + ", " + nameOf(id) +
                  ": its position is not a number: correct or delete the node");
  if (totalLength(skeleton) == 0)
    throw Error(name + " has no length: its nodes are not linked or all lie at one place; choose "
                       "another structure");
}

double totalLength(const Skeleton& skeleton) {
  double sum = 0;
  for (const double length : edgeLengths(skeleton))
    sum += length;
  return sum;
}

double medianEdgeLength(const Skeleton& skeleton) {
  std::vector<double> lengths = edgeLengths(skeleton);
  std::erase(lengths, 0.0);
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

} // namespace espalier
