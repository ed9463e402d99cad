#include "ui/tools/registry.h"

#include "ui/tools/add_node_tool.h"
#include "ui/tools/move_node_tool.h"
#include "ui/tools/navigate_tool.h"
#include "ui/tools/reparent_node_tool.h"

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
       make<MoveNodeTool>},
      {"add", tr("Add Nodes"),
       tr("Pull children out of nodes, insert on edges, click along points"), "add", Qt::Key_D,
       make<AddNodeTool>},
      {"reparent", tr("Reparent"), tr("Drag a branch onto another node or edge"), "reparent",
       Qt::Key_P, make<ReparentNodeTool>},
      {"navigate", tr("Navigate"), tr("The mouse only moves the camera"), "navigate", Qt::Key_V,
       make<NavigateTool>},
  };
}

} // namespace espalier
