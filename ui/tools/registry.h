#pragma once

#include "ui/tools/tool.h"

#include <QKeySequence>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace espalier {

/// A tool that the toolbar offers.
struct ToolEntry {
  QString id;   // never translated: settings and tests know it by this
  QString text; // in menus
  QString help; // what it is for, one line
  QString icon; // name in resources/icons
  QKeySequence shortcut;
  QString manual; // where it is described: "correct.md#along-the-points"
  std::function<std::unique_ptr<Tool>(PlantDocument&, Canvas&)> create;
  bool isForLooking = false; // is of use also in a plant that may not be edited
};

/// All tools; the first is the default.
[[nodiscard]] std::vector<ToolEntry> tools();

} // namespace espalier
