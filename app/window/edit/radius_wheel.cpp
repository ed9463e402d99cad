#include "app/window/edit/radius_wheel.h"

#include "app/window/frame/action_set.h"
#include "ui/tools/node_edits.h"

#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace espalier {

RadiusWheel::RadiusWheel(PlantDocument& document, ActionSet& actions, Nodes nodes, QObject* parent)
    : QObject(parent), document_(document), actions_(actions), nodes_(std::move(nodes)) {}

bool RadiusWheel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel) return QObject::eventFilter(watched, event);
  const auto& wheel = static_cast<const QWheelEvent&>(*event);
  if (wheel.modifiers() != Qt::ControlModifier) return false;
  const std::vector<NodeId> nodes = nodes_();
  if (nodes.empty()) return false;
  constexpr double notch = 120; // as Qt gives the angle
  turn(nodes, wheel.angleDelta().y() / notch);
  return true;
}

void RadiusWheel::turn(const std::vector<NodeId>& nodes, double notches) {
  if (!goesOn(nodes)) {
    gesture_ = Gesture::begin();
    turned_ = nodes;
  }
  constexpr double perNotch = 1.05; // as the keys A and Q
  const auto act = [&] {
    scaleRadii(document_, nodes, std::pow(perNotch, notches), gesture_);
    return true;
  };
  actions_.guarded(act, Refusal::atPointer);
}

bool RadiusWheel::goesOn(const std::vector<NodeId>& nodes) const {
  const int last = document_.undoStack().index() - 1;
  return !gesture_.isNone() && nodes == turned_ && last >= 0 &&
         document_.undoStack().command(last)->id() == gesture_.id();
}

} // namespace espalier
