// The program asks about what it is in doubt about, and takes answers by one key.
#include "tests/app/window/window_fixture.h"
#include "tests/support/shared_data.h"

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QToolButton>

#include <cmath>

namespace espalier {
namespace {

class AskingTest : public test::WindowTest {
protected:
  void SetUp() override {
    test::WindowTest::SetUp();
    window().resize(1280, 800);
    open({QString::fromStdString(
        (test::sourceFolder() / "resources/samples/young_tree.ply").string())});
    action("reconstruct").trigger();
    waitForJob();
    ASSERT_FALSE(document().skeleton().isEmpty());
  }

  void ask() {
    view().setFocus();
    key(Qt::Key_F2);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, 20'000));
  }

  bool isAsked() { return action("answer_1").isEnabled(); }
  QString question() { return find<QLabel>("doubts_question").text(); }
  int doubts() { // as the panel says, once it follows
    QTest::qWait(30);
    return find<QLabel>("doubts_title").text().split(' ').front().toInt();
  }
  QString firstAnswer() { return find<QToolButton>("answer_1_button").text(); }

  std::size_t reviewed() {
    const Skeleton& plant = document().skeleton();
    std::size_t count = 0;
    for (const NodeId id : plant.ids())
      count += plant[id].review.state == ReviewState::reviewed;
    return count;
  }
};

TEST_F(AskingTest, TakesAnswersByOneKeyEachAsOneUndoStep) {
  ask();
  const int steps = document().undoStack().index();
  const int before = doubts();
  EXPECT_TRUE(find<QLabel>("doubts_agreement").text().contains("of the length is right"));
  int answered = 0;
  for (; answered < 6 && isAsked(); ++answered) {
    const QString asked = question() + firstAnswer();
    key(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked() || doubts() == 0; }, 20'000));
  }
  EXPECT_EQ(answered, 6);
  EXPECT_LE(document().undoStack().index(), steps + answered);
  EXPECT_GT(document().undoStack().index(), steps);
  EXPECT_GT(reviewed(), 0U);
  EXPECT_LT(doubts(), before);
}

TEST_F(AskingTest, TakesAnswersBackAndAsksThemAgain) {
  ask();
  const Skeleton plant = document().skeleton();
  const QString asked = question() + firstAnswer();
  key(Qt::Key_2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, 20'000));
  EXPECT_NE(question() + firstAnswer(), asked);
  key(Qt::Key_Backspace);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, 20'000));
  EXPECT_EQ(question() + firstAnswer(), asked);
  EXPECT_EQ(document().skeleton(), plant);
  key(Qt::Key_Backspace); // there is no other: refused
  EXPECT_EQ(question() + firstAnswer(), asked);
}

TEST_F(AskingTest, SkipsAndComesBackToWhatWasSkipped) {
  ask();
  const QString asked = question() + firstAnswer();
  const int all = doubts();
  key(Qt::Key_Space);
  EXPECT_NE(question() + firstAnswer(), asked);
  for (int i = 1; i < all; ++i)
    key(Qt::Key_Space);
  EXPECT_EQ(question() + firstAnswer(), asked);
  EXPECT_EQ(doubts(), all);
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

TEST_F(AskingTest, MarksDoubtfulWhatNoneOfTheAnswersIsRightFor) {
  ask();
  while (document().selection().nodes().empty() ||
         question().startsWith("Is there a branch")) // of points there is no wood to mark
    key(Qt::Key_Space);
  const std::vector<NodeId> wood = document().selection().nodes();
  key(Qt::Key_0);
  for (const NodeId id : wood)
    EXPECT_EQ(document().skeleton()[id].review.state, ReviewState::doubtful);
  EXPECT_FALSE(isAsked()) << "it waits for an edit by hand";
  EXPECT_TRUE(question().startsWith("Correct it"));
  key(Qt::Key_Space);
  EXPECT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, 20'000));
}

TEST_F(AskingTest, TakesAnEditOfTheWoodForAnAnswer) {
  ask();
  while (question().startsWith("Is there a branch"))
    key(Qt::Key_Space);
  const NodeId node = document().selection().nodes().front();
  const QString asked = question() + firstAnswer();
  action("remove_subtree").trigger();
  ASSERT_FALSE(document().skeleton().contains(node));
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return isAsked() && question() + firstAnswer() != asked; }, 20'000));
}

TEST_F(AskingTest, TakesNoUndoForAnAnswer) {
  ask();
  const int before = doubts();
  const Skeleton plant = document().skeleton();
  for (int i = 0; i < 2; ++i) {
    key(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, 20'000));
  }
  while (document().skeleton() != plant) {
    action("undo").trigger();
    QTest::qWait(100);
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return doubts() == before; }, 20'000)) << doubts();
}

TEST_F(AskingTest, GoesOnWhereWhatItAsksIsMarkedReviewed) {
  ask();
  while (question().startsWith("Is there a branch"))
    key(Qt::Key_Space);
  const QString asked = question() + firstAnswer();
  action("mark_all_selected").trigger();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return isAsked() && question() + firstAnswer() != asked; }, 20'000));
}

TEST_F(AskingTest, EndsWhereThePlantIsReadOnly) {
  ask();
  document().setReadOnly("it is signed");
  EXPECT_FALSE(isAsked());
  EXPECT_FALSE(action("ask_doubts").isEnabled());
  EXPECT_FALSE(action("select_downstream").shortcuts().isEmpty());
}

TEST_F(AskingTest, KeepsWhatWasAnsweredInTheProject) {
  const QString file = path("tree.espalier");
  answer(chooseFile(file), [this] { action("save_project_as").trigger(); });
  waitForJob();
  ask();
  for (int i = 0; i < 3; ++i) {
    key(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, 20'000));
  }
  const int left = doubts();
  const Skeleton plant = document().skeleton();
  open({file});
  EXPECT_EQ(document().skeleton(), plant);
  ask();
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(doubts() - left) <= 1; }, 20'000)) << doubts();
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

} // namespace
} // namespace espalier
