#pragma once

#include "core/skeleton/skeleton.h"

#include <QKeySequence>
#include <QList>
#include <QString>

#include <functional>
#include <vector>

namespace espalier {

/// A choice of nodes by how the plant is built, which a key or a menu makes at once.
struct NodeChoice {
  QString id;   // never translated: settings and tests know it by this
  QString text; // in menus
  QString help; // one line
  QList<QKeySequence> shortcuts;
  /// The nodes to be selected, given those that the key is meant for.
  /// @throws Error if it cannot choose any
  std::function<std::vector<NodeId>(const Skeleton&, const std::vector<NodeId>&)> choose;
  bool needsNodes = true; // to begin with; else it goes by those selected, if any
  bool isStep = false;    // of a cursor: its key works in the view alone, and the view follows
};

/// All of them, in the order of the menu; an entry without id is a separator.
[[nodiscard]] std::vector<NodeChoice> nodeChoices();

} // namespace espalier
