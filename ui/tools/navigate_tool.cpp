#include "ui/tools/navigate_tool.h"

namespace espalier {

QString NavigateTool::hint() const {
  return tr("Drag: turn   Right drag: pan   Wheel: zoom   Double click: turn around this place");
}

} // namespace espalier
