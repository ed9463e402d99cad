// What asking leaves behind: keys, the selection, and what the odds decide of the rest.
#include "app/window/frame/action_set.h"
#include "app/window/review/asking_flow.h"
#include "tests/app/window/asking_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

#include <QApplication>
#include <QDialog>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using test::AskingTest;

TEST_F(AskingTest, GivesBackWhatWasSelectedBefore) {
  const NodeId root = document().skeleton().roots().front();
  for (const std::vector<NodeId>& before : {std::vector<NodeId>{}, std::vector<NodeId>{root}}) {
    document().selection().set(before);
    ask();
    key(Qt::Key_Space);
    ASSERT_NE(document().selection().nodes(), before);
    key(Qt::Key_Escape);
    EXPECT_EQ(document().selection().nodes(), before);
  }
  ask();
  const NodeId chosen = document().skeleton().ids().back(); // by hand meanwhile
  document().selection().set({chosen});
  key(Qt::Key_Escape);
  EXPECT_EQ(document().selection().nodes(), std::vector{chosen});
}

// The list beside the question is still of the plant that goes.
TEST_F(AskingTest, EndsWithThePlantItAsksAbout) {
  action("show_findings").setChecked(true);
  ask();
  document().undoStack().setClean();
  action("close_plant").trigger();
  EXPECT_FALSE(isAsked());
  EXPECT_TRUE(found().doubts().empty());
  EXPECT_FALSE(window().statusLine().shownText().contains("in doubt"))
      << window().statusLine().shownText().toStdString();
}

TEST_F(AskingTest, EndsWhereAnotherPlantIsOpened) {
  action("show_findings").setChecked(true);
  ask();
  document().undoStack().setClean();
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(isAsked());
  for (const Doubt& doubt : found().doubts()) // of the plant that is there now
    EXPECT_TRUE(document().skeleton().contains(doubt.node));
}

TEST_F(AskingTest, SaysWhatAKeyHasDoneMeanwhile) {
  ask();
  skipTo(Doubt::Kind::end);
  const NodeId node = document().selection().nodes().front();
  waitForView();
  key(Qt::Key_T); // on the wood that is asked about: it answers, and the next is asked
  const std::string done =
      document().undoStack().text(document().undoStack().index() - 1).toStdString();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return isAsked() && document().selection().nodes().front() != node; }, patience));
  EXPECT_TRUE(window().statusLine().shownText().startsWith(QString::fromStdString(done)))
      << window().statusLine().shownText().toStdString();
}

TEST_F(AskingTest, UndoDropsWhatTheOddsWouldDecide) {
  ask();
  answerNoWood();
  key(Qt::Key_Escape);
  const Skeleton plant = document().skeleton();
  const int steps = document().undoStack().index();
  action("decide_rest").trigger();
  ASSERT_TRUE(window().part<AskingFlow>().isRestShown());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window().part<AskingFlow>().isRestShown());
  EXPECT_EQ(document().skeleton(), plant);
  EXPECT_EQ(document().undoStack().index(), steps);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().undoStack().index(), steps - 1);
}

TEST_F(AskingTest, HasItsKeysWhileItAsksAndGivesThemBack) {
  const auto keysOf = [this](const char* id) { return action(id).shortcuts(); };
  const QList<QKeySequence> of1 = keysOf("select_downstream");
  const QList<QKeySequence> ofSpace = keysOf("extend_again");
  ask();
  for (const QAction* other : window().actionSet().all())
    if (!other->objectName().startsWith("answer_"))
      for (const int digit : {Qt::Key_0, Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4}) {
        EXPECT_FALSE(other->shortcuts().contains(QKeySequence(digit)))
            << other->objectName().toStdString();
      }
  key(Qt::Key_Escape);
  EXPECT_FALSE(isAsked());
  EXPECT_EQ(keysOf("extend_again"), ofSpace);
  EXPECT_EQ(keysOf("select_downstream"), of1);
}

