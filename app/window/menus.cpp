// The menus and the toolbar: which places they have, in order. What stands at a place, the parts of
// the window say (ActionSet).
#include "app/window/frame/action_set.h"
#include "app/window/frame/icon.h"
#include "app/window/frame/menu_letters.h"
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

const Place line;

/// In the View menu, and in one of the toolbar.
Place colorScales() {
  return {"view/color_scales",
          MainWindow::tr("Color Scales"),
          {{"view/point_maps", MainWindow::tr("Colors of Points")},
           {"view/node_maps", MainWindow::tr("Colors of Nodes")},
           line,
           {"view/color_ranges"}}};
}

std::vector<Place> viewPlaces() {
  return {
      {"view/layers_title"},
      {"view/layers"},
      line,
      {"view/point_colors", MainWindow::tr("Color Points By")},
      {"view/node_colors", MainWindow::tr("Color Nodes By")},
      colorScales(),
      {"view/points"},
      {"view/sizes", MainWindow::tr("Point Size")},
      {"view/projections", MainWindow::tr("Projection")},
      {"view/directions", MainWindow::tr("Look From")},
      {"view/moves", MainWindow::tr("Turn, Move and Zoom")},
      {"view/frame_all"},
      {"view/frame"},
      {"view/look"},
      {"view/pivot"},
      line,
      {"view/more"},
      {"view/second", MainWindow::tr("Second View")},
      {"view/saved", MainWindow::tr("Saved Views")},
      {"view/hide"},
      {"view/clipping"},
      {"view/show_all"},
      line,
      {"", MainWindow::tr("Panels"), {{"panels"}, {"panels/evaluation"}, line, {"panels/layout"}}},
      {"view/theme", MainWindow::tr("Theme")},
      {"view/language", MainWindow::tr("Language")}};
}

std::vector<Place> skeletonPlaces() {
  return {{"skeleton/make"},
          {"skeleton/stand", MainWindow::tr("R&oot and Up")},
          {"skeleton/settings", MainWindow::tr("Se&ttings of the Steps")},
          {"skeleton/settings_for_kind"},
          {"",
           MainWindow::tr("Pre&view"),
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
          {"skeleton/units", MainWindow::tr("&Units")},
          {"skeleton/hulls"}};
}

std::vector<MenuPlaces> menuPlaces() {
  return {{MainWindow::tr("&File"),
           {{"file/new"},
            {"file/open"},
            {"file/recent", MainWindow::tr("Open &Recent")},
            {"file/worklist", MainWindow::tr("&Worklist")},
            line,
            {"file/reference"},
            line,
            {"file/save"},
            line,
            {"file/export"},
            {"file/project"},
            {"file/versions", MainWindow::tr("&Versions")},
            line,
            {"file/close"}}},
          {MainWindow::tr("&Edit"),
           {{"edit/history"},
            line,
            {"edit/copy"},
            line,
            {"edit/preview"},
            {"edit/leave"},
            line,
            {"edit/tools"},
            line,
            {"edit/snap", MainWindow::tr("S&nap")}}},
          {MainWindow::tr("Se&lect"),
           {{"select/all"}, {"select/findings"}, {"select/through"}, line, {"select/nodes"}}},
          {MainWindow::tr("&View"), viewPlaces()},
          {MainWindow::tr("&Points"),
           {{"points"},
            line,
            {"points/organs", MainWindow::tr("&Organ")},
            {"points/registration", MainWindow::tr("Several Scans")}}},
          {MainWindow::tr("&Skeleton"), skeletonPlaces()},
          {MainWindow::tr("R&adius"), {{"radius"}}},
          {MainWindow::tr("Eval&uate"), {{"evaluate"}, line, {"evaluate/envelope"}}},
          {MainWindow::tr("&Review"),
           {{"review/walk"}, line, {"review/findings"}, line, {"review/doubts"}}},
          {MainWindow::tr("Help"), {{"help"}}}}; // Alt+H is a key of the plant
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
  giveLetters(menu);
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
  // It gets no events of the pointer while the menu is open, and would stay lit.
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
