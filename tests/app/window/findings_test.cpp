#include "app/window/files/load_files.h"
#include "app/window/review/findings_flow.h"
#include "core/io/formats.h"
#include "tests/app/window/findings_fixture.h"
#include "ui/panels/status_line.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTest>
#include <QTreeView>
#include <QUndoStack>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::FindingsWindowTest;

TEST_F(FindingsWindowTest, ThePanelSaysThatAllIsWell) {
  openFork();
  EXPECT_FALSE(find<QDockWidget>("findings").isVisible());
  key(Qt::Key_F8);
  EXPECT_TRUE(find<QDockWidget>("findings").isVisible());
  EXPECT_EQ(title(), allIsWell);
  EXPECT_EQ(find<QLabel>("findings_note").text(),
            "Open a scan to check against it, and to find what is in doubt");
  EXPECT_FALSE(list().isVisible());
  EXPECT_FALSE(find<QWidget>("findings_walk").isVisible()) << "there is nowhere to go";
  EXPECT_FALSE(find<QWidget>("findings_ignore").isVisible());
  EXPECT_LT(find<QLabel>("findings_title").y(), 40) << "at the top, though there is no list";
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_EQ(window().statusLine().shownText(), "Choose a finding or a doubt to ignore it");
  key(Qt::Key_F8);
  EXPECT_FALSE(find<QDockWidget>("findings").isVisible());
}

TEST_F(FindingsWindowTest, ThePanelSaysThatThereIsNoSkeletonAndNoMore) {
  open({writeScan("plant.xyz")});
  key(Qt::Key_F8);
  EXPECT_EQ(title(), "There is no skeleton to check yet");
  EXPECT_FALSE(find<QLabel>("findings_note").isVisible());
}

TEST_F(FindingsWindowTest, FollowsEditsAndUndo) {
  openFork();
  key(Qt::Key_F8);
  setRadiusOf(shoot(0), 0.2);
  EXPECT_TRUE(waitForTitle("1 place may be wrong"));
  EXPECT_EQ(countOf("Thick on thin"), "1");
  setRadiusOf(shoot(1), 0.3);
  EXPECT_TRUE(waitForTitle("2 places may be wrong"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitForTitle("1 place may be wrong"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitForTitle(allIsWell));
}

TEST_F(FindingsWindowTest, TheKeyOfTheNextBringsTheListToTheFront) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  key(Qt::Key_F8);
  key(Qt::Key_F7); // the inspector lies before it
  const auto isInFront = [&] {
    QCoreApplication::processEvents();
    return !find<QDockWidget>("findings").visibleRegion().isEmpty();
  };
  ASSERT_FALSE(isInFront());
  key(Qt::Key_F4);
  EXPECT_TRUE(isInFront());
}

TEST_F(FindingsWindowTest, SaysHowTheChecksEndedToWhoHasAskedBefore) {
  openForkAndScan();
  const auto statusText = [&] { return window().statusLine().shownText(); };
  key(Qt::Key_F4);
  ASSERT_EQ(statusText(), QString::fromUtf8("Checking against the scan…"));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !find<QLabel>("findings_note").isVisible(); }, patience));
  EXPECT_THAT(statusText().toStdString(),
              testing::MatchesRegex("The checks ended: [0-9]+ places? may be wrong.*"))
      << "as the title of the list counts";
}

TEST_F(FindingsWindowTest, FliesToTheFirstFindingOnceThereIsOne) {
  openForkAndScan();
  key(Qt::Key_F4);
  ASSERT_TRUE(chosen().empty()) << "it is still to be found";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !chosen().empty(); }, patience));
  waitForView();
  EXPECT_TRUE(isSeen(document().skeleton()[chosen().front()].position));
  EXPECT_TRUE(list().selectionModel()->isSelected(list().currentIndex()));
}

TEST_F(FindingsWindowTest, FliesNowhereOnceOneHasSelectedSomethingElse) {
  openForkAndScan();
  key(Qt::Key_F4);
  document().selection().set({nodeAt({0, 0, 0})});
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !find<QLabel>("findings_note").isVisible(); }, patience));
  QCoreApplication::processEvents();
  EXPECT_EQ(chosen(), std::vector{nodeAt({0, 0, 0})});
}

