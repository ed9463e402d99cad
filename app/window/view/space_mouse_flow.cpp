#include "app/window/view/space_mouse_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "ui/view/plant_view.h"
#include "ui/view/space_mouse.h"

#include <QAction>
#include <QGuiApplication>
#include <QWidget>

namespace espalier {

SpaceMouseFlow::SpaceMouseFlow(const Parts& parts) : parts_(parts), mouse_(new SpaceMouse(this)) {
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, mouse_,
          [this](Qt::ApplicationState state) {
            if (state == Qt::ApplicationActive) mouse_->connectToDriver();
          });
  connect(mouse_, &SpaceMouse::steered, this, [this](const Steering& by) {
    if (parts_.window.isActiveWindow()) parts_.editing.activeView().steer(by);
  });
  connect(mouse_, &SpaceMouse::pressed, this, [this](int button) {
    if (button > 1 || !parts_.window.isActiveWindow()) return;
    parts_.actions[button == 0 ? "frame_all" : "frame"]->trigger();
  });
}

} // namespace espalier