// All that makes asking end, one after another.
TEST_F(AskingTest, GivesItsKeysBackHoweverItEnds) {
  std::map<QString, QList<QKeySequence>> before;
  for (const QAction* each : window().actionSet().all())
    before[each->objectName()] = each->shortcuts();
  const auto addStop = [this] { action("stop_asking").trigger(); };
  const std::vector<std::pair<std::string, std::function<void()>>> ends = {
      {"the key", [this] { key(Qt::Key_Escape); }},
      {"the command", addStop},
      {"what the odds decide", [this] { action("decide_rest").trigger(); }},
      {"the sheet of keys",
       [this] {
         action("shortcuts").trigger();
         auto& sheet = find<QDialog>("shortcut_sheet");
         QStringList rows;
         for (const QLabel* label : sheet.findChildren<QLabel*>())
           rows.append(label->text());
         EXPECT_TRUE(rows.contains(action("extend_again").text())) << rows.join('|').toStdString();
         sheet.close();
         QTest::qWait(20);
         QApplication::setActiveWindow(&window());
       }},
      {"points that are set aside",
       [this] {
         document().pointSelection().set(PointSet::of({0, 1, 2}));
         action("set_points_aside").trigger();
       }},
      {"a job",
       [this] {
         action("reconstruct").trigger();
         waitForJob();
       }},
      {"a plant that is read-only", [this] { document().setReadOnly("it is signed"); }}};
  for (const auto& [what, end] : ends) {
    ask();
    ASSERT_TRUE(action("extend_again").shortcuts().isEmpty()) << what;
    EXPECT_TRUE(window().statusLine().shownText().contains("Esc")) << what;
    end();
    QTest::qWait(20);
    EXPECT_FALSE(isAsked()) << what;
    for (const QAction* each : window().actionSet().all())
      EXPECT_EQ(each->shortcuts(), before[each->objectName()])
          << what << ": " << each->objectName().toStdString();
    key(Qt::Key_Escape);
  }
}

TEST_F(AskingTest, EndsWhereThePlantIsReadOnly) {
  ask();
  document().setReadOnly("it is signed");
  EXPECT_FALSE(isAsked());
  EXPECT_FALSE(action("ask_doubts").isEnabled());
  EXPECT_FALSE(action("select_downstream").shortcuts().isEmpty());
}

TEST_F(AskingTest, ShowsWhatTheOddsWouldDecideBeforeItIsMade) {
  ask();
  key(Qt::Key_Escape);
  const Skeleton plant = document().skeleton();
  const int steps = document().undoStack().index();
  action("decide_rest").trigger();
  EXPECT_EQ(document().skeleton(), plant);
  key(Qt::Key_Escape);
  EXPECT_EQ(document().undoStack().index(), steps);
  action("decide_rest").trigger();
  action("decide_rest").trigger();
  EXPECT_LE(document().undoStack().index(), steps + 1) << "all as one step";
}

TEST_F(AskingTest, MakesAsManyChangesByTheOddsAsItShows) {
  ask();
  answerNoWood();
  key(Qt::Key_Escape);
  const auto numberIn = [](const QString& text) { return text.split(' ').front().toInt(); };
  action("decide_rest").trigger();
  const int shown = numberIn(window().statusLine().shownText());
  ASSERT_GT(shown, 0) << window().statusLine().shownText().toStdString();
  action("decide_rest").trigger();
  EXPECT_EQ(numberIn(window().banner().text()), shown) << window().banner().text().toStdString();
}

TEST_F(AskingTest, ItsAnswersAreCountedWhereThePlantIsSigned) {
  const auto questions = [this] { // what the dialog that signs says of them
    action("select_all").trigger();
    action("mark_all_selected").trigger();
    QString text;
    const auto read = [&](QDialog& dialog) {
      for (const auto* label : dialog.findChildren<QLabel*>())
        if (label->text().contains(" answered")) text = label->text();
      dialog.reject();
    };
    answer(read, [this] {
      action("sign_structure").trigger();
      waitForJob();
    });
    return text;
  };
  EXPECT_EQ(questions(), "0 answered") << "what is in doubt was not sought";
  key(Qt::Key_Z, Qt::ControlModifier);
  ask();
  keyOnceDrawn(Qt::Key_1);
  EXPECT_GT(doubts(), 0);
  EXPECT_EQ(questions(), "1 answered, 0 open") << "what is reviewed is not asked about";
}

} // namespace
} // namespace espalier
