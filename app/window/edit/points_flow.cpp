#include "app/window/edit/points_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/edit/point_states.h"
#include "app/window/frame/action_set.h"
#include "core/base/error.h"
#include "ui/document/plant_document.h"
#include "ui/tools/select_points_tool.h"

#include <QAction>
#include <QMenu>

namespace espalier {
namespace {

const QString toolId = QStringLiteral("points");

QString pointsText(std::size_t count) {
  return count == 1 ? PointsFlow::tr("1 point")
                    : PointsFlow::tr("%1 points").arg(formatCount(count));
}

} // namespace

PointsFlow::PointsFlow(const Parts& parts)
    : parts_(parts), tool_(qobject_cast<SelectPointsTool*>(&parts.editing.toolNamed(toolId))) {
  Q_ASSERT(tool_ != nullptr);
  addActions();
  PlantDocument& document = parts_.document;
  for (auto signal : {&PlantDocument::leftOutChanged, &PlantDocument::scanChanged,
                      &PlantDocument::readOnlyChanged})
    connect(&document, signal, this, &PointsFlow::refreshEnabled);
  connect(&document.pointSelection(), &PointSelection::changed, this, &PointsFlow::refreshEnabled);
  connect(&parts_.editing, &Editing::hintChanged, this, &PointsFlow::refreshEnabled);
  connect(&document, &PlantDocument::scanChanged, this, [this] {
    parts_.actions["show_set_aside"]->setChecked(false); // another scan, nothing of it is asked for
    parts_.states.showAside(false);
    refreshEnabled();
    emit changed();
  });
  refreshEnabled();
}

void PointsFlow::addActions() {
  parts_.actions.beginSection(tr("Points"));
  addChoices();
  addEdits();
  addShown();
  parts_.actions.place("points", {"show_cleaning",
                                  "show_plot",
                                  "",
                                  "tool_points",
                                  "points_brush",
                                  "points_box",
                                  "points_lasso",
                                  "points_shape",
                                  "brush_larger",
                                  "brush_smaller",
                                  "points_pole",
                                  "points_wire",
                                  "points_plant",
                                  "select_shown_points",
                                  "invert_points",
                                  "deselect_points",
                                  "",
                                  "set_points_aside",
                                  "keep_points",
                                  "bring_points_back",
                                  "",
                                  "branch_from_points",
                                  "",
                                  "isolate_points",
                                  "show_set_aside"});
  parts_.actions.place("context/points", [this](QMenu& menu) { fillContextMenu(menu); });
}

void PointsFlow::addChoices() {
  ActionSet& actions = parts_.actions;
  addShapes();
  actions.add({.id = "points_shape",
               .text = tr("Next Shape to Select With"),
               .help = tr("From the brush to boxes, to lassos, and back to the brush"),
               .keys = QKeySequence(Qt::SHIFT | Qt::Key_C)},
              [this] { nextShape(); });
  constexpr double step = 1.25;
  actions.add({.id = "brush_larger",
               .text = tr("Larger Brush"),
               .help = tr("The brush that selects points grows by a quarter"),
               .keys = Qt::Key_BracketRight},
              [this] { changeBrush(step); });
  actions.add({.id = "brush_smaller",
               .text = tr("Smaller Brush"),
               .help = tr("The brush that selects points shrinks by a fifth"),
               .keys = Qt::Key_BracketLeft},
              [this] { changeBrush(1 / step); });
  addThings();
  actions.add({.id = "invert_points",
               .text = tr("Invert Selected Points"),
               .help = tr("Selects all other points that are not set aside")},
              [this] {
                PlantDocument& document = parts_.document;
                document.pointSelection().set(PointSet::firstOf(document.scan()->cloud()->size()) -
                                              document.leftOut() -
                                              document.pointSelection().points());
              });
  actions.add({.id = "deselect_points",
               .text = tr("Deselect Points"),
               .help = tr("No point is selected any more"),
               .keys = QKeySequence(Qt::CTRL | Qt::Key_D)},
              [this] { parts_.document.pointSelection().clear(); });
}

void PointsFlow::addShapes() {
  using Shape = SelectPointsTool::Shape;
  const auto add = [this](const Command& command, Shape shape) {
    QAction* action = parts_.actions.add(command, [this, shape] {
      parts_.editing.useTool(toolId);
      tool_->setShape(shape);
    });
    action->setCheckable(true);
    shapes_.emplace_back(action, shape);
  };
  add({.id = "points_brush",
       .text = tr("Select with Brush"),
       .help = tr("Paint points with a round brush: they are selected")},
      Shape::brush);
  add({.id = "points_box",
       .text = tr("Select with Box"),
       .help = tr("Draw a box: the points in it are selected")},
      Shape::box);
  add({.id = "points_lasso",
       .text = tr("Select with Lasso"),
       .help = tr("Draw a line about points: they are selected")},
      Shape::lasso);
}

void PointsFlow::addThings() {
  using Thing = PointQuestion::Thing;
  const auto add = [this](const Command& command, Thing thing) {
    QAction* action = parts_.actions.add(command, [this, thing] {
      parts_.editing.useTool(toolId);
      tool_->setThing(thing);
    });
    action->setCheckable(true);
    things_.emplace_back(action, thing);
  };
  add({.id = "points_pole",
       .text = tr("Select Pole"),
       .help = tr("Click a pole, a stake or a pipe: all its points are selected")},
      Thing::pole);
  add({.id = "points_wire",
       .text = tr("Select Wire"),
       .help = tr("Click a wire or a rope at two places: its points between them are selected")},
      Thing::wire);
  add({.id = "points_plant",
       .text = tr("Select Plant"),
       .help = tr("Click a plant: all points that belong to its stem are selected")},
      Thing::plant);
}

void PointsFlow::addEdits() {
  ActionSet& actions = parts_.actions;
  actions.add({.id = "set_points_aside",
               .text = tr("Set Points Aside"),
               .help = tr("The selected points take part in nothing until they are brought back")},
              [this] { setAside({}); });
  actions.add({.id = "keep_points",
               .text = tr("Keep Only These Points"),
               .help = tr("Sets all points aside but the selected ones")},
              [this] { keepOnly(); });
  actions.add(
      {.id = "bring_points_back",
       .text = tr("Bring All Back"),
       .help = tr("All points that are set aside; while they are shown, only those that are "
                  "selected, if some are")},
      [this] { bringBack(); });
}

void PointsFlow::addShown() {
  ActionSet& actions = parts_.actions;
  actions.add({.id = "show_set_aside",
               .text = tr("Show What Was Set Aside"),
               .help = tr("Draws the points that are set aside, so that they can be selected"),
               .isCheckable = true},
              [this] {
                parts_.states.showAside(parts_.actions["show_set_aside"]->isChecked());
                refreshEnabled();
              });
  actions.add({.id = "isolate_points",
               .text = tr("Isolate Points"),
               .help = tr("Hides all points but the selected ones, until all are shown again")},
              [this] { isolate(); });
  connect(actions["show_all"], &QAction::triggered, this, [this] {
    parts_.states.isolate(std::nullopt);
    emit changed();
  });
}

const PointSet& PointsFlow::chosen() const {
  const PointSet& points = parts_.document.pointSelection().points();
  if (points.isEmpty())
    throw Error(tr("no point is selected: choose Select Points (C), and paint some").toStdString());
  return points;
}

void PointsFlow::setAside(const QString& what) {
  const PointSet points = chosen() - parts_.document.leftOut();
  const QString text = tr("Set %1 aside").arg(pointsText(points.size()));
  parts_.document.leaveOut(what.isEmpty() ? text : tr("%1: %2").arg(what, text),
                           parts_.document.leftOut() | points);
  parts_.document.pointSelection().clear();
}

void PointsFlow::keepOnly() {
  const PointSet points = chosen();
  const PointSet all = PointSet::firstOf(parts_.document.scan()->cloud()->size());
  parts_.document.leaveOut(tr("Keep only %1").arg(pointsText(points.size())), all - points);
  parts_.document.pointSelection().clear();
}

bool PointsFlow::bringsSomeBack() const {
  return parts_.actions["show_set_aside"]->isChecked() &&
         !parts_.document.pointSelection().isEmpty();
}

void PointsFlow::bringBack() {
  const PointSet aside = parts_.document.leftOut();
  const PointSet back =
      bringsSomeBack() ? aside & parts_.document.pointSelection().points() : aside;
  if (back.isEmpty())
    throw Error(tr("no selected point is set aside: select some of those, or none").toStdString());
  parts_.document.leaveOut(tr("Bring %1 back").arg(pointsText(back.size())), aside - back);
}

void PointsFlow::isolate() {
  parts_.states.isolate(chosen());
  parts_.document.pointSelection().clear();
  emit changed();
}

void PointsFlow::nextShape() {
  using Shape = SelectPointsTool::Shape;
  parts_.editing.useTool(toolId);
  tool_->setShape(tool_->shape() == Shape::brush ? Shape::box
                  : tool_->shape() == Shape::box ? Shape::lasso
                                                 : Shape::brush);
}

void PointsFlow::changeBrush(double factor) {
  tool_->setBrushSize(factor * tool_->brushSize());
}

void PointsFlow::refreshEnabled() {
  const PlantDocument& document = parts_.document;
  const bool isTool = parts_.editing.currentTool() == toolId;
  const bool hasScan = document.scan() != nullptr;
  const bool isIdle = parts_.actions["tool_points"]->isEnabled();
  const bool hasChosen = hasScan && !parts_.document.pointSelection().isEmpty();
  const auto enable = [this](const QString& id, bool isEnabled) {
    parts_.actions[id]->setEnabled(isEnabled);
  };
  for (const char* id : {"set_points_aside", "keep_points"})
    enable(id, hasChosen && isIdle && !document.isReadOnly());
  // Del is a key of nodes: it means points, and Editing turns its edits of nodes off, with the tool
  // for points only.
  const QKeySequence del(Qt::Key_Delete);
  const QKeySequence shiftDel(Qt::SHIFT | Qt::Key_Delete);
  parts_.actions["set_points_aside"]->setShortcut(isTool ? del : QKeySequence());
  parts_.actions["keep_points"]->setShortcut(isTool ? shiftDel : QKeySequence());
  QAction& showAside = *parts_.actions["show_set_aside"];
  enable("bring_points_back", !document.leftOut().isEmpty() && isIdle && !document.isReadOnly());
  parts_.actions["bring_points_back"]->setText(bringsSomeBack() ? tr("Bring These Back")
                                                                : tr("Bring All Back"));
  showAside.setEnabled(hasScan && (!document.leftOut().isEmpty() || showAside.isChecked()));
  enable("isolate_points", hasChosen);
  enable("deselect_points", hasChosen);
  enable("invert_points", hasScan);
  enable("points_shape", hasScan && isIdle);
  for (const auto& [action, shape] : shapes_) {
    action->setEnabled(hasScan && isIdle);
    action->setChecked(isTool && tool_->shape() == shape);
  }
  for (const auto& [action, thing] : things_) {
    action->setEnabled(hasScan && isIdle);
    action->setChecked(isTool && tool_->thing() == thing);
  }
  for (const char* id : {"brush_larger", "brush_smaller"})
    enable(id, isTool && tool_->shape() == SelectPointsTool::Shape::brush);
}

void PointsFlow::fillContextMenu(QMenu& menu) const {
  const std::size_t count = parts_.document.pointSelection().points().size();
  if (count == 0) return;
  menu.addSection(pointsText(count));
  for (const char* id : {"set_points_aside", "keep_points", "branch_from_points", "isolate_points"})
    menu.addAction(parts_.actions[id]);
}

} // namespace espalier
