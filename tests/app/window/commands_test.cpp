// All commands of the window: where they are found, and where they are described.
#include "app/window/frame/action_set.h"
#include "tests/app/window/read_entry.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/manual.h"
#include "tests/support/plants.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/status_line.h"
#include "ui/panels/step_form.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionButton>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <cmath>
#include <fstream>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using test::forkTop;

using MainWindowTest = test::WindowTest;

TEST_F(MainWindowTest, TheSheetOfShortcutsListsBoxesAndLassos) {
  action("shortcuts").trigger();
  auto& sheet = find<QDialog>("shortcut_sheet");
  QStringList texts;
  for (const QLabel* label : sheet.findChildren<QLabel*>())
    texts.append(label->text());
  EXPECT_TRUE(texts.contains("Shift+drag"));
  EXPECT_TRUE(texts.contains("Alt+drag"));
  sheet.reject();
}

TEST_F(MainWindowTest, OffersTheEditsOfANodeInItsMenu) {
  open({writeFork("fork.mtg")});
  const NodeId apex = nodeAt({1, 0, 2});
  QStringList texts;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (menu == nullptr) return;
    for (const QAction* entry : menu->actions())
      texts.append(test::asRead(entry));
    menu->close();
  });
  timer.start(0);
  click(placeOf(apex), Qt::NoModifier, Qt::RightButton);
  EXPECT_EQ(texts.value(0), QString("Node %1").arg(indexOf(apex)));
  EXPECT_TRUE(texts.contains("Remove Subtree"));
  EXPECT_TRUE(texts.contains("Reparent"));
}

TEST_F(MainWindowTest, RunsACommandFoundInThePalette) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  auto& palette = find<QDialog>("command_palette");
  QTest::keyClicks(palette.findChild<QLineEdit*>(), "sel all");
  QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
  EXPECT_TRUE(
      QTest::qWaitFor([this] { return document().selection().nodes().size() == 5; }, patience));
}

TEST_F(MainWindowTest, FindsACommandByWhatItDoes) {
  open({writeFork("fork.mtg")});
  action("palette").trigger();
  auto& palette = find<QDialog>("command_palette");
  QTest::keyClicks(palette.findChild<QLineEdit*>(), "color nodes radius share");
  QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("node_color_radius_to_parent").isChecked(); },
                              patience));
}

struct PaletteWindowTest : MainWindowTest {
  QStringList listed(const char* typed) {
    action("palette").trigger();
    auto& palette = find<QDialog>("command_palette");
    QTest::keyClicks(palette.findChild<QLineEdit*>(), typed);
    const auto& list = *palette.findChild<QListWidget*>();
    QStringList texts;
    for (int row = 0; row < list.count(); ++row)
      texts.append(list.item(row)->text());
    palette.close();
    QTest::qWait(1); // until it is gone
    return texts;
  }
};

TEST_F(PaletteWindowTest, FindsUndoByItsOwnNameAndNotByWhatItUndoes) {
  open({writeFork("fork.mtg")});
  document().edit("Set radius", [&](SkeletonEditor& editor) {
    editor.setRadius(editor.skeleton().roots().front(), 0.2);
  });
  ASSERT_EQ(action("undo").text(), "&Undo: Set radius");
  EXPECT_FALSE(listed("radius").contains("Edit: Undo"));
  EXPECT_EQ(listed("undo").value(0), "Edit: Undo");
}

TEST_F(PaletteWindowTest, FindsAPanelByWhatItShows) {
  open({writeFork("fork.mtg")});
  EXPECT_TRUE(listed("traits").contains("Evaluate: Evaluation"));
  EXPECT_TRUE(listed("scores").contains("Evaluate: Evaluation"));
}

TEST_F(MainWindowTest, ShowsItsShortcuts) {
  action("shortcuts").trigger();
  auto& sheet = find<QDialog>("shortcut_sheet");
  EXPECT_TRUE(sheet.isVisible());
  sheet.reject();
}

TEST_F(MainWindowTest, GivesEveryActionANameAndHelpAndNoKeyTwice) {
  std::map<QString, QString> owners;
  for (const QAction* each : window().actionSet().all()) {
    EXPECT_FALSE(each->text().isEmpty()) << each->objectName().toStdString();
    EXPECT_FALSE(each->statusTip().isEmpty()) << each->objectName().toStdString();
    for (const QKeySequence& keys : each->shortcuts()) {
      // On while all else on their key is off.
      if (QStringList{"accept", "remove_last_target", "take_branch", "drop_branch", "answer_1",
                      "answer_2", "answer_3", "answer_4", "skip_doubt", "take_back_answer"}
              .contains(each->objectName()))
        continue;
      const auto [owner, isNew] = owners.emplace(keys.toString(), each->objectName());
      EXPECT_TRUE(isNew) << keys.toString().toStdString() << ": " << owner->second.toStdString()
                         << " and " << each->objectName().toStdString();
    }
  }
}

TEST_F(MainWindowTest, HasMenusThatFitBelowEachOtherOnASmallScreen) {
  for (const QAction* each : window().menuBar()->actions()) {
    constexpr int room = 800 - 60; // of a screen, without the bar of the desktop and the menus
    EXPECT_LE(each->menu()->sizeHint().height(), room) << each->text().toStdString();
  }
}

TEST_F(MainWindowTest, HasALineInTheManualForEveryAction) {
  const QString manual = QString::fromStdString(test::manualText());
  const QRegularExpression pointSize("^\\d+ px$"); // one line is for all
  for (const QAction* each : window().actionSet().all()) {
    const QString name = each->text().remove('&');
    if (!pointSize.match(name).hasMatch()) {
      EXPECT_TRUE(manual.contains(name)) << name.toStdString();
    }
  }
}

} // namespace
} // namespace espalier
