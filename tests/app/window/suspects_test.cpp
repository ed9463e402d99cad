// One list of all that may be wrong: findings of the checks and doubts.
#include "app/window/edit/editing.h"
#include "tests/app/window/suspects_fixture.h"
#include "ui/document/doubt_text.h"
#include "ui/panels/message_banner.h"

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>
#include <QTreeView>

#include <functional>

namespace espalier {
namespace {

using test::SuspectsTest;

TEST_F(SuspectsTest, HasAllFindingsAndDoubtsByTheirGain) {
  expectAllListed();
  EXPECT_TRUE(std::ranges::is_sorted(rows(), std::greater(), &Suspect::gain));
  std::set<bool> sorts;
  for (const Suspect& row : rows())
    sorts.insert(row.isDoubt());
  EXPECT_EQ(sorts.size(), 2U);
  EXPECT_EQ(find<QLabel>("findings_title").text(),
            QString("%1 places may be wrong").arg(rows().size()));
  const auto& list = find<QTreeView>("findings_list");
  for (int i = 0; i < list.model()->rowCount(); ++i) { // each says what, where, gain and remedy
    EXPECT_EQ(list.model()->index(i, 0).data().toString().split('\n').size(), 2);
    const QStringList gain = list.model()->index(i, 1).data().toString().split('\n');
    ASSERT_EQ(gain.size(), 2);
    EXPECT_TRUE(gain[0].endsWith(" %")) << gain[0].toStdString();
    EXPECT_FALSE(gain[1].isEmpty());
  }
}

TEST_F(SuspectsTest, ABareTwigThatIsInDoubtIsOneRow) {
  removeABranch();
  const auto row = rows().begin() + static_cast<std::ptrdiff_t>(rowOfATwin());
  const Suspect doubt = *row;
  EXPECT_EQ(doubts()[doubt.number].kind, Doubt::Kind::missing);
  const Finding finding = findings()[*doubt.twin];
  EXPECT_EQ(finding.kind, Finding::Kind::unexplainedPoints);
  const auto isListed = [&] {
    return std::ranges::any_of(rows(), [&](const Suspect& one) {
      return !one.isDoubt() && findings()[one.number] == finding;
    });
  };
  EXPECT_FALSE(isListed()) << "beside the doubt";
  expectAllListed();
  EXPECT_EQ(find<QLabel>("findings_title").text(),
            QString("%1 places may be wrong").arg(rows().size()));
  const auto& list = find<QTreeView>("findings_list");
  const QString tip =
      list.model()->index(int(row - rows().begin()), 0).data(Qt::ToolTipRole).toString();
  EXPECT_TRUE(tip.contains("Is there a branch")) << tip.toStdString();
  EXPECT_TRUE(tip.contains("Bare twig, ")) << tip.toStdString();
  EXPECT_TRUE(kinds().itemText(0) == QString("All kinds (%1)").arg(rows().size()))
      << kinds().itemText(0).toStdString();
  choose(kinds(), "Bare twigs");
  EXPECT_TRUE(isListed()) << "with its own remedy, among its kind";
  choose(kinds(), "All kinds");
  go(static_cast<std::size_t>(
      std::ranges::find_if(
          rows(), [&](const Suspect& one) { return one.isDoubt() && one.twin == doubt.twin; }) -
      rows().begin()));
  key(Qt::Key_F4, Qt::ControlModifier);
  ASSERT_TRUE(waitForAll());
  EXPECT_FALSE(isListed()) << "it is ignored as the doubt is";
}

TEST_F(SuspectsTest, ABareTwigThatIsAnsweredNoBranchIsNoFindingUntilTheAnswerIsTakenBack) {
  removeABranch();
  const std::size_t at = rowOfATwin();
  const Finding finding = findings()[*rows()[at].twin];
  const Doubt doubt = doubts()[rows()[at].number];
  const auto isOpen = [&] {
    choose(kinds(), "All kinds");
    return std::ranges::any_of(rows(), [&](const Suspect& one) {
      return one.isDoubt() ? isSame(doubts()[one.number], doubt, 0)
                           : isSame(findings()[one.number], finding);
    });
  };
  const auto isLeftOutOfSeal = [this] { // as the dialog that signs says
    action("select_all").trigger();
    action("mark_all_selected").trigger();
    QString text;
    answer(
        [&text](QDialog& dialog) {
          for (const auto* label : dialog.findChildren<QLabel*>())
            text += label->text() + "\n";
          dialog.reject();
        },
        [this] {
          action("sign_structure").trigger();
          waitForJob();
        });
    EXPECT_TRUE(text.contains("Points without wood")) << text.toStdString();
    return text.contains("ignored as no wood") && !text.contains("bare twigs");
  };
  auto& answers = window().part<DoubtsFlow>();
  EXPECT_FALSE(answers.isLeftOut(finding));
  go(at);
  keyOnceDrawn(Qt::Key_1); // no branch
  key(Qt::Key_Escape);
  ASSERT_TRUE(waitForAll());
  EXPECT_FALSE(isOpen());
  EXPECT_TRUE(answers.isLeftOut(finding));
  choose(kinds(), "Ignored (1)");
  panel().setCurrent(0);
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_TRUE(isOpen()) << "it is shown again";
  EXPECT_FALSE(answers.isAnswered(doubt));
  EXPECT_FALSE(answers.isLeftOut(finding));
  go(rowOfATwin());
  keyOnceDrawn(Qt::Key_1);
  key(Qt::Key_Backspace);
  key(Qt::Key_Escape);
  ASSERT_TRUE(waitForAll());
  EXPECT_TRUE(isOpen()) << "its answer is taken back";
  EXPECT_FALSE(isLeftOutOfSeal());
  go(rowOfATwin());
  keyOnceDrawn(Qt::Key_1);
  key(Qt::Key_Escape);
  ASSERT_TRUE(waitForAll());
  EXPECT_TRUE(isLeftOutOfSeal());
}

TEST_F(SuspectsTest, ListsOneKindAlone) {
  const std::size_t all = rows().size();
  choose(kinds(), "Thick on thin");
  EXPECT_GE(rows().size(), 3U);
  for (const Suspect& row : rows())
    EXPECT_EQ(row.kind, static_cast<int>(Finding::Kind::radiusAboveParent));
  EXPECT_EQ(kinds().currentText(), QString("Thick on thin (%1)").arg(rows().size()));
  choose(kinds(), "All kinds");
  EXPECT_EQ(rows().size(), all);
}

TEST_F(SuspectsTest, ListsWhatIsSelectedAndStaysSoWhereverOneGoes) {
  const std::size_t all = rows().size();
  document().selection().clear();
  choose(places(), "Selected");
  EXPECT_TRUE(window().banner().text().contains("elect nodes first"))
      << window().banner().text().toStdString();
  EXPECT_EQ(rows().size(), all);
  EXPECT_EQ(places().currentText(), "Whole plant");
  const std::vector<NodeId> selected = nodesOfRow(rows()[first(false)]);
  document().selection().set(selected);
  choose(places(), "Selected");
  ASSERT_GE(rows().size(), 1U);
  ASSERT_LT(rows().size(), all);
  const std::size_t listed = rows().size();
  for (const Suspect& row : rows()) {
    const std::vector<NodeId> nodes = nodesOfRow(row);
    EXPECT_TRUE(std::ranges::any_of(
        nodes, [&](NodeId id) { return std::ranges::find(selected, id) != selected.end(); }));
  }
  for (std::size_t i = 0; i < listed; ++i)
    key(Qt::Key_F4);
  EXPECT_EQ(rows().size(), listed);
  action("list_all").trigger();
  EXPECT_EQ(rows().size(), all);
  EXPECT_EQ(places().currentText(), "Whole plant");
}

TEST_F(SuspectsTest, ListsTheAxesThatAreSelected) {
  const Skeleton& plant = document().skeleton();
  const NodeId node = nodesOfRow(rows()[first(false)]).front();
  document().selection().set({node});
  const std::vector<NodeId> axis = axesThrough(plant, {node});
  std::size_t expected = 0;
  for (const Suspect& row : rows())
    expected += std::ranges::any_of(
        nodesOfRow(row), [&](NodeId id) { return std::ranges::find(axis, id) != axis.end(); });
  action("list_axes").trigger();
  EXPECT_EQ(places().currentText(), "Selected axes");
  EXPECT_EQ(rows().size(), expected);
}

TEST_F(SuspectsTest, ListsWhatIsInTheViewAndAsksAboutThatAlone) {
  const std::size_t all = rows().size();
  const Skeleton& plant = document().skeleton();
  const Doubt last = doubts().back();
  Eigen::AlignedBox3d box(plant[last.node].position);
  for (const NodeId id : last.nodes)
    box.extend(plant[id].position);
  view().frame(box);
  waitForView();
  action("list_in_view").trigger();
  ASSERT_GE(rows().size(), 1U);
  ASSERT_LT(rows().size(), all);
  const auto inView = rows();
  view().setFocus();
  key(Qt::Key_F2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(panel().current().has_value());
    EXPECT_TRUE(rows()[*panel().current()].isDoubt());
    key(Qt::Key_Space);
  }
  EXPECT_EQ(rows().size(), inView.size());
}

TEST_F(SuspectsTest, TheKeyGoesThroughBothByTheirGain) {
  const std::size_t count = std::min<std::size_t>(rows().size(), 12);
  for (std::size_t i = 0; i < count; ++i) {
    key(Qt::Key_F4);
    ASSERT_EQ(panel().current(), i);
    EXPECT_EQ(isAsked(), rows()[i].isDoubt()) << i;
    EXPECT_EQ(action("extend_again").shortcuts().isEmpty(), rows()[i].isDoubt())
        << "keys are borrowed while it asks alone";
  }
  key(Qt::Key_F4, Qt::ShiftModifier);
  EXPECT_EQ(panel().current(), count - 2);
}

TEST_F(SuspectsTest, WhatAFindingHasSelectedGoesWhereADoubtIsAskedAbout) {
  const auto atPoints = std::ranges::find_if(rows(), [&](const Suspect& one) {
    return !one.isDoubt() && findings()[one.number].kind == Finding::Kind::unexplainedPoints;
  });
  if (atPoints != rows().end()) {
    go(static_cast<std::size_t>(atPoints - rows().begin()));
    EXPECT_FALSE(document().pointSelection().isEmpty());
  } else {
    go(first(false));
  }
  ASSERT_FALSE(document().selection().isEmpty());
  go(first(true));
  ASSERT_TRUE(isAsked());
  key(Qt::Key_Escape);
  EXPECT_TRUE(document().selection().isEmpty()) << "keys would act on what is not looked at";
  EXPECT_TRUE(document().pointSelection().isEmpty());
}

TEST_F(SuspectsTest, AnAnswerGoesOnFromWhereTheKeyHasLed) {
  std::vector<Doubt> met;
  for (int i = 0; i < 40 && met.size() < 3; ++i) {
    key(Qt::Key_F4);
    ASSERT_TRUE(panel().current().has_value());
    const Suspect& row = rows()[*panel().current()];
    if (row.isDoubt()) met.push_back(doubts()[row.number]);
  }
  ASSERT_EQ(met.size(), 3U);
  key(Qt::Key_Space);
  ASSERT_TRUE(isAsked());
  const Doubt& next = doubts()[rows()[*panel().current()].number];
  for (const Doubt& passed : met)
    EXPECT_FALSE(isSame(next, passed, 0)) << "it was passed over";
}

TEST_F(SuspectsTest, EscapeFromTheListLeavesWhatIsSelected) {
  auto& list = find<QTreeView>("findings_list");
  list.setFocus();
  go(first(false));
  const std::vector<NodeId> selected = document().selection().nodes();
  ASSERT_FALSE(selected.empty());
  list.setFocus();
  key(Qt::Key_Escape);
  EXPECT_TRUE(view().hasFocus());
  EXPECT_EQ(document().selection().nodes(), selected);
  key(Qt::Key_Escape);
  EXPECT_TRUE(document().selection().nodes().empty());
}

TEST_F(SuspectsTest, AGestureThatBeginsByKeyInTheListHasTheKeyboard) {
  auto& list = find<QTreeView>("findings_list");
  document().selection().set({document().skeleton().ids().back()});
  list.setFocus();
  key(Qt::Key_P); // reparent
  ASSERT_TRUE(window().part<Editing>().isPending());
  EXPECT_TRUE(view().hasFocus()) << "Enter attaches";
}

TEST_F(SuspectsTest, TheRowOfAnAnswerThatIsTakenBackIsChosen) {
  view().setFocus();
  key(Qt::Key_F2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  const Doubt asked = doubts()[rows()[*panel().current()].number];
  keyOnceDrawn(Qt::Key_2); // another than it is: the plant changes
  ASSERT_TRUE(waitForAll());
  key(Qt::Key_Backspace);
  ASSERT_TRUE(waitForAll());
  ASSERT_TRUE(panel().current().has_value());
  EXPECT_TRUE(isSame(doubts()[rows()[*panel().current()].number], asked, 0));
}

// Findings are known before doubts: what is listed first then need not be what matters most.
TEST_F(SuspectsTest, TheFirstKeyWaitsForAllOfTheList) {
  key(Qt::Key_F8); // away: nothing is looked for
  document().edit("Thicker", [&](SkeletonEditor& editor) {
    const NodeId root = editor.skeleton().roots().front();
    editor.setPosition(root, editor.skeleton()[root].position + Eigen::Vector3d(0, 0, 1e-4));
  });
  view().setFocus();
  key(Qt::Key_F4);
  ASSERT_TRUE(window().part<DoubtsFlow>().isBusy());
  EXPECT_FALSE(panel().current().has_value());
  ASSERT_TRUE(QTest::qWaitFor([this] { return panel().current().has_value(); }, patience));
  EXPECT_TRUE(waitForAll());
  EXPECT_EQ(panel().current(), 0U);
  EXPECT_EQ(isAsked(), rows()[0].isDoubt());
}

TEST_F(SuspectsTest, WhatIsAskedIsChosenInTheList) {
  key(Qt::Key_F8); // it comes with the question, and findings after it
  view().setFocus();
  key(Qt::Key_F2);
  ASSERT_TRUE(QTest::qWaitFor([this] { return isAsked(); }, patience));
  ASSERT_TRUE(waitForAll());
  const auto& list = find<QTreeView>("findings_list");
  ASSERT_TRUE(panel().current().has_value());
  const Suspect row = rows()[*panel().current()];
  EXPECT_EQ(nodesOfRow(row), document().selection().nodes());
  EXPECT_TRUE(list.selectionModel()->isSelected(list.currentIndex()));
}

TEST_F(SuspectsTest, ADoubtThatIsIgnoredIsNotAskedUntilItIsShownAgain) {
  const QString file = path("tree.espalier");
  answer(chooseFile(file), [this] { action("save_project_as").trigger(); });
  waitForJob();
  go(first(true));
  ASSERT_TRUE(isAsked());
  const Doubt doubt = doubts()[rows()[first(true)].number];
  const std::size_t before = doubts().size();
  EXPECT_EQ(action("ignore_finding").text(), "Ignore Doubt");
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_EQ(doubts().size(), before - 1);
  const auto isDoubt = [&](const Doubt& one) { return isSame(one, doubt, 0); };
  EXPECT_TRUE(std::ranges::none_of(doubts(), isDoubt));
  key(Qt::Key_Escape);
  open({file});
  ASSERT_TRUE(waitForAll());
  EXPECT_TRUE(std::ranges::none_of(doubts(), isDoubt)) << "a project remembers it";
  EXPECT_TRUE(std::ranges::any_of(window().part<DoubtsFlow>().ignored(), isDoubt));
  choose(kinds(), "Ignored (1)");
  ASSERT_EQ(rows().size(), 1U);
  panel().setCurrent(0);
  EXPECT_EQ(action("ignore_finding").text(), "Show Doubt Again");
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_TRUE(std::ranges::any_of(doubts(), isDoubt));
  EXPECT_TRUE(kinds().currentText().startsWith("All kinds"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(std::ranges::none_of(doubts(), isDoubt)) << "it is ignored as before";
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(std::ranges::any_of(doubts(), isDoubt));
}

// Its answers go with the history, and with them the order of the list, whose findings are of the
// plant before until all is listed anew.
TEST_F(SuspectsTest, AnotherStructureIsOpenedWhereADoubtIsAnswered) {
  go(first(true));
  keyOnceDrawn(Qt::Key_1);
  key(Qt::Key_Escape);
  ASSERT_TRUE(waitForAll());
  ASSERT_FALSE(window().part<DoubtsFlow>().kept().empty());
  open({writeFork("fork.mtg")});
  ASSERT_TRUE(waitForAll());
  expectAllListed();
  for (const Finding& finding : findings())
    for (const NodeId id : nodesOf(finding))
      EXPECT_TRUE(document().skeleton().contains(id));
}

TEST_F(SuspectsTest, AnsweringAnIgnoredDoubtIsAnAnswer) {
  go(first(true));
  const Doubt doubt = doubts()[rows()[first(true)].number];
  key(Qt::Key_F4, Qt::ControlModifier);
  choose(kinds(), "Ignored (1)");
  go(0);
  ASSERT_TRUE(isAsked());
  key(Qt::Key_Backspace); // there is no answer to take back
  EXPECT_TRUE(isAsked());
  const int steps = document().undoStack().index();
  keyOnceDrawn(Qt::Key_1); // as it is
  EXPECT_TRUE(window().part<DoubtsFlow>().ignored().empty());
  EXPECT_TRUE(window().part<DoubtsFlow>().isAnswered(doubt));
  EXPECT_LE(document().undoStack().index(), steps + 1);
}

// None of These on a missing branch marks its bearer doubtful; what the bearer is asked itself is
// no answer.
TEST_F(SuspectsTest, WoodThatIsMarkedDoubtfulIsAskedAbout) {
  const auto ofWood = std::ranges::find_if(
      doubts(), [](const Doubt& one) { return one.kind != Doubt::Kind::missing; });
  ASSERT_NE(ofWood, doubts().end());
  const Doubt doubt = *ofWood;
  document().edit("Mark", [&](SkeletonEditor& editor) {
    editor.setReview(doubt.node, {.state = ReviewState::doubtful});
  });
  const auto isDoubt = [&](const Doubt& one) { return isSame(one, doubt, 0); };
  EXPECT_TRUE(std::ranges::any_of(doubts(), isDoubt));
  document().edit("Mark", [&](SkeletonEditor& editor) {
    editor.setReview(doubt.node, {.state = ReviewState::reviewed, .reviewer = "Ann"});
  });
  EXPECT_TRUE(std::ranges::none_of(doubts(), isDoubt));
}

TEST_F(SuspectsTest, PointsAreLitWhileTheyAreAskedAbout) {
  document().pointSelection().set(PointSet::of({1, 2, 3}));
  const auto row = std::ranges::find_if(rows(), [&](const Suspect& one) {
    return one.isDoubt() && doubts()[one.number].kind != Doubt::Kind::missing;
  });
  ASSERT_NE(row, rows().end());
  go(static_cast<std::size_t>(row - rows().begin()));
  waitForView();
  const auto bright = [&] {
    const QImage image = view().grab().toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        count += image.pixelColor(x, y) == QColor(0xe6, 0x9f, 0x00);
    return count;
  };
  document().selection().clear(); // which is of that color, too
  QTest::qWait(50);
  EXPECT_GT(bright(), 30);
  action("stop_asking").trigger();
  document().selection().clear();
  QTest::qWait(50);
  EXPECT_LT(bright(), 10);
  EXPECT_EQ(document().pointSelection().points(), PointSet::of({1, 2, 3}));
}

TEST_F(SuspectsTest, GoesThereWithoutAQuestionWhereThePlantIsReadOnly) {
  document().setReadOnly("it is signed");
  const std::size_t row = first(true);
  const std::vector<NodeId> wood = nodesOfRow(rows()[row]);
  go(row);
  EXPECT_FALSE(isAsked());
  EXPECT_EQ(document().selection().nodes(), wood);
}

// What the list names is what keys act on.
TEST_F(SuspectsTest, IgnoringAFindingGoesOnToTheNext) {
  choose(kinds(), "Thick on thin");
  ASSERT_GE(rows().size(), 3U);
  key(Qt::Key_F4);
  const std::vector<NodeId> next = nodesOfRow(rows()[1]);
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_EQ(panel().current(), 0U);
  EXPECT_EQ(nodesOfRow(rows()[0]), next);
  const std::vector<NodeId>& selected = document().selection().nodes();
  ASSERT_FALSE(selected.empty());
  for (const NodeId id : selected)
    EXPECT_NE(std::ranges::find(next, id), next.end());
}

TEST_F(SuspectsTest, TheAnswerThatNoneIsRightBeginsWithItsKey) {
  go(first(true));
  const QAction& none = action("answer_none");
  const auto buttons = panel().findChildren<QToolButton*>();
  const auto button = std::ranges::find(buttons, &none, &QToolButton::defaultAction);
  ASSERT_NE(button, buttons.end());
  EXPECT_EQ((*button)->text(), "0  None of These");
  action("answer_none").setShortcut(Qt::Key_9); // as one may choose
  EXPECT_EQ((*button)->text(), "9  None of These");
}

// A missing branch is asked about where the checks find points that no wood explains.
TEST_F(SuspectsTest, DoubtsFollowTheSensitivityOfTheChecks) {
  const auto missing = [&] {
    return std::ranges::count(doubts(), Doubt::Kind::missing, &Doubt::kind);
  };
  const auto before = missing();
  find<QDoubleSpinBox>("sensitivity").setValue(16);
  EXPECT_TRUE(window().part<DoubtsFlow>().isBusy());
  ASSERT_TRUE(waitForAll());
  EXPECT_GT(missing(), before);
}

TEST_F(SuspectsTest, TheWindowClosesWhileTheListIsAWindowOfItsOwn) {
  auto& dock = find<QDockWidget>("findings");
  dock.setFloating(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dock.isVisible() && dock.isWindow(); }, patience));
  dock.resize(400, 500);
  QApplication::processEvents();
  restart();
  EXPECT_TRUE(document().isEmpty());
}

TEST_F(SuspectsTest, BothKeysShowAndHideTheList) {
  const auto isShown = [this] { return find<QTreeView>("findings_list").isVisible(); };
  ASSERT_TRUE(isShown());
  key(Qt::Key_F2, Qt::ShiftModifier);
  EXPECT_FALSE(isShown());
  key(Qt::Key_F2, Qt::ShiftModifier);
  EXPECT_TRUE(isShown());
  key(Qt::Key_F8);
  EXPECT_FALSE(isShown());
}

} // namespace
} // namespace espalier