TEST_F(FindingsWindowTest, KeysGoFromFindingToFindingAndFlyThere) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  setRadiusOf(shoot(1), 0.2);
  key(Qt::Key_F4);
  EXPECT_TRUE(find<QDockWidget>("findings").isVisible()) << "shows what it goes through";
  const std::vector<NodeId> first = chosen();
  ASSERT_EQ(first.size(), 1U);
  waitForView();
  EXPECT_TRUE(isSeen(document().skeleton()[first[0]].position));
  key(Qt::Key_F4);
  const std::vector<NodeId> second = chosen();
  EXPECT_NE(first, second);
  key(Qt::Key_F4);
  EXPECT_EQ(chosen(), first) << "after the last comes the first";
  key(Qt::Key_F4, Qt::ShiftModifier);
  EXPECT_EQ(chosen(), second);
  EXPECT_EQ(document().undoStack().count(), 2) << "to look is no edit";
}

TEST_F(FindingsWindowTest, TheKeyGoesOnFromWhereOneWasMended) {
  openFork();
  for (const int number : {0, 1, 2})
    setRadiusOf(shoot(number), 0.2);
  key(Qt::Key_F4);
  const std::vector<NodeId> passedOver = chosen();
  key(Qt::Key_F4);
  const std::vector<NodeId> mended = chosen();
  ASSERT_EQ(mended.size(), 1U);
  setRadiusOf(mended[0], 0.01);
  ASSERT_TRUE(waitForTitle("2 places may be wrong"));
  key(Qt::Key_F4);
  ASSERT_EQ(chosen().size(), 1U);
  EXPECT_NE(chosen(), passedOver);
  EXPECT_NE(chosen(), mended);
  key(Qt::Key_F4);
  EXPECT_EQ(chosen(), passedOver) << "after the last comes the first";
  setRadiusOf(passedOver[0], 0.01);
  ASSERT_TRUE(waitForTitle("1 place may be wrong"));
  key(Qt::Key_F4, Qt::ShiftModifier);
  EXPECT_NE(chosen(), passedOver) << "before the first comes the last";
}

// Removing a root leaves nothing of an edge below the plant, until the checks have seen that.
TEST_F(FindingsWindowTest, WhatWasJustMendedStaysInItsPlaceInTheList) {
  openForkAndScan();
  document().edit("Foot", [&](SkeletonEditor& editor) {
    const NodeId foot = editor.add({.position = {0, 0, -1}, .radius = 0.1});
    editor.reparent(nodeAt({0, 0, 0}), foot, EdgeType::successor);
  });
  key(Qt::Key_F8);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !countOf("Edges off the scan").isEmpty(); }, patience));
  const NodeId foot = nodeAt({0, 0, -1});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        key(Qt::Key_F4);
        return chosen() == std::vector{foot};
      },
      patience));
  ASSERT_LT(list().currentIndex().row() + 1, list().model()->rowCount());
  key(Qt::Key_Delete);
  EXPECT_FALSE(document().skeleton().contains(foot));
  EXPECT_LT(list().currentIndex().row() + 1, list().model()->rowCount()) << "not at its end";
}

// With a slab or box that shows other parts of the plant, one would fly to an empty view.
TEST_F(FindingsWindowTest, TheKeyTakesSlabAndBoxAlong) {
  openFork();
  for (int number = 0; number < 3; ++number)
    setRadiusOf(shoot(number), 0.2);
  const Clip slab{.slab = Clip::Slab{0.9, 1}, .box = {}};
  const Clip box{.slab = {},
                 .box =
                     Eigen::AlignedBox3d(Eigen::Vector3d(-2, -2, -1), Eigen::Vector3d(2, 2, 0.5))};
  for (const Clip& clip : {slab, box}) {
    view().setClip(clip);
    for (int finding = 0; finding < 3; ++finding) {
      key(Qt::Key_F4);
      waitForView();
      ASSERT_EQ(chosen().size(), 1U);
      EXPECT_TRUE(isDrawn(chosen().front()));
    }
    EXPECT_FALSE(view().clip().isAll()) << "moved, not taken off";
  }
  action("show_all").trigger();
  document().selection().set({shoot(0), shoot(1), shoot(2)});
  action("hide").trigger();
  key(Qt::Key_F4);
  ASSERT_EQ(chosen().size(), 1U);
  waitForView();
  EXPECT_TRUE(isDrawn(chosen().front()));
  EXPECT_TRUE(window().statusLine().shownText().startsWith("What was hidden here is shown again"))
      << window().statusLine().shownText().toStdString();
}

