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

struct ToolText {
  Q_DECLARE_TR_FUNCTIONS(Tools)
};

template <class T> std::unique_ptr<Tool> make(PlantDocument& document, Canvas& canvas) {
  return std::make_unique<T>(document, canvas);
}

} // namespace

std::vector<ToolEntry> tools() {
  return {
      {"move", ToolText::tr("Select and Move"), ToolText::tr("Click to select, drag to move"),
       "select", Qt::Key_S, "correct.md", make<MoveNodeTool>, true},
      {"add", ToolText::tr("Add Nodes"),
       ToolText::tr("Pull children out of nodes, insert on edges, click along points"), "add",
       Qt::Key_D, "correct.md", make<AddNodeTool>},
      {"reparent", ToolText::tr("Reparent"),
       ToolText::tr("Drag a branch onto another node or edge"), "reparent", Qt::Key_P, "correct.md",
       make<ReparentNodeTool>},
      {"trace", ToolText::tr("Trace"),
       ToolText::tr("Click a start and an end: the branch is found along the points"), "trace",
       Qt::Key_L, "correct.md#along-the-points", make<TraceTool>},
      {"stroke", ToolText::tr("Stroke"),
       ToolText::tr(
           "Draw across edges to cut, along points to branch, around a crossing to exchange arms"),
       "stroke", Qt::Key_Y, "correct.md#along-the-points", make<StrokeTool>},
      {"regrow", ToolText::tr("Regrow"),
       ToolText::tr("What a node carries is reconstructed again from the points"), "regrow",
       QKeySequence(Qt::SHIFT | Qt::Key_N), "correct.md#along-the-points", make<RegrowTool>},
      {"points", ToolText::tr("Select Points"),
       ToolText::tr("A brush, boxes and lassos select points of the scan, to set them aside"),
       "points", Qt::Key_C, "clean.md#points-of-the-scan", make<SelectPointsTool>, true},
      {"root", ToolText::tr("Pick Root"),
       ToolText::tr("Click the foot of the trunk in the scan: the plant will be rooted there"),
       "root", QKeySequence(Qt::SHIFT | Qt::Key_R), "reconstruct.md#root-and-up",
       make<PickRootTool>},
      {"navigate", ToolText::tr("Navigate"), ToolText::tr("The mouse only moves the camera"),
       "navigate", Qt::Key_V, "looking.md", make<NavigateTool>, true},
      {"measure", ToolText::tr("Measure"),
       ToolText::tr("Click two things for their distance, three for an angle"), "measure",
       Qt::Key_I, "looking.md#measuring", make<MeasureTool>, true},
  };
}

} // namespace espalier
