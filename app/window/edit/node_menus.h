#pragma once

#include <QStringList>

class QMenu;

namespace espalier {

class ActionSet;

/// Adds the edits of nodes (nodeEdits()) to a menu, those of a theme in menus within it.
/// @param without  ids to leave out
void fillNodeEdits(QMenu& menu, const ActionSet& actions, const QStringList& without = {});

/// Adds the choices of nodes (nodeChoices()) to a menu.
void fillNodeChoices(QMenu& menu, const ActionSet& actions);

} // namespace espalier
