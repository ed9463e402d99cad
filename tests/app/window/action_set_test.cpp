#include "app/window/frame/action_set.h"
#include "core/base/error.h"

#include <QAction>
#include <QWidget>

#include <gmock/gmock.h>

namespace espalier {
namespace {

struct ActionSetTest : testing::Test {
  QWidget window;
  ActionSet actions{window};
  QString reason;

  void SetUp() override {
    QObject::connect(&actions, &ActionSet::refused, &window,
                     [this](const QString& text) { reason = text; });
  }
};

TEST_F(ActionSetTest, SaysWhyACommandIsRefused) {
  actions.add({.id = "fail", .text = "Fail", .help = "Fails"}, [] { throw Error("no way"); });
  actions["fail"]->trigger();
  EXPECT_EQ(reason, "no way");
}

TEST_F(ActionSetTest, BeginsASentenceAtThePointer) {
  const bool taken =
      actions.guarded([]() -> bool { throw Error("no way"); }, Refusal::atPointer, true);
  EXPECT_TRUE(taken);
  EXPECT_EQ(reason, "No way");
}

TEST_F(ActionSetTest, KnowsTheSectionOfEachAction) {
  actions.beginSection("File");
  actions.add({.id = "open", .text = "Open", .help = "Opens"}, {});
  actions.beginSection("Edit");
  actions.add({.id = "undo", .text = "Undo", .help = "Undoes"}, {});
  EXPECT_EQ(actions["open"]->property("section"), "File");
  EXPECT_EQ(actions["undo"]->property("section"), "Edit");
  EXPECT_EQ(window.actions(), actions.all()) << "their keys work in the window";
}

} // namespace
} // namespace espalier
