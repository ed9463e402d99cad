#include "core/skeleton/best_successor.h"

#include "core/skeleton/assemble_axes.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

constexpr AxisOptions byCourse{.sharpestTurn = std::numbers::pi,
                               .carried = 0,
                               .straightness = weighedAxes.straightness,
                               .thickness = weighedAxes.thickness};

/// What is near a node, as a skeleton of its own.
struct Nearby {
  Skeleton skeleton;
  std::vector<double> radii;

  NodeId add(const Node& node, std::optional<NodeId> parent) {
    radii.push_back(node.radius);
    return skeleton.add({.position = node.position, .radius = node.radius, .parent = parent});
  }
};

} // namespace

NodeId bestSuccessor(const Skeleton& skeleton, const std::vector<NodeId>& children) {
  std::vector<NodeId> before = {*skeleton[children.front()].parent};
  while (static_cast<int>(before.size()) <= byCourse.reach && skeleton[before.back()].parent)
    before.push_back(*skeleton[before.back()].parent);
  Nearby near;
  std::optional<NodeId> parent;
  for (auto at = before.rbegin(); at != before.rend(); ++at)
    parent = near.add(skeleton[*at], parent);
  std::vector<NodeId> copies;
  for (const NodeId child : children) {
    std::optional<NodeId> last;
    std::optional<NodeId> at = child;
    for (int i = 0; i < byCourse.reach && at; ++i) {
      last = near.add(skeleton[*at], last ? last : parent);
      if (i == 0) copies.push_back(*last);
      at = stepFrom(skeleton, *at, NodeStep::child);
    }
  }
  const Skeleton axes = withAssembledAxes(near.skeleton, byCourse, near.radii);
  const auto best = std::ranges::find_if(
      copies, [&](NodeId copy) { return axes[copy].edge == EdgeType::successor; });
  return children[static_cast<std::size_t>(best - copies.begin())];
}

} // namespace espalier
