#include "app/window/action_set.h"
#include "app/window/evaluation_flow.h"
#include "app/window/findings_flow.h"
#include "app/window/hull_flow.h"
#include "app/window/icon.h"
#include "app/window/main_window.h"
#include "app/window/menu_title.h"
#include "app/window/node_menus.h"
#include "app/window/points_flow.h"
#include "app/window/preset_flow.h"
#include "app/window/radius_flow.h"
#include "app/window/recent_files.h"
#include "app/window/review_flow.h"
#include "app/window/saved_views.h"
#include "app/window/snap_flow.h"
#include "app/window/stand_flow.h"
#include "app/window/states_flow.h"
#include "app/window/two_views_flow.h"
#include "app/window/view_options.h"
#include "ui/tools/registry.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace espalier {
namespace {

/// Adds actions by id; an empty id is a separator.
void add(QWidget& to, const ActionSet& actions, const QStringList& ids) {
  for (const QString& id : ids) {
    if (!id.isEmpty()) {
      to.addAction(actions[id]);
      continue;
    }
    auto* separator = new QAction(&to);
    separator->setSeparator(true);
    to.addAction(separator);
  }
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

void fillColorScales(QMenu& menu, const ActionSet& actions, const ViewOptions& options) {
  menu.addMenu(MainWindow::tr("Colors of Points"))->addActions(options.pointMaps());
  menu.addMenu(MainWindow::tr("Colors of Nodes"))->addActions(options.nodeMaps());
  add(menu, actions, {"", "color_range", "usual_color_ranges"});
}

QStringList toolIds() {
  QStringList ids;
  for (const ToolEntry& tool : tools())
    ids.append("tool_" + tool.id);
  return ids;
}

} // namespace

void MainWindow::fillMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  add(*file, *actions_, {"new_plant", "open"});
  QMenu* recent = file->addMenu(tr("Open &Recent"));
  connect(recent, &QMenu::aboutToShow, recent, [this, recent] {
    recent->clear();
    for (const QString& path : recent_->paths())
      recent->addAction(QDir::toNativeSeparators(path), this, [this, path] { open({path}); });
    if (recent->isEmpty())
      recent->addAction(tr("None yet"))->setEnabled(false);
    else
      recent->addSeparator();
    recent->addAction(tr("Clear"), recent_.get(), &RecentFiles::clear);
  });
  add(*file, *actions_,
      {"", "load_reference", "remove_reference", "", "save", "save_as", "save_project_as", "",
       "export_structure", "keep_scan", "compact_project", "", "close_plant", "quit"});

  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  add(*edit, *actions_,
      {"undo", "redo", "", "copy", "", "accept", "next_way", "fewer_branches", "more_branches",
       "leave", ""});
  add(*edit, *actions_, toolIds());
  edit->addSeparator();
  snaps_->fillMenu(*edit->addMenu(tr("S&nap")));

  QMenu* select = menuBar()->addMenu(tr("Se&lect"));
  add(*select, *actions_, {"select_all", "select_findings", "select_through", ""});
  fillNodeChoices(*select, *actions_);

  fillViewMenu();

  points_->fillMenu(*menuBar()->addMenu(tr("&Points")));

  QMenu* skeleton = menuBar()->addMenu(tr("&Skeleton"));
  add(*skeleton, *actions_, {"reconstruct", "regrow_missing"});
  stand_->fillMenu(*skeleton->addMenu(tr("R&oot and Up")));
  QMenu* settings = skeleton->addMenu(tr("Se&ttings of the Steps"));
  settings->setObjectName("presets");
  presets_->fill(*settings); // for who looks through the menus
  connect(settings, &QMenu::aboutToShow, presets_.get(),
          [this, settings] { presets_->fill(*settings); });
  states_->fillMenu(*skeleton->addMenu(tr("Pre&view")));
  skeleton->addSeparator();
  const QStringList ofUnits = {"mark_unit_start", "commit_marks", "clear_marks"};
  fillNodeEdits(*skeleton, *actions_, ofUnits + QStringList{"radius_up", "radius_down"});
  skeleton->addSeparator();
  add(*skeleton->addMenu(tr("&Units")), *actions_, ofUnits);
  hulls_->fillMenu(*skeleton);

  add(*menuBar()->addMenu(tr("R&adius")), *actions_, RadiusFlow::menu());

  evaluation_->fillMenu(*menuBar()->addMenu(tr("Eval&uate")));

  QMenu* review = menuBar()->addMenu(tr("&Review"));
  review_->fillMenu(*review);
  review->addSeparator();
  findings_->fillMenu(*review);

  QMenu* help = menuBar()->addMenu(tr("Help")); // Alt+H is a key of the plant
  add(*help, *actions_, {"manual", "shortcuts", "palette", "", "about"});
}

void MainWindow::fillViewMenu() {
  QMenu* view = menuBar()->addMenu(tr("&View"));
  addTitle(*view, tr("Layers"));
  view->addActions(options_->layers());
  view->addSeparator();
  view->addMenu(tr("Color Points By"))->addActions(options_->colors());
  view->addMenu(tr("Color Nodes By"))->addActions(options_->nodeColors());
  fillColorScales(*view->addMenu(tr("Color Scales")), *actions_, *options_);
  add(*view, *actions_, {"hide_explained", "blend_points"});
  view->addMenu(tr("Point Size"))->addActions(options_->sizes());
  view->addMenu(tr("Projection"))->addActions(options_->projections());
  view->addMenu(tr("Look From"))->addActions(options_->standardViews());
  add(*view, *actions_, {"frame_all", "frame", "look_closely", "look_back", "pivot", ""});
  add(*view, *actions_, {"minimap", "two_views"});
  view->addMenu(tr("Second View"))->addActions(twoViews_->links());
  QMenu* saved = view->addMenu(tr("Saved Views"));
  saved->setObjectName("saved_views");
  connect(saved, &QMenu::aboutToShow, saved, [this, saved] { savedViews_->fill(*saved); });
  add(*view, *actions_, {"hide", "isolate", "show_clipping", "show_all", ""});
  add(*view->addMenu(tr("Panels")), *actions_,
      {"show_pipeline", "show_inspector", "show_review", "show_findings", "show_history",
       "show_node_table", "show_judge", "show_sweep", "show_evaluation", "show_methods", "",
       "reset_layout"});
  add(*view->addMenu(tr("Theme")), *actions_, {"theme_system", "theme_light", "theme_dark"});
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
  layers->addActions(options_->layers());
  bar->addWidget(makeMenuButton(tr("Layers"), "layers", layers));
  auto* colors = new QMenu(bar);
  colors->addActions(options_->colors());
  colors->addSeparator();
  colors->addMenu(tr("Color Nodes By"))->addActions(options_->nodeColors());
  fillColorScales(*colors->addMenu(tr("Color Scales")), *actions_, *options_);
  colors->addMenu(tr("Point Size"))->addActions(options_->sizes());
  bar->addWidget(makeMenuButton(tr("Color By"), "color", colors));
  add(*bar, *actions_, {"frame_all"});
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  add(*bar, *actions_, {"palette", "shortcuts"});
}

} // namespace espalier
