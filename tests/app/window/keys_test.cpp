#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "ui/dialogs/key_edit.h"
#include "ui/panels/status_line.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

namespace espalier {
namespace {

struct KeysWindowTest : test::WindowTest {
  QDialog& sheet() { return find<QDialog>("shortcut_sheet"); }
  /// Opens the dialog for a command by a click on its keys in the sheet.
  void change(const QString& id) {
    action("shortcuts").trigger();
    clickButton("keys_of_" + id);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&find<KeyEdit>("new_keys"), key, modifiers);
  }
  void close() {
    find<QDialog>("keys_dialog").reject();
    sheet().reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  QString note() { return find<QLabel>("keys_note").text(); }
  QString keysOf(const QString& id) { return action(id).shortcut().toString(); }
};

TEST_F(KeysWindowTest, TheSheetChangesTheKeysOfACommand) {
  change("new_child");
  press(Qt::Key_F13);
  EXPECT_EQ(note(), "");
  clickButton("set_keys");
  EXPECT_EQ(keysOf("new_child"), "F13");
  EXPECT_EQ(sheet().findChild<QPushButton*>("keys_of_new_child")->text(), "F13");
  EXPECT_TRUE(action("new_child").toolTip().contains("&nbsp; F13<"))
      << action("new_child").toolTip().toStdString();
}

TEST_F(KeysWindowTest, TheNewKeyWorksAndTheOldOneNoMore) {
  open({writeFork("fork.mtg")});
  change("new_child");
  press(Qt::Key_F13);
  clickButton("set_keys");
  close();
  document().selection().set({test::forkTop});
  key(Qt::Key_N);
  EXPECT_EQ(document().skeleton().size(), 5U);
  key(Qt::Key_F13);
  EXPECT_EQ(document().skeleton().size(), 6U);
}

TEST_F(KeysWindowTest, IsDoneByKeysAlone) {
  action("shortcuts").trigger();
  for (auto* button : sheet().findChildren<QPushButton*>())
    if (button->text() == "Change Keys…") button->click();
  const auto keyboard = [this] { return find<QDialog>("keys_dialog").focusWidget(); };
  EXPECT_EQ(keyboard(), &find<QLineEdit>("keys_filter")) << "no command was chosen";
  find<QDialog>("keys_dialog").reject();
  sheet().reject();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  change("new_child");
  EXPECT_EQ(keyboard(), &find<KeyEdit>("new_keys"));
  press(Qt::Key_F13);
  auto& set = find<QPushButton>("set_keys");
  set.setFocus(Qt::TabFocusReason);
  QTest::keyClick(&set, Qt::Key_Return);
  EXPECT_EQ(keysOf("new_child"), "F13");
  EXPECT_EQ(keyboard(), &find<QTreeWidget>("keys_list")) << "not what takes them away again";
}

TEST_F(KeysWindowTest, HintsNameTheNewKey) {
  open({writeFork("fork.mtg")});
  hover(placeOf(test::forkTop));
  EXPECT_TRUE(window().statusLine().shownText().contains("N new child"));
  change("new_child");
  press(Qt::Key_F13);
  clickButton("set_keys");
  close();
  hover(placeOf(test::forkTop)); // a dialog may have taken the pointer away
  EXPECT_TRUE(window().statusLine().shownText().contains("F13 new child"))
      << window().statusLine().shownText().toStdString();
}

// What was measured stays shown, wherever the pointer is: the hint itself follows the keys.
TEST_F(KeysWindowTest, AHintThatIsShownFollowsTheKeys) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_I);
  click(placeOf(nodeAt({0, 0, 0})));
  click(placeOf(test::forkTop));
  EXPECT_TRUE(window().statusLine().shownText().contains("Ctrl+C copy"));
  change("copy");
  press(Qt::Key_F13);
  clickButton("set_keys");
  EXPECT_TRUE(window().statusLine().shownText().contains("F13 copy"))
      << window().statusLine().shownText().toStdString();
}