TEST_F(FindingsWindowTest, AClickInTheListSelectsAndFliesThere) {
  openFork();
  setRadiusOf(shoot(2), 0.2);
  key(Qt::Key_F8);
  ASSERT_TRUE(waitForTitle("1 place may be wrong"));
  const QString text = row(0).data().toString();
  EXPECT_TRUE(text.startsWith("Thick on thin\n")) << text.toStdString();
  EXPECT_TRUE(text.contains("· 0.20")) << text.toStdString();
  EXPECT_TRUE(row(0).siblingAtColumn(1).data().toString().endsWith("%\nQ"));
  for (const int role : {Qt::ToolTipRole, Qt::AccessibleDescriptionRole})
    EXPECT_TRUE(row(0).data(role).toString().contains("is thicker than its parent"));
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOfRow(0));
  EXPECT_EQ(chosen(), std::vector{shoot(2)});
  waitForView();
  EXPECT_TRUE(isSeen(document().skeleton()[shoot(2)].position));
}

TEST_F(FindingsWindowTest, NothingInTheListIsCut) {
  openFork();
  for (int number = 0; number < 3; ++number)
    setRadiusOf(shoot(number), 0.2);
  document().edit("Id", [](SkeletonEditor& editor) { // many were there before
    const NodeId on = editor.skeleton().roots().front();
    for (int i = 0; i < 10'000; ++i)
      editor.erase(editor.add({.position = {0, 1, 1}, .parent = on}));
    editor.add({.position = {0, 1, 1}, .radius = 0.5, .parent = on, .edge = EdgeType::branching});
  });
  key(Qt::Key_F4);
  EXPECT_GE(find<QWidget>("findings_walk").height(), 20);
  const QFontMetrics letters(list().font());
  ASSERT_GE(list().model()->rowCount(), 4);
  for (int i = 0; i < list().model()->rowCount(); ++i)
    for (int column = 0; column < 2; ++column)
      for (const QString& line : row(i).siblingAtColumn(column).data().toString().split('\n'))
        EXPECT_LE(letters.horizontalAdvance(line) + 6, list().columnWidth(column))
            << line.toStdString();
}

TEST_F(FindingsWindowTest, EnterInTheListGoesThereAndMarksNothing) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  setRadiusOf(shoot(1), 0.2);
  key(Qt::Key_F4);
  const std::vector<NodeId> first = chosen();
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Down);
  EXPECT_EQ(chosen(), first) << "to walk in the list moves no camera";
  QTest::keyClick(&list(), Qt::Key_Return);
  EXPECT_NE(chosen(), first);
  EXPECT_EQ(document().undoStack().count(), 2);
}

// Whichever the file has first.
TEST_F(FindingsWindowTest, OfTwoSuccessorsTheKeyKeepsTheOneThatGoesOnStraight) {
  openFork();
  const NodeId aside = shoot(0);
  NodeId straight{};
  document().edit("Go on", [&](SkeletonEditor& editor) {
    straight = editor.add({.position = {0.1, 0, 2.5}, .radius = 0.1, .parent = test::forkTop});
    for (const NodeId id : {aside, straight})
      editor.setEdge(id, EdgeType::successor);
  });
  key(Qt::Key_F4);
  EXPECT_EQ(chosen(), std::vector{aside});
  key(Qt::Key_M, Qt::ShiftModifier);
  EXPECT_EQ(document().skeleton()[straight].edge, EdgeType::successor);
  EXPECT_EQ(document().skeleton()[aside].edge, EdgeType::branching);
  EXPECT_TRUE(QTest::qWaitFor([&] { return countOf("Two successors").isEmpty(); }, patience));
}

TEST_F(FindingsWindowTest, IgnoredOnesLeaveTheListAndComeBackOnRequest) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_EQ(title(), "Nothing else to look at: 1 place is ignored");
  EXPECT_EQ(countOf("Ignored"), "1");
  setRadiusOf(shoot(0), 0.3); // still thicker: still ignored
  EXPECT_TRUE(QTest::qWaitFor([&] { return countOf("Ignored") == "1"; }, patience));
  chooseKind("Ignored");
  EXPECT_EQ(title(), "1 place is ignored");
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOfRow(0));
  EXPECT_EQ(action("ignore_finding").text(), "Show Finding Again");
  EXPECT_EQ(find<QAbstractButton>("findings_ignore").text(), "Show Again");
  key(Qt::Key_F4, Qt::ControlModifier);
  EXPECT_EQ(title(), "1 place may be wrong");
  EXPECT_EQ(countOf("Ignored"), "");
}

TEST_F(FindingsWindowTest, AProjectRemembersWhatIsIgnored) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  const QString file = saveProject("plant.espalier");
  key(Qt::Key_F4);
  key(Qt::Key_F4, Qt::ControlModifier);
  window().close();
  restart();
  open({file});
  EXPECT_TRUE(QTest::qWaitFor([&] { return countOf("Ignored") == "1"; }, patience));
  EXPECT_EQ(title(), "Nothing else to look at: 1 place is ignored");
  open({writeFork("other.mtg")});
  setRadiusOf(shoot(0), 0.2);
  EXPECT_TRUE(waitForTitle("1 place may be wrong")) << "another plant";
}

