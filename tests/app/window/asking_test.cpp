// The program asks about what it is in doubt about, and takes answers by one key.
#include "app/window/files/load_files.h"
#include "app/window/review/asking_flow.h"
#include "app/window/view/shown_flow.h"
#include "core/project/project.h"
#include "tests/app/window/asking_fixture.h"
#include "ui/document/doubt_text.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"

#include <QFile>
#include <QRegularExpression>
#include <QTreeView>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {
namespace {

using test::AskingTest;

TEST_F(AskingTest, TakesAnswersByOneKeyEachAsOneUndoStep) {
  ask();
  const int steps = document().undoStack().index();
  const int before = doubts();
  EXPECT_TRUE(find<QLabel>("doubts_agreement").text().contains("of the length is right"));
  int answered = 0;
  for (; answered < 6 && isAsked(); ++answered) {
    const QString asked = question() + firstAnswer();
    keyOnceDrawn(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked() || doubts() == 0; }, patience));
  }
  EXPECT_EQ(answered, 6);
  EXPECT_LE(document().undoStack().index(), steps + answered);
  EXPECT_GT(document().undoStack().index(), steps);
  EXPECT_GT(reviewed(), 0U);
  EXPECT_LT(doubts(), before);
}

TEST_F(AskingTest, AKeyDoesNotAnswerWhatIsNotDrawnYet) {
  ask();
  waitForView();
  key(Qt::Key_1);
  const std::string answered = answers();
  ASSERT_TRUE(QTest::qWaitFor([&] { return isAsked() && !found().isBusy(); }, patience));
  key(Qt::Key_Space);
  for (const int digit : {Qt::Key_1, Qt::Key_0})
    key(digit); // before anything is drawn
  EXPECT_EQ(answers(), answered);
  EXPECT_TRUE(isAsked());
  EXPECT_EQ(window().statusLine().shownText(),
            "Not answered: the question was not drawn yet. Answer it now");
  EXPECT_EQ(view().currentCamera(), view().camera()) << "it is there at once";
  keyOnceDrawn(Qt::Key_1);
  EXPECT_NE(answers(), answered);
}

TEST_F(AskingTest, EnterShowsTheQuestionAgainAndMarksNothing) {
  ask();
  waitForView();
  const QString asked = question();
  const Camera there = view().camera();
  key(Qt::Key_Home);
  waitForView();
  ASSERT_FALSE(view().camera() == there);
  key(Qt::Key_Return);
  waitForView();
  EXPECT_TRUE(isAsked());
  EXPECT_EQ(question(), asked);
  EXPECT_TRUE(view().camera() == there);
  for (const NodeId id : document().skeleton().ids())
    EXPECT_EQ(document().skeleton()[id].review.state, ReviewState::toDo);
}

TEST_F(AskingTest, NamesTheKeyThatEndsItOnceWhereAPanelHasTheKeyboard) {
  ask();
  find<QTreeView>("findings_list").setFocus();
  QStringList hints;
  const auto isHint = [&] { // notes end
    hints = window().statusLine().shownText().split("   ");
    return hints.contains("Shift+Esc next panel");
  };
  ASSERT_TRUE(QTest::qWaitFor(isHint, patience));
  EXPECT_EQ(hints.count("Esc ends"), 1);
  EXPECT_EQ(hints.filter(QRegularExpression("^Esc ")).size(), 1);
}

TEST_F(AskingTest, TheFirstKeyLeavesThePlantAsItIsWhateverIsAsked) {
  removeBranches();
  ask();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !found().isBusy(); }, patience));
  const auto isOtherLikelier = [](const Doubt& one) { return one.present > 0; };
  ASSERT_TRUE(std::ranges::any_of(found().doubts(), isOtherLikelier));
  std::map<Doubt::Kind, int> kinds;
  const auto wood = [this] { // without what an answer marks
    std::vector<std::pair<Eigen::Vector3d, std::optional<NodeId>>> nodes;
    for (const NodeId id : document().skeleton().ids())
      nodes.emplace_back(document().skeleton()[id].position, document().skeleton()[id].parent);
    return nodes;
  };
  const auto before = wood();
  for (int i = 0; i < 30 && isAsked(); ++i) {
    const bool isMissing = question().startsWith("Is there a branch");
    EXPECT_TRUE(firstAnswer().startsWith(isMissing ? "1  no branch" : "1  as it is"))
        << firstAnswer().toStdString();
    EXPECT_TRUE(window().part<AskingFlow>().hint().startsWith(isMissing ? "1 no branch   2 "
                                                                        : "1 as it is   2 "));
    ++kinds[isMissing ? Doubt::Kind::missing : Doubt::Kind::end];
    keyOnceDrawn(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked() || doubts() == 0; }, patience));
    ASSERT_EQ(wood(), before);
  }
  EXPECT_EQ(kinds.size(), 2U) << "branches that are there, and that are missing";
}

