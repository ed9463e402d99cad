#include "ui/view/focus.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace espalier {
namespace {

/// The axis a node is on, and those that bear it down to the root.
void addBranch(const Skeleton& skeleton, NodeId id, std::unordered_set<NodeId>& branch) {
  for (std::optional<NodeId> at = id; at && !branch.contains(*at);) {
    const Axis axis = axisThrough(skeleton, *at);
    branch.insert(axis.begin(), axis.end());
    at = skeleton[axis.front()].parent;
  }
}

} // namespace

Focus focusOn(const Skeleton& skeleton, const Sight& sight) {
  Focus focus;
  std::unordered_set<NodeId> branch;
  for (const NodeId id : sight.nodes) {
    if (!skeleton.contains(id)) continue;
    focus.box.extend(skeleton[id].position);
    addBranch(skeleton, id, branch);
  }
  for (const Eigen::Vector3d& place : sight.places)
    focus.box.extend(place);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(sight.margin / 2);
  focus.box = {focus.box.min() - margin, focus.box.max() + margin};
  focus.branch.assign(branch.begin(), branch.end());
  std::ranges::sort(focus.branch);
  return focus;
}

FocusDepths::FocusDepths(const Focus& focus, double strength, const Camera& camera) {
  const double middle = camera.forward().dot(focus.box.center() - camera.eye());
  const double half = camera.forward().cwiseAbs().dot(focus.box.sizes()) / 2;
  nearest_ = middle - half;
  farthest_ = middle + half;
  const double across = focus.box.diagonal().norm();
  reach_ = std::max(across / 2, 1e-30);
  const double depth = std::max(middle, 1e-30);
  const double shown = camera.projection == Projection::perspective // at that depth
                           ? 2 * camera.halfHeight() * depth / camera.distance
                           : 2 * camera.halfHeight();
  const Eigen::Vector3d beside = focus.box.center() - camera.eye() - middle * camera.forward();
  const bool isPerspective = camera.projection == Projection::perspective;
  constexpr double widest = 1.5; // heights of the screen from its middle
  if ((isPerspective && middle <= 0) || beside.norm() > widest * shown + across) return;
  constexpr double least = 1 / 12.0, whole = 1 / 5.0; // of the height of the screen
  const double share = across / shown;
  strength_ = strength * std::clamp((share - least) / (whole - least), 0.0, 1.0);
}

double FocusDepths::outOfFocus(double depth) const {
  const double off = std::clamp(std::max(nearest_ - depth, depth - farthest_) / reach_, 0.0, 1.0);
  return strength_ * off * off * (3 - 2 * off);
}

Eigen::Vector4f FocusDepths::forShaders() const {
  return Eigen::Vector4d(nearest_, farthest_, reach_, strength_).cast<float>();
}

} // namespace espalier
