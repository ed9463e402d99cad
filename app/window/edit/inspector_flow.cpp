#include "app/window/edit/inspector_flow.h"

#include "app/window/frame/action_set.h"
#include "ui/document/plant_document.h"
#include "ui/panels/inspector_panel.h"
#include "ui/tools/node_edits.h"
#include "ui/view/plant_view.h"

#include <QAction>

namespace espalier {

InspectorFlow::InspectorFlow(const Parts& parts) {
  PanelDock::Place place = besideThePlant;
  place.isShown = true;
  addDock(new PanelDock(parts.window,
                        {.id = "inspector",
                         .title = tr("Inspector"),
                         .text = tr("Inspector"),
                         .help = tr("Shows or hides this panel"),
                         .keys = Qt::Key_F7,
                         .manual = "correct.md#radii"},
                        place, &parts.panel, this));
  PlantDocument& document = parts.document;
  ActionSet& actions = parts.window.actions;
  connect(&parts.panel, &InspectorPanel::radiusTyped, this, [&document, &actions](double radius) {
    actions.guarded(
        [&] {
          setRadius(document, document.selection().nodes(), radius);
          return true;
        },
        Refusal::inBanner);
  });
  connect(&parts.panel, &InspectorPanel::leaveRequested, &parts.view,
          qOverload<>(&QWidget::setFocus));
  connect(&parts.panel, &InspectorPanel::edgeChosen, this, [&actions](EdgeType type) {
    actions[type == EdgeType::successor ? "make_axial" : "make_branching"]->trigger();
  });
  connect(&parts.panel, &InspectorPanel::nodeChosen, this,
          [&document](NodeId id) { document.selection().set({id}); });
}

} // namespace espalier