TEST_F(AskingTest, TakesAnswersBackAndAsksThemAgain) {
  ask();
  const Skeleton plant = document().skeleton();
  const QString asked = question() + firstAnswer();
  keyOnceDrawn(Qt::Key_2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  EXPECT_NE(question() + firstAnswer(), asked);
  key(Qt::Key_Backspace);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
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

TEST_F(AskingTest, MarksDoubtfulWhatNoneOfTheAnswersIsRightFor) {
  ask();
  skipTo(Doubt::Kind::missing, false);
  const std::vector<NodeId> wood = document().selection().nodes();
  keyOnceDrawn(Qt::Key_0);
  for (const NodeId id : wood)
    EXPECT_EQ(document().skeleton()[id].review.state, ReviewState::doubtful);
  EXPECT_FALSE(isAsked()) << "it waits for an edit by hand";
  EXPECT_TRUE(question().startsWith("Correct it"));
  key(Qt::Key_Space);
  EXPECT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
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
      QTest::qWaitFor([&] { return isAsked() && question() + firstAnswer() != asked; }, patience));
}

TEST_F(AskingTest, TakesNoUndoForAnAnswer) {
  ask();
  const int before = doubts();
  const Skeleton plant = document().skeleton();
  for (int i = 0; i < 2; ++i) {
    keyOnceDrawn(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  }
  while (document().skeleton() != plant) {
    action("undo").trigger();
    QTest::qWait(100);
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return doubts() == before; }, patience)) << doubts();
}

TEST_F(AskingTest, GoesOnWhereWhatItAsksIsMarkedReviewed) {
  ask();
  while (question().startsWith("Is there a branch"))
    key(Qt::Key_Space);
  const QString asked = question() + firstAnswer();
  action("mark_all_selected").trigger();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return isAsked() && question() + firstAnswer() != asked; }, patience));
}

TEST_F(AskingTest, KeepsWhatWasAnsweredInTheProject) {
  const QString file = path("tree.espalier");
  answer(chooseFile(file), [this] { action("save_project_as").trigger(); });
  waitForJob();
  ask();
  for (int i = 0; i < 3; ++i) {
    keyOnceDrawn(Qt::Key_1);
    ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  }
  const int left = doubts();
  const Skeleton plant = document().skeleton();
  open({file});
  EXPECT_EQ(document().skeleton(), plant);
  ask();
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(doubts() - left) <= 1; }, patience))
      << doubts();
}

TEST_F(AskingTest, MarksDoubtfulWhatWouldBearABranchThatIsMissing) {
  removeBranches();
  ask();
  skipTo(Doubt::Kind::missing);
  const NodeId bearer = document().selection().nodes().front();
  const int steps = document().undoStack().index();
  const QString asked = question();
  keyOnceDrawn(Qt::Key_0);
  EXPECT_EQ(document().undoStack().index(), steps + 1);
  EXPECT_EQ(document().skeleton()[bearer].review.state, ReviewState::doubtful);
  EXPECT_TRUE(answers().find("missing") != std::string::npos) << answers();
  key(Qt::Key_Backspace);
  EXPECT_EQ(document().skeleton()[bearer].review.state, ReviewState::toDo);
  EXPECT_EQ(question(), asked);
}

TEST_F(AskingTest, TakesNoRadiusForAnAnswer) {
  ask();
  skipTo(Doubt::Kind::missing, false);
  const NodeId node = document().selection().nodes().front();
  const QString asked = question();
  document().edit("Radius", [&](SkeletonEditor& editor) {
    editor.setRadius(node, 1.01 * document().skeleton()[node].radius);
  });
  QTest::qWait(200);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !found().isBusy() && isAsked(); }, patience));
  EXPECT_EQ(answers(), "");
  EXPECT_EQ(question(), asked);
}