TEST_F(FindingsWindowTest, ReportsByTheLimitsThatAreSetAndAProjectRemembersThem) {
  openFork();
  action("check_limits").trigger();
  auto& turn = find<QDoubleSpinBox>("branch_turn");
  EXPECT_TRUE(turn.isVisible());
  EXPECT_EQ(title(), allIsWell);
  turn.setValue(20); // each shoot leaves at 45 degrees
  EXPECT_TRUE(waitForTitle("2 places may be wrong")) << "all but the one that continues the axis";
  EXPECT_EQ(countOf("Sharp turns"), "2");
  const QString file = saveProject("limits.espalier");
  open({writeFork("other.mtg")});
  EXPECT_TRUE(waitForTitle("2 places may be wrong")) << "they hold for the next plant";
  turn.setValue(150);
  EXPECT_TRUE(waitForTitle(allIsWell));
  open({file});
  EXPECT_TRUE(waitForTitle("2 places may be wrong"));
  EXPECT_EQ(find<QDoubleSpinBox>("branch_turn").value(), 20);
}

TEST_F(FindingsWindowTest, AFindingOfANodeThatIsRemovedGoesWithIt) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  key(Qt::Key_F4);
  const NodeId id = shoot(0);
  document().edit("Remove", [=](SkeletonEditor& editor) { editor.erase(id); });
  EXPECT_EQ(title(), allIsWell) << "at once";
  key(Qt::Key_F4);
  EXPECT_EQ(window().statusLine().shownText(), allIsWell);
}

TEST_F(FindingsWindowTest, SelectsTheNodesOfAllFindings) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  setRadiusOf(shoot(2), 0.2);
  action("select_findings").trigger();
  EXPECT_EQ(chosen().size(), 2U);
  EXPECT_TRUE(document().selection().contains(shoot(0)));
  EXPECT_TRUE(document().selection().contains(shoot(2)));
}

// The twigs of the scan are elsewhere than the shoots of the fork.
TEST_F(FindingsWindowTest, ChecksAgainstTheScanAsAJobOfItsOwn) {
  openForkAndScan();
  key(Qt::Key_F8);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !countOf("Bare twigs").isEmpty(); }, patience));
  EXPECT_FALSE(countOf("Edges off the scan").isEmpty());
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return !find<QLabel>("findings_note").isVisible(); }, patience));
  const QString before = title();
  document().edit("Cut", [&](SkeletonEditor& editor) {
    for (int i = 0; i < 3; ++i)
      editor.erase(shoot(i));
  });
  EXPECT_TRUE(QTest::qWaitFor([&] { return countOf("Edges off the scan").isEmpty(); }, patience));
  EXPECT_NE(title(), before);
}

TEST_F(FindingsWindowTest, NothingIsSaidToBeWellBeforeTheScanWasChecked) {
  openFork();
  key(Qt::Key_F8);
  ASSERT_EQ(title(), allIsWell);
  open({writeScan("plant.xyz")});
  EXPECT_NE(title(), allIsWell);
  action("select_findings").trigger();
  EXPECT_NE(window().statusLine().shownText(), allIsWell);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !countOf("Bare twigs").isEmpty(); }, patience));
}

TEST_F(FindingsWindowTest, PointsWithoutABranchAreSelectedAndCanGrowOne) {
  Skeleton trunk; // without the three branches of the scan
  const NodeId foot = trunk.add({.position = {0, 0, 0}, .radius = 0.05});
  trunk.add({.position = {0, 0, 2}, .radius = 0.05, .parent = foot});
  writeStructure(toPath(path("trunk.mtg")), trunk);
  open({writeScan("plant.xyz"), path("trunk.mtg")});
  key(Qt::Key_F8);
  ASSERT_TRUE(QTest::qWaitFor([&] { return countOf("Bare twigs") == "3"; }, patience));
  chooseKind("Bare twigs");
  key(Qt::Key_F4);
  const PointSet& points = document().pointSelection().points();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !points.isEmpty(); }, patience))
      << "once doubts are known";
  EXPECT_GT(points.size(), 1000U) << "1900 of 2000 stand clear of the trunk";
  const PointCloud& cloud = *document().scan()->cloud();
  for (const Eigen::Index point : points.points())
    EXPECT_GT(cloud.position(point).head<2>().norm(), 0.05) << "none of the trunk";
  EXPECT_EQ(chosen().size(), 1U) << "the node they come nearest to";

  document().leaveOut("Set aside", points); // what is left is counted otherwise from here on
  ASSERT_TRUE(QTest::qWaitFor([&] { return countOf("Bare twigs") == "2"; }, patience));
  key(Qt::Key_F4);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !points.isEmpty(); }, patience));
  EXPECT_TRUE((points & document().leftOut()).isEmpty());
  for (const Eigen::Index point : points.points())
    EXPECT_GT(cloud.position(point).head<2>().norm(), 0.05) << "none of the trunk";
}

