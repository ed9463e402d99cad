#include "core/evaluate/match/comparable.h"

#include "core/base/shown_message.h"

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

/// What may be missing.
struct RefusalTexts {
  const char* noNodes;
  const char* noPlace; // of node %1
  const char* noLength;
};

constexpr RefusalTexts textsOfPlant{
    Shown::tr("the plant has no nodes: choose a structure with positions"),
    Shown::tr("the plant, node %1: its position is not a number: correct or delete the node"),
    Shown::tr("the plant has no length: its nodes are not linked or all lie at one place; choose "
              "another structure")};
constexpr RefusalTexts textsOfReference{
    Shown::tr("the reference has no nodes: choose a structure with positions"),
    Shown::tr("the reference, node %1: its position is not a number: correct or delete the node"),
    Shown::tr("the reference has no length: its nodes are not linked or all lie at one place; "
              "choose another structure")};
constexpr RefusalTexts textsOfNamed{
    Shown::tr("%2 has no nodes: choose a structure with positions"),
    Shown::tr("%2, node %1: its position is not a number: correct or delete the node"),
    Shown::tr("%2 has no length: its nodes are not linked or all lie at one place; choose another "
              "structure")};

void requireComparable(const Skeleton& skeleton, const RefusalTexts& texts,
                       const std::string& name) {
  if (skeleton.isEmpty()) throw ShownError({texts.noNodes, {"", name}});
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].position.allFinite())
      throw ShownError({texts.noPlace, {std::to_string(indexOf(id)), name}});
  if (totalLength(skeleton) == 0) throw ShownError({texts.noLength, {"", name}});
}

} // namespace

void requireComparable(const Skeleton& skeleton, ComparedAs as) {
  requireComparable(skeleton, as == ComparedAs::plant ? textsOfPlant : textsOfReference, "");
}

void requireComparable(const Skeleton& skeleton, const std::string& name) {
  requireComparable(skeleton, textsOfNamed, name);
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
