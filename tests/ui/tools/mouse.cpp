#include "tests/ui/tools/mouse.h"

namespace espalier::test {

bool Mouse::press(const Pick& pick, const Eigen::Vector2d& at, Qt::KeyboardModifiers modifiers,
                  Qt::MouseButton button) {
  at_ = at;
  button_ = button;
  modifiers_ = modifiers;
  return tool_.handle(input(ToolInput::Phase::press, pick));
}

bool Mouse::hover(const Pick& pick, const Eigen::Vector2d& at) {
  at_ = at;
  return tool_.handle(input(ToolInput::Phase::hover, pick));
}

bool Mouse::drag(const Eigen::Vector2d& at, const Pick& pick) {
  at_ = at;
  return tool_.handle(input(ToolInput::Phase::drag, pick));
}

bool Mouse::release(const Pick& pick) {
  return tool_.handle(input(ToolInput::Phase::release, pick));
}

bool Mouse::escape() {
  return tool_.handle(input(ToolInput::Phase::cancel, {}));
}

bool Mouse::click(const Pick& pick, const Eigen::Vector2d& at, Qt::KeyboardModifiers modifiers) {
  const bool taken = press(pick, at, modifiers);
  release(pick);
  return taken;
}

ToolInput Mouse::input(ToolInput::Phase phase, const Pick& pick) const {
  return {.phase = phase,
          .ray = {Eigen::Vector3d(at_.x(), -10, at_.y()), Eigen::Vector3d::UnitY()},
          .viewDirection = Eigen::Vector3d::UnitY(),
          .pick = pick,
          .button = button_,
          .modifiers = modifiers_,
          .screen = QPointF(100 * at_.x(), -100 * at_.y())};
}

Pick onNode(NodeId id) {
  return {.node = id};
}

Pick onEdge(const Skeleton& plant, NodeId child, double fraction) {
  const Eigen::Vector3d from = plant[*plant[child].parent].position;
  const Eigen::Vector3d to = plant[child].position;
  return {.edge = EdgePick{child, fraction, from + fraction * (to - from)}};
}

Pick onPoint(const Eigen::Vector3d& place) {
  return {.point = place, .pointOfThing = place};
}

} // namespace espalier::test
