#include "tests/support/plants.h"
#include "tests/ui/tools/line_scan.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/node_choices.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/registry.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <set>

namespace espalier {
namespace {

TEST(ToolRegistry, GivesEveryToolANameAnIconAndAHint) {
  PlantDocument document;
  test::QuietCanvas canvas;
  for (const ToolEntry& entry : tools()) {
    EXPECT_FALSE(entry.text.isEmpty() || entry.help.isEmpty() || entry.icon.isEmpty());
    EXPECT_FALSE(entry.create(document, canvas)->hint().isEmpty()) << entry.id.toStdString();
  }
}

TEST(ToolRegistry, LeavesTheMouseToTheCameraInToolsThatEditNothing) {
  PlantDocument document;
  test::QuietCanvas canvas;
  document.setScan(test::lineScan(), "line.xyz");
  document.openSkeleton(test::fork(3), "fork.mtg");
  for (const ToolEntry& entry : tools()) {
    const std::unique_ptr<Tool> tool = entry.create(document, canvas);
    const bool takes = test::Mouse(*tool).press(test::onNode(NodeId{2}), {1, 2});
    EXPECT_EQ(takes, entry.id != "navigate" && entry.id != "measure" && entry.id != "root")
        << entry.id.toStdString();
  }
}

TEST(ToolRegistry, UsesNoKeyTwice) {
  std::set<QString> keys;
  for (const ToolEntry& entry : tools())
    EXPECT_TRUE(keys.insert(entry.shortcut.toString()).second) << entry.id.toStdString();
  for (const NodeEdit& edit : nodeEdits()) {
    if (edit.shortcut.isEmpty()) continue;
    EXPECT_TRUE(keys.insert(edit.shortcut.toString()).second) << edit.id.toStdString();
  }
  for (const NodeChoice& choice : nodeChoices())
    for (const QKeySequence& shortcut : choice.shortcuts)
      EXPECT_TRUE(keys.insert(shortcut.toString()).second) << choice.id.toStdString();
}

} // namespace
} // namespace espalier