TEST_F(FindingsWindowTest, FollowsManyEditsInARowToTheLast) {
  openForkAndScan();
  key(Qt::Key_F8);
  for (int i = 0; i < 40; ++i) {
    setRadiusOf(shoot(0), i % 2 == 0 ? 0.2 : 0.1);
    QTest::qWait(i % 7); // within the pause, and into the job
  }
  setRadiusOf(shoot(1), 0.2);
  EXPECT_TRUE(QTest::qWaitFor([&] { return countOf("Thick on thin") == "1"; }, patience));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !countOf("Bare twigs").isEmpty(); }, patience));
}

TEST_F(FindingsWindowTest, SayWhatTheyAreAndWhichKeyHelps) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  key(Qt::Key_F4);
  QString sentence = find<QLabel>("findings_sentence").text();
  EXPECT_EQ(window().statusLine().shownText(), sentence);
  sentence.replace(QChar(0x202f), QChar(0x20)); // before units
  EXPECT_TRUE(sentence.contains("is thicker than its parent: radius 0.200 m on 0.100 m"))
      << sentence.toStdString();
  EXPECT_TRUE(sentence.endsWith(": Q makes it thinner")) << sentence.toStdString();
}

TEST_F(FindingsWindowTest, TheKeyActsThereWhateverThePointerIsOnUntilItMoves) {
  openFork();
  setRadiusOf(shoot(0), 0.2);
  hover(placeOf(nodeAt({0, 0, 0})));
  key(Qt::Key_F4);
  waitForView();
  key(Qt::Key_Q);
  EXPECT_NEAR(document().skeleton()[shoot(0)].radius, 0.19, 1e-9);
  EXPECT_EQ(document().skeleton()[nodeAt({0, 0, 0})].radius, 0.1);
}

TEST_F(FindingsWindowTest, OneSensitivitySetsTheChecksAndTheDistanceOfExplainedPoints) {
  openForkAndScan();
  key(Qt::Key_F8);
  action("hide_explained").trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !countOf("Bare twigs").isEmpty(); }, patience));
  auto& distance = find<QDoubleSpinBox>("explained_number");
  auto& sensitivity = find<QDoubleSpinBox>("sensitivity");
  const double usual = distance.value();
  ASSERT_EQ(sensitivity.value(), 1);
  distance.setValue(50 * usual); // beyond all of the plant
  EXPECT_NEAR(sensitivity.value(), 0.02, 1e-3);
  EXPECT_TRUE(QTest::qWaitFor([&] { return countOf("Bare twigs").isEmpty(); }, patience));
  sensitivity.setValue(2);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(distance.value() - usual / 2) < usual / 50; },
                              patience))
      << distance.value() << " of " << usual;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !countOf("Bare twigs").isEmpty(); }, patience));
  const QString file = saveProject("sensitive.espalier");
  open({writeFork("other.mtg")});
  find<QDoubleSpinBox>("sensitivity").setValue(1);
  open({file});
  EXPECT_EQ(find<QDoubleSpinBox>("sensitivity").value(), 2);
}

// A spur that ends within the 6 spacings in which an edge without points is looked for.
TEST_F(FindingsWindowTest, ASpurBesideATrunkHasNoPointsOfItsOwn) {
  open({writeScan("plant.xyz")});
  const double spacing = document().scan()->spacing();
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}, .radius = 0.05});
  const NodeId low = plant.add({.position = {0, 0, 0.4}, .radius = 0.05, .parent = foot});
  plant.add({.position = {0, 0, 2}, .radius = 0.05, .parent = low});
  plant.add({.position = {0, -0.05 - 5.8 * spacing, 0.4},
             .radius = 1e-3,
             .parent = low,
             .edge = EdgeType::branching});
  writeStructure(toPath(path("trunk.mtg")), plant);
  open({path("trunk.mtg")});
  key(Qt::Key_F8);
  ASSERT_TRUE(QTest::qWaitFor([&] { return countOf("No points of their own") == "1"; }, patience));
  EXPECT_EQ(countOf("Edges off the scan"), "");
}

} // namespace
} // namespace espalier
