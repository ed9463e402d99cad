#include "app/window/edit/node_menus.h"

#include "app/window/frame/action_set.h"
#include "ui/tools/node_choices.h"
#include "ui/tools/structure_edits.h"

#include <QMap>
#include <QMenu>

namespace espalier {

void fillNodeEdits(QMenu& menu, const ActionSet& actions, const QStringList& without) {
  QMap<QString, QMenu*> within; // by name
  bool isWithin = false;
  for (const NodeEdit& edit : nodeEdits()) {
    if (without.contains(edit.id)) continue;
    if (isWithin != !edit.menu.isEmpty()) menu.addSeparator();
    isWithin = !edit.menu.isEmpty();
    if (edit.menu.isEmpty()) {
      menu.addAction(actions[edit.id]);
      continue;
    }
    QMenu*& to = within[edit.menu];
    if (to == nullptr) to = menu.addMenu(edit.menu);
    to->addAction(actions[edit.id]);
  }
  within[pathMenu()]->addAction(actions["resample"]);
}

void fillNodeChoices(QMenu& menu, const ActionSet& actions) {
  for (const NodeChoice& choice : nodeChoices()) {
    if (choice.id.isEmpty())
      menu.addSeparator();
    else
      menu.addAction(actions[choice.id]);
  }
}

} // namespace espalier