TEST_F(AskingTest, LearnsThatWoodIsRightWhichIsMovedAndWrongWhichIsRemoved) {
  ask();
  skipTo(Doubt::Kind::end);
  const NodeId moved = document().selection().nodes().back();
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(moved, document().skeleton()[moved].position + Eigen::Vector3d(0, 0, 0.001));
  });
  ASSERT_TRUE(QTest::qWaitFor([this] { return !answers().empty() && isAsked(); }, patience));
  EXPECT_TRUE(answers().find("\"wrong\":false") != std::string::npos) << answers();
  skipTo(Doubt::Kind::end);
  action("remove_subtree").trigger();
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return answers().find("\"wrong\":true") != std::string::npos; }, patience))
      << answers();
}

TEST_F(AskingTest, AsksAgainWhatWasToBeCorrectedByHandOnceThatIsUndone) {
  ask();
  skipTo(Doubt::Kind::end);
  const NodeId node = document().selection().nodes().back();
  const QString asked = question() + firstAnswer();
  keyOnceDrawn(Qt::Key_0);
  ASSERT_FALSE(isAsked());
  document().edit("Move", [&](SkeletonEditor& editor) {
    editor.setPosition(node, document().skeleton()[node].position + Eigen::Vector3d(0, 0, 0.001));
  });
  QTest::qWait(200);
  key(Qt::Key_Z, Qt::ControlModifier);
  QTest::qWait(200);
  EXPECT_FALSE(isAsked()) << "none of the answers is right still";
  EXPECT_TRUE(question().startsWith("Correct it"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  EXPECT_EQ(question() + firstAnswer(), asked);
  QTest::qWait(200);
  EXPECT_EQ(question() + firstAnswer(), asked);
  EXPECT_EQ(answers().find("\"step\":\"0\""), std::string::npos);
}

TEST_F(AskingTest, GoesStraightToTheDoubtThatIsClicked) {
  key(Qt::Key_F2, Qt::ShiftModifier);
  auto& list = find<QTreeView>("findings_list");
  ASSERT_TRUE(QTest::qWaitFor([&] { return found().isKnown(); }, patience));
  std::vector<std::vector<NodeId>> gone;
  QObject::connect(&document().selection(), &Selection::changed, &view(),
                   [&] { gone.push_back(document().selection().nodes()); });
  const Doubt last = found().doubts().back();
  QModelIndex row;
  for (int i = 0; i < list.model()->rowCount() && !row.isValid(); ++i) {
    const QModelIndex at = list.model()->index(i, 0);
    const bool isOfWood =
        at.data(Qt::ToolTipRole).toString().startsWith(questionOf(last, document().unit()));
    const QString node = QString("\n%1 ·").arg(indexOf(last.node));
    if (isOfWood && at.data().toString().contains(node)) row = at;
  }
  ASSERT_TRUE(row.isValid());
  list.scrollTo(row);
  QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(row).center());
  EXPECT_TRUE(isAsked());
  EXPECT_EQ(gone.size(), 1U) << "it went somewhere else first";
  EXPECT_EQ(document().selection().nodes().front(),
            last.nodes.empty() ? last.node : last.nodes.front());
}

TEST_F(AskingTest, ShowsThatTheShareIsOfThePlantBefore) {
  ask();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !found().isBusy(); }, patience));
  QTest::qWait(30);
  const auto& share = find<QLabel>("doubts_agreement");
  ASSERT_TRUE(share.isEnabled());
  skipTo(Doubt::Kind::end);
  action("remove_subtree").trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !share.isEnabled(); }, patience)) << "it is not of now";
  EXPECT_TRUE(share.text().contains("of the length is right"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return share.isEnabled(); }, patience));
}

