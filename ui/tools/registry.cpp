#include "ui/tools/registry.h"

#include "ui/tools/add_node_tool.h"
#include "ui/tools/measure_tool.h"
#include "ui/tools/move_node_tool.h"
#include "ui/tools/navigate_tool.h"
#include "ui/tools/pick_root_tool.h"
#include "ui/tools/regrow_tool.h"
#include "ui/tools/reparent_node_tool.h"
#include "ui/tools/select_points_tool.h"
#include "ui/tools/stroke_tool.h"
#include "ui/tools/trace_tool.h"

#include <QCoreApplication>

namespace espalier {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Tools", text);
}

template <class T> std::unique_ptr<Tool> make(PlantDocument& document, Canvas& canvas) {
  return std::make_unique<T>(document, canvas);
}

} // namespace

std::vector<ToolEntry> tools() {
  return {
      {"move", tr("Select and Move"), tr("Click to select, drag to move"), "select", Qt::Key_S,
       make<MoveNodeTool>, true},
      {"add", tr("Add Nodes"),
       tr("Pull children out of nodes, insert on edges, click along points"), "add", Qt::Key_D,
       make<AddNodeTool>},
      {"reparent", tr("Reparent"), tr("Drag a branch onto another node or edge"), "reparent",
       Qt::Key_P, make<ReparentNodeTool>},
      {"trace", tr("Trace"), tr("Click a start and an end: the branch is found along the points"),
       "trace", Qt::Key_L, make<TraceTool>},
      {"stroke", tr("Stroke"),
       tr("Draw across edges to cut, along points to branch, around a crossing to exchange arms"),
       "stroke", Qt::Key_Y, make<StrokeTool>},
      {"regrow", tr("Regrow"), tr("What a node carries is reconstructed again from the points"),
       "regrow", QKeySequence(Qt::SHIFT | Qt::Key_N), make<RegrowTool>},
      {"points", tr("Select Points"),
       tr("A brush, boxes and lassos select points of the scan, to set them aside"), "points",
       Qt::Key_C, make<SelectPointsTool>, true},
      {"root", tr("Pick Root"),
       tr("Click the foot of the trunk in the scan: the plant will be rooted there"), "root",
       QKeySequence(Qt::SHIFT | Qt::Key_R), make<PickRootTool>},
      {"navigate", tr("Navigate"), tr("The mouse only moves the camera"), "navigate", Qt::Key_V,
       make<NavigateTool>, true},
      {"measure", tr("Measure"), tr("Click two things for their distance, three for an angle"),
       "measure", Qt::Key_I, make<MeasureTool>, true},
  };
}

} // namespace espalier
