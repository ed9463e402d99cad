#include "core/reconstruct/backward_branches.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr std::size_t reach = 4; // nodes: single edges stray

/// What leaves a node on one side.
struct Arm {
  NodeId first;
  Vector3d direction; // unit, or 0
  double weight;      // 1, less if it is short
};

/// The arms of all nodes within their parts.
class Arms {
public:
  Arms(const Skeleton& skeleton, const std::vector<bool>& isCut)
      : skeleton_(skeleton), isCut_(isCut), ids_(skeleton.ids()), carried_(skeleton.idEnd(), 1),
        whole_(skeleton.idEnd(), 0), arms_(skeleton.idEnd()) {
    for (auto id = ids_.rbegin(); id != ids_.rend(); ++id)
      if (const auto below = lower(*id)) carried_[indexOf(*below)] += carried_[indexOf(*id)];
    for (const NodeId id : ids_) {
      const auto below = lower(id);
      whole_[indexOf(id)] = below ? whole_[indexOf(*below)] : carried_[indexOf(id)];
    }
    for (const NodeId id : ids_)
      for (const NodeId next : neighbors(id))
        arms_[indexOf(id)].push_back(armOf(id, next));
  }

  [[nodiscard]] const std::vector<NodeId>& ids() const { return ids_; }

  /// The parent, if it is of the same part.
  [[nodiscard]] std::optional<NodeId> lower(NodeId id) const {
    return isCut_[indexOf(id)] ? std::nullopt : skeleton_[id].parent;
  }

  /// What points back at a node that is entered from a neighbor.
  [[nodiscard]] double backward(NodeId at, NodeId from) const {
    const std::vector<Arm>& arms = arms_[indexOf(at)];
    const auto entered = std::ranges::find(arms, from, &Arm::first);
    double sum = 0;
    for (const Arm& arm : arms)
      if (arm.first != from)
        sum += arm.weight * std::max(0.0, entered->direction.dot(arm.direction));
    return sum;
  }

  /// What goes on through a node where its part is entered.
  [[nodiscard]] double through(NodeId at) const {
    const std::vector<Arm>& arms = arms_[indexOf(at)];
    double sum = 0;
    for (std::size_t i = 0; i < arms.size(); ++i)
      for (std::size_t j = i + 1; j < arms.size(); ++j)
        sum += std::min(arms[i].weight, arms[j].weight) *
               std::max(0.0, -arms[i].direction.dot(arms[j].direction));
    return sum;
  }

private:
  [[nodiscard]] std::vector<NodeId> neighbors(NodeId id) const {
    std::vector<NodeId> result;
    if (const auto below = lower(id)) result.push_back(*below);
    for (const NodeId child : skeleton_.children(id))
      if (!isCut_[indexOf(child)]) result.push_back(child);
    return result;
  }

  /// Nodes on the side of `next` of the edge between it and `from`.
  [[nodiscard]] std::size_t nodesBeyond(NodeId from, NodeId next) const {
    return skeleton_[next].parent == from ? carried_[indexOf(next)]
                                          : whole_[indexOf(from)] - carried_[indexOf(from)];
  }

  [[nodiscard]] bool isWider(NodeId at, NodeId a, NodeId b) const {
    const std::size_t beyondA = nodesBeyond(at, a);
    const std::size_t beyondB = nodesBeyond(at, b);
    return beyondA != beyondB ? beyondA > beyondB : a < b;
  }

  [[nodiscard]] Arm armOf(NodeId id, NodeId first) const {
    NodeId before = id;
    NodeId at = first;
    for (std::size_t i = 1; i < reach; ++i) {
      std::optional<NodeId> widest;
      for (const NodeId next : neighbors(at))
        if (next != before && (!widest || isWider(at, next, *widest))) widest = next;
      if (!widest) break;
      before = at;
      at = *widest;
    }
    const Vector3d span = skeleton_[at].position - skeleton_[id].position;
    const double length = span.norm();
    const std::size_t nodes = std::min(reach, nodesBeyond(id, first));
    return {first, length > 0 ? Vector3d(span / length) : Vector3d::Zero(),
            static_cast<double>(nodes) / static_cast<double>(reach)};
  }

  const Skeleton& skeleton_;
  const std::vector<bool>& isCut_;
  std::vector<NodeId> ids_;
  std::vector<std::size_t> carried_; // by id: nodes of its part that it carries, with itself
  std::vector<std::size_t> whole_;   // by id: nodes of its part
  std::vector<std::vector<Arm>> arms_;
};

} // namespace

std::vector<double> backwardBranches(const Skeleton& skeleton, const std::vector<bool>& isCut) {
  const Arms arms(skeleton, isCut);
  std::vector<double> sums(skeleton.idEnd(), 0); // of what each node carries, entered from below
  for (auto id = arms.ids().rbegin(); id != arms.ids().rend(); ++id)
    if (const auto below = arms.lower(*id))
      sums[indexOf(*below)] += sums[indexOf(*id)] + arms.backward(*id, *below);
  for (const NodeId id : arms.ids())
    if (const auto below = arms.lower(id)) // entered one node farther up: only these two change
      sums[indexOf(id)] = sums[indexOf(*below)] - arms.through(*below) - arms.backward(id, *below) +
                          arms.through(id) + arms.backward(*below, id);
    else
      sums[indexOf(id)] += arms.through(id);
  return sums;
}

} // namespace espalier
