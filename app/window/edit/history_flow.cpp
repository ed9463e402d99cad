#include "app/window/edit/history_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "ui/document/plant_document.h"
#include "ui/panels/history_panel.h"

#include <cstdlib>

namespace espalier {

HistoryFlow::HistoryFlow(const Parts& parts) : parts_(parts) {
  parts_.window.actions.beginSection(tr("View"));
  auto* panel = new HistoryPanel(parts_.document);
  addDock(new PanelDock(parts_.window,
                        {.id = "history",
                         .title = tr("History"),
                         .text = tr("History"),
                         .help = tr("Shows or hides the list of all steps"),
                         .keys = Qt::Key_F10,
                         .manual = "window.md#history"},
                        panel, this));
  connect(panel, &HistoryPanel::chosen, this, [this](int position) {
    parts_.window.actions.guarded(
        [&] {
          goTo(position);
          return true;
        },
        Refusal::inBanner);
  });
}

void HistoryFlow::goTo(int position) {
  if (parts_.editing.isPending()) parts_.editing.undo(); // leaves the gesture
  const int before = parts_.document.undoStack().index();
  parts_.document.goTo(position);
  const int steps = std::abs(position - before);
  if (steps < 2) return; // one step is noted by its name
  emit noted(position < before ? tr("Undone: %n steps", nullptr, steps)
                               : tr("Redone: %n steps", nullptr, steps));
}

} // namespace espalier
