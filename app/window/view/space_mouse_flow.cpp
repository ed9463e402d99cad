#include "app/window/view/space_mouse_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "ui/view/plant_view.h"
#include "ui/view/space_mouse.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>

namespace espalier {
namespace {

/// Or a panel of it that floats; but no dialog.
bool isActive(const QWidget& window) {
  const QWidget* active = QApplication::activeWindow();
  return active == &window ||
         (qobject_cast<const QDockWidget*>(active) != nullptr && active->parentWidget() == &window);
}

} // namespace

SpaceMouseFlow::SpaceMouseFlow(const Parts& parts) : parts_(parts), mouse_(new SpaceMouse(this)) {
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, mouse_,
          [this](Qt::ApplicationState state) {
            if (state == Qt::ApplicationActive) mouse_->connectToDriver();
          });
  connect(mouse_, &SpaceMouse::steered, this, [this](const Steering& by) {
    if (isActive(parts_.window)) parts_.editing.activeView().steer(by);
  });
  connect(mouse_, &SpaceMouse::pressed, this, [this](int button) {
    if (button > 1 || !isActive(parts_.window)) return;
    parts_.actions[button == 0 ? "frame_all" : "frame"]->trigger();
  });
}

} // namespace espalier