TEST_F(AskingTest, SaysThatTheSearchFailedAndSearchesAgain) {
  key(Qt::Key_F2, Qt::ShiftModifier);
  ASSERT_TRUE(QTest::qWaitFor([this] { return found().isKnown(); }, patience));
  auto* job = found().findChild<JobSlot*>();
  ASSERT_NE(job, nullptr);
  const auto& note = find<QLabel>("findings_note");
  const auto touch = [this] {
    const NodeId node = document().skeleton().roots().front();
    document().edit("Move", [&](SkeletonEditor& editor) {
      editor.setPosition(node, document().skeleton()[node].position + Eigen::Vector3d(0, 0, 1e-4));
    });
  };
  touch();
  ASSERT_TRUE(QTest::qWaitFor([&] { return job->isBusy(); }, patience));
  job->cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !job->isBusy(); }, patience));
  QTest::qWait(50);
  EXPECT_EQ(note.text(), "The search for doubts did not end: it was stopped. F2 searches again");
  ask();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !found().isBusy() && !note.isVisible(); }, patience));
  EXPECT_EQ(found().failure(), "");
  key(Qt::Key_Escape);
  emit job->failed("no memory is left");
  emit job->finished();
  QTest::qWait(50);
  EXPECT_EQ(note.text(), "The search for doubts did not end: no memory is left. F2 searches again");
  touch();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !note.isVisible() && !found().isBusy(); }, patience))
      << "an edit has it searched again";
}

TEST_F(AskingTest, WritesAnAnswerThatChangesNothingAtOnce) {
  const QString file = path("tree.espalier");
  answer(chooseFile(file), [this] { action("save_project_as").trigger(); });
  waitForJob();
  removeBranches();
  ask();
  skipTo(Doubt::Kind::missing);
  QTest::qWait(500); // all else is written
  const int steps = document().undoStack().index();
  const int noBranch = find<QToolButton>("answer_1_button").text().contains("no branch") ? 1 : 2;
  waitForView();
  action(QString("answer_%1").arg(noBranch)).trigger(); // no event is handled from here on
  ASSERT_EQ(document().undoStack().index(), steps);
  for (const char* end : {"", "-wal"}) // as they lie there when the program is killed now
    ASSERT_TRUE(QFile::copy(file + end, path("killed.espalier") + end));
  const Project left = Project::open(toPath(path("killed.espalier")), Access::readOnly);
  EXPECT_TRUE(left.document("answered_doubts").find("missing") != std::string::npos)
      << left.document("answered_doubts");
}

TEST_F(AskingTest, ShowsTheWoodThatAnswersNameWhereOthersAreHidden) {
  ask();
  skipTo(Doubt::Kind::end, false);
  const Doubt asked = *std::ranges::find_if(found().doubts(), [](const Doubt& one) {
    return one.kind == Doubt::Kind::attachment &&
           std::ranges::any_of(one.alternatives,
                               [](const Alternative& answer) { return answer.onto.has_value(); });
  });
  key(Qt::Key_Escape);
  document().selection().set(asked.nodes);
  action("isolate").trigger();
  ASSERT_FALSE(window().part<ShownFlow>().hidden().empty());
  document().selection().clear();
  view().setFocus();
  key(Qt::Key_F2);
  const auto isAskedAbout = [&] {
    const auto& selected = document().selection().nodes();
    return std::ranges::find(selected, asked.node) != selected.end();
  };
  for (int i = 0; i < 500 && !isAskedAbout(); ++i)
    key(Qt::Key_Space);
  ASSERT_TRUE(isAskedAbout());
  const std::vector<NodeId>& hidden = window().part<ShownFlow>().hidden();
  for (const Alternative& answer : asked.alternatives) {
    if (!answer.onto) continue;
    EXPECT_EQ(std::ranges::find(hidden, *answer.onto), hidden.end()) << nameOf(*answer.onto);
  }
}

/// All points at one place, beside a plant of one edge.
struct AskingNothingTest : test::WindowTest {};

TEST_F(AskingNothingTest, SaysThatNothingFollowsFromPointsAtOnePlace) {
  open({writeFork("fork.mtg")});
  RawPoints points;
  points.positions.assign(50, Eigen::Vector3d(0, 0, 1));
  document().setScan(std::make_unique<Scan>(PointCloud(points)), "place.xyz");
  ASSERT_EQ(document().scale().spacing, 0);
  key(Qt::Key_F2, Qt::ShiftModifier);
  QTest::qWait(300);
  EXPECT_EQ(find<QLabel>("findings_note").text(),
            "All points of the scan lie at one place: nothing can be asked about");
  key(Qt::Key_F2);
  EXPECT_TRUE(window().banner().text().contains("All points of the scan lie at one place"))
      << window().banner().text().toStdString();
  EXPECT_FALSE(window().part<DoubtsFlow>().isBusy());
}

} // namespace
} // namespace espalier