TEST_F(KeysWindowTest, KeysOfAnotherCommandAreNamedAndMoved) {
  change("new_child");
  press(Qt::Key_T);
  EXPECT_EQ(note(), "T is used for “Stick to Points”, which would lose it");
  EXPECT_EQ(keysOf("stick"), "T") << "until one says so";
  EXPECT_EQ(find<QPushButton>("set_keys").text(), "Move Here");
  clickButton("set_keys");
  EXPECT_EQ(keysOf("new_child"), "T");
  EXPECT_EQ(keysOf("stick"), "");
}

TEST_F(KeysWindowTest, EscapeStaysWithItsCommand) {
  change("new_child");
  press(Qt::Key_Escape);
  EXPECT_EQ(note(), "Esc stays with “Leave”: press others");
  EXPECT_FALSE(find<QPushButton>("set_keys").isEnabled());
  auto* list = &find<QTreeWidget>("keys_list");
  list->setCurrentItem(list->findItems("Leave", Qt::MatchExactly | Qt::MatchRecursive).value(0));
  EXPECT_FALSE(find<QPushButton>("clear_keys").isEnabled());
}

TEST_F(KeysWindowTest, ShiftAloneIsNoKeyAndASignIsNamedAsItself) {
  change("new_child");
  press(Qt::Key_Shift, Qt::ShiftModifier);
  EXPECT_FALSE(find<QPushButton>("set_keys").isEnabled());
  press(Qt::Key_Exclam, Qt::ShiftModifier);
  clickButton("set_keys");
  EXPECT_EQ(keysOf("new_child"), "!");
}

TEST_F(KeysWindowTest, KeysAreKept) {
  change("undo");
  press(Qt::Key_U, Qt::ControlModifier);
  clickButton("set_keys");
  close();
  change("stick");
  clickButton("clear_keys");
  restart();
  EXPECT_EQ(keysOf("undo"), "Ctrl+U");
  EXPECT_EQ(keysOf("stick"), "");
  EXPECT_EQ(keysOf("redo"), "Ctrl+Shift+Z");
}

TEST_F(KeysWindowTest, OneIsResetAndTakesItsKeyBack) {
  change("new_child");
  press(Qt::Key_T);
  clickButton("set_keys");
  auto* list = &find<QTreeWidget>("keys_list");
  list->setCurrentItem(
      list->findItems("Stick to Points", Qt::MatchExactly | Qt::MatchRecursive).value(0));
  clickButton("reset_keys");
  EXPECT_EQ(keysOf("stick"), "T");
  EXPECT_EQ(keysOf("new_child"), "");
  EXPECT_FALSE(find<QPushButton>("reset_keys").isEnabled());
}

TEST_F(KeysWindowTest, AllAreReset) {
  const QList<QKeySequence> redo = action("redo").shortcuts();
  change("redo");
  press(Qt::Key_T);
  clickButton("set_keys");
  EXPECT_EQ(action("redo").shortcuts().size(), 1);
  clickButton("reset_all_keys");
  EXPECT_EQ(keysOf("stick"), "T");
  EXPECT_EQ(action("redo").shortcuts(), redo) << "the second key as well";
  EXPECT_FALSE(find<QPushButton>("reset_all_keys").isEnabled());
  restart();
  EXPECT_EQ(action("redo").shortcuts(), redo);
}

TEST_F(KeysWindowTest, TheListIsFilteredByNameAndByKey) {
  action("shortcuts").trigger();
  clickButton("keys_of_new_child");
  auto& list = find<QTreeWidget>("keys_list");
  const auto shown = [&] {
    QStringList names;
    for (QTreeWidgetItemIterator at(&list, QTreeWidgetItemIterator::NotHidden |
                                               QTreeWidgetItemIterator::NoChildren);
         *at != nullptr; ++at)
      names.append((*at)->text(0));
    return names;
  };
  QTest::keyClicks(&find<QLineEdit>("keys_filter"), "stick to");
  EXPECT_EQ(shown(), QStringList{"Stick to Points"});
  find<QLineEdit>("keys_filter").clear();
  QTest::keyClicks(&find<QLineEdit>("keys_filter"), "ctrl+z");
  EXPECT_EQ(shown(), QStringList{"Undo"});
}

