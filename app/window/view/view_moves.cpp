#include "app/window/view/view_moves.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <functional>
#include <numbers>

namespace espalier {

ViewMoves::ViewMoves(ActionSet& actions, Editing& editing) {
  actions.beginSection(tr("View"));
  const auto add = [&](const char* id, const QString& text, const QString& help,
                       const QKeySequence& keys, std::function<void(Camera&)> move) {
    return actions.add({.id = id, .text = text, .help = help, .keys = keys, .menu = "view/moves"},
                       [&editing, move = std::move(move)] {
                         PlantView& view = editing.activeView();
                         Camera camera = view.camera(); // where a flight ends, if there is one
                         move(camera);
                         view.flyTo(camera);
                       });
  };
  constexpr double angle = std::numbers::pi / 12;
  const QString turns = tr("Turns the plant by 15 degrees");
  const auto addTurn = [&](const char* id, const QString& text, Qt::Key key, double yaw,
                           double pitch) {
    add(id, text, turns, QKeySequence(Qt::ALT | key),
        [yaw, pitch](Camera& camera) { camera.turn(yaw * angle, pitch * angle); });
  };
  addTurn("turn_left", tr("Turn Left"), Qt::Key_Left, 1, 0);
  addTurn("turn_right", tr("Turn Right"), Qt::Key_Right, -1, 0);
  addTurn("turn_up", tr("Turn Up"), Qt::Key_Up, 0, -1);
  addTurn("turn_down", tr("Turn Down"), Qt::Key_Down, 0, 1);
  constexpr double part = 0.2; // of half the height of what is shown
  const QString moves = tr("Moves the plant by a tenth of the height of the view");
  const auto addMove = [&](const char* id, const QString& text, Qt::Key key, double right,
                           double up) {
    add(id, text, moves, QKeySequence(Qt::ALT | Qt::SHIFT | key), [right, up](Camera& camera) {
      const double step = part * camera.halfHeight();
      camera.pan(right * step, up * step);
    });
  };
  addMove("move_left", tr("Move Left"), Qt::Key_Left, -1, 0);
  addMove("move_right", tr("Move Right"), Qt::Key_Right, 1, 0);
  addMove("move_up", tr("Move Up"), Qt::Key_Up, 0, 1);
  addMove("move_down", tr("Move Down"), Qt::Key_Down, 0, -1);
  constexpr double factor = 1.25;
  QAction* closer =
      add("zoom_in", tr("Zoom In"), tr("Shows the middle of the view larger by a quarter"),
          QKeySequence(Qt::CTRL | Qt::Key_Plus),
          [](Camera& camera) { camera.zoom(factor, camera.focus); });
  closer->setShortcuts({closer->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Equal)});
  add("zoom_out", tr("Zoom Out"), tr("Shows the middle of the view smaller by as much"),
      QKeySequence(Qt::CTRL | Qt::Key_Minus),
      [](Camera& camera) { camera.zoom(1 / factor, camera.focus); });
}

} // namespace espalier
