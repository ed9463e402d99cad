// The menus and the toolbar: which places they have, in order. What stands at a place, the parts of
// the window say (ActionSet).
#include "app/window/frame/action_set.h"
#include "app/window/frame/icon.h"
#include "app/window/main_window.h"
#include "ui/tools/registry.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace espalier {
namespace {

struct Place {
  QString id;                     // empty: a line
  QString title = {};             // of a menu within, which holds the place
  std::vector<Place> within = {}; // or these places instead
};

struct MenuPlaces {
  QString title;
  std::vector<Place> places;
};

QString tr(const char* text) {
  return MainWindow::tr(text);
}

const Place line;

/// In the View menu, and in one of the toolbar.
Place colorScales() {
  return {"view/color_scales",
          tr("Color Scales"),
          {{"view/point_maps", tr("Colors of Points")},
           {"view/node_maps", tr("Colors of Nodes")},
           line,
           {"view/color_ranges"}}};
}

std::vector<Place> viewPlaces() {
  return {{"view/layers_title"},
          {"view/layers"},
          line,
          {"view/point_colors", tr("Color Points By")},
          {"view/node_colors", tr("Color Nodes By")},
          colorScales(),
          {"view/points"},
          {"view/sizes", tr("Point Size")},
          {"view/projections", tr("Projection")},
          {"view/directions", tr("Look From")},
          {"view/frame_all"},
          {"view/frame"},
          {"view/look"},
          {"view/pivot"},
          line,
          {"view/more"},
          {"view/second", tr("Second View")},
          {"view/saved", tr("Saved Views")},
          {"view/hide"},
          {"view/clipping"},
          {"view/show_all"},
          line,
          {"", tr("Panels"), {{"panels"}, {"panels/evaluation"}, line, {"panels/layout"}}},
          {"view/theme", tr("Theme")}};
}

std::vector<Place> skeletonPlaces() {
  return {{"skeleton/make"},
          {"skeleton/stand", tr("R&oot and Up")},
          {"skeleton/settings", tr("Se&ttings of the Steps")},
          {"",
           tr("Pre&view"),
           {{"preview/live"},
            line,
            {"preview/kept"},
            line,
            {"preview/choices"},
            line,
            {"preview/compare"},
            line,
            {"preview/points"}}},
          line,
          {"skeleton/edits"},
          line,
          {"skeleton/units", tr("&Units")},
          {"skeleton/hulls"}};
}

std::vector<MenuPlaces> menuPlaces() {
  return {{tr("&File"),
           {{"file/new"},
            {"file/open"},
            {"file/recent", tr("Open &Recent")},
            line,
            {"file/reference"},
            line,
            {"file/save"},
            line,
            {"file/export"},
            {"file/project"},
            line,
            {"file/close"}}},
          {tr("&Edit"),
           {{"edit/history"},
            line,
            {"edit/copy"},
            line,
            {"edit/preview"},
            {"edit/leave"},
            line,
            {"edit/tools"},
            line,
            {"edit/snap", tr("S&nap")}}},
          {tr("Se&lect"),
           {{"select/all"}, {"select/findings"}, {"select/through"}, line, {"select/nodes"}}},
          {tr("&View"), viewPlaces()},
          {tr("&Points"), {{"points"}}},
          {tr("&Skeleton"), skeletonPlaces()},
          {tr("R&adius"), {{"radius"}}},
          {tr("Eval&uate"), {{"evaluate"}}},
          {tr("&Review"), {{"review/walk"}, line, {"review/findings"}}},
          {tr("Help"), {{"help"}}}}; // Alt+H is a key of the plant
}

void fill(QMenu& menu, const ActionSet& actions, const std::vector<Place>& places) {
  for (const Place& place : places) {
    if (!place.title.isEmpty()) {
      const std::vector<Place> itself = {{place.id}};
      fill(*menu.addMenu(place.title), actions, place.within.empty() ? itself : place.within);
    } else if (place.id.isEmpty())
      menu.addSeparator();
    else
      actions.fill(menu, place.id);
  }
}

/// Adds actions by id; an empty id is a separator.
void add(QToolBar& bar, const ActionSet& actions, const QStringList& ids) {
  for (const QString& id : ids)
    if (id.isEmpty())
      bar.addSeparator();
    else
      bar.addAction(actions[id]);
}

QToolButton* makeMenuButton(const QString& text, const QString& icon, QMenu* menu) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setIcon(themedIcon(icon));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(menu);
  // It is told nothing of the pointer while the menu is open, and would stay lit.
  QObject::connect(menu, &QMenu::aboutToHide, button, [button] {
    button->setAttribute(Qt::WA_UnderMouse, false);
    button->update();
  });
  return button;
}

QStringList toolIds() {
  QStringList ids;
  for (const ToolEntry& tool : tools())
    ids.append("tool_" + tool.id);
  return ids;
}

} // namespace

void MainWindow::fillMenus() {
  for (const MenuPlaces& menu : menuPlaces())
    fill(*menuBar()->addMenu(menu.title), *actions_, menu.places);
}

void MainWindow::fillToolBar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setIconSize(QSize(20, 20));
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  add(*bar, *actions_, {"open", "save", "", "undo", "redo", ""});
  add(*bar, *actions_, toolIds());
  add(*bar, *actions_, {"", "reconstruct", ""});
  auto* layers = new QMenu(bar);
  fill(*layers, *actions_, {{"view/layers"}});
  bar->addWidget(makeMenuButton(tr("Layers"), "layers", layers));
  auto* colors = new QMenu(bar);
  fill(*colors, *actions_,
       {{"view/point_colors"},
        line,
        {"view/node_colors", tr("Color Nodes By")},
        colorScales(),
        {"view/sizes", tr("Point Size")}});
  bar->addWidget(makeMenuButton(tr("Color By"), "color", colors));
  add(*bar, *actions_, {"frame_all"});
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  add(*bar, *actions_, {"palette", "shortcuts"});
}

void MainWindow::showContextMenu(const QPoint& globalPosition) {
  QMenu menu(this);
  fill(menu, *actions_,
       {{"context/points"}, {"context/nodes"}, {"context/hulls"}, {"context/shown"}});
  menu.exec(globalPosition);
}

} // namespace espalier