// Hints and the manual say Enter, whichever of the two it is.
TEST_F(KeysWindowTest, BothEntersAreNamedEnter) {
  action("shortcuts").trigger();
  EXPECT_EQ(sheet().findChild<QPushButton*>("keys_of_accept")->text(), "Enter");
  EXPECT_EQ(sheet().findChild<QPushButton*>("keys_of_mark_doubtful")->text(), "Shift+Enter");
  EXPECT_EQ(sheet().findChild<QPushButton*>("keys_of_accept_reference")->text(), "Ctrl+Enter");
  EXPECT_TRUE(action("accept_reference").shortcuts().contains(Qt::CTRL | Qt::Key_Return));
}

TEST_F(KeysWindowTest, AHintWithoutAKeyIsLeftOut) {
  const ActionSet& actions = window().actionSet();
  EXPECT_EQ(withKeys("Drag: turn   {new_child} new child   Esc: leave", actions),
            "Drag: turn   N new child   Esc: leave");
  action("new_child").setShortcut({});
  EXPECT_EQ(withKeys("Drag: turn   {new_child} new child   Esc: leave", actions),
            "Drag: turn   Esc: leave");
  EXPECT_EQ(withKeys("as it is", actions), "as it is");
}

/// A press of the key of the row above the letters that has this number, from 10 for that of 1.
QKeyEvent pressOfRow(quint32 number, Qt::Key types, Qt::KeyboardModifiers modifiers = {}) {
  return {QEvent::KeyPress, types, modifiers, number, 0, 0, QString()};
}

// On a French keyboard digits need Shift.
TEST_F(KeysWindowTest, TheRowOfDigitsNeedsNoShift) {
  open({writeFork("fork.mtg")});
  QAction& command = action("select_downstream");
  ASSERT_EQ(command.shortcut(), QKeySequence(Qt::Key_1));
  QSignalSpy run(&command, &QAction::triggered);
  const auto isRun = [&](QKeyEvent press, QWidget& at) {
    run.clear();
    at.setFocus();
    QApplication::sendEvent(&at, &press);
    return !run.isEmpty();
  };
  EXPECT_TRUE(isRun(pressOfRow(10, Qt::Key_Ampersand), view()));
  EXPECT_FALSE(isRun(pressOfRow(24, Qt::Key_Ampersand), view())) << "another key";
  EXPECT_FALSE(isRun(pressOfRow(10, Qt::Key_Ampersand, Qt::AltModifier), view()));
  QLineEdit field(&window());
  field.show();
  EXPECT_FALSE(isRun(pressOfRow(10, Qt::Key_Ampersand), field)) << "it is typed there";
  command.setEnabled(false);
  EXPECT_FALSE(isRun(pressOfRow(10, Qt::Key_Ampersand), view()));
}

TEST_F(KeysWindowTest, HomeAndEndGoThroughAListThatHasTheKeyboard) {
  open({writeFork("fork.mtg")});
  for (int i = 0; i < 3; ++i)
    edit();
  action("show_history").setChecked(true);
  auto& list = find<QAbstractItemView>("history_list");
  list.setFocus();
  const auto isOfList = [&](Qt::Key key) { // rather than of a command
    QKeyEvent press(QEvent::ShortcutOverride, key, Qt::NoModifier);
    press.ignore();
    QApplication::sendEvent(&list, &press);
    return press.isAccepted();
  };
  for (const Qt::Key key : {Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown})
    EXPECT_TRUE(isOfList(key)) << key;
  EXPECT_FALSE(isOfList(Qt::Key_F4));
}

} // namespace
} // namespace espalier
