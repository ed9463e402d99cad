#include "tests/app/window/review_fixture.h"
#include "ui/panels/coverage_bar.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/review_panel.h"
#include "ui/panels/status_line.h"
#include "ui/panels/step_form.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <algorithm>

namespace espalier {
namespace {

using test::ReviewWindowTest;

TEST_F(ReviewWindowTest, SaysWhyNothingIsMarkedUntilSomethingIsDone) {
  openFork();
  action("show_review").setChecked(true);
  document().selection().clear();
  action("mark_doubtful").trigger();
  EXPECT_EQ(window().banner().text(),
            "Nothing is selected to mark: select nodes, or press . to walk to a stop");
  action("mark_doubtful").trigger();
  EXPECT_TRUE(window().banner().isVisible()) << "refused again";
  document().selection().set({shoot()});
  action("mark_doubtful").trigger();
  EXPECT_EQ(markOf(shoot()).state, ReviewState::doubtful);
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(ReviewWindowTest, SaysItUntilAnEditByTheMouse) {
  openFork();
  action("show_review").setChecked(true);
  document().selection().clear();
  action("mark_doubtful").trigger();
  ASSERT_TRUE(window().banner().isVisible());
  document().edit("Move", [&](SkeletonEditor& editor) { // as a tool does
    editor.setPosition(shoot(), {1, 0.5, 2});
  });
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(ReviewWindowTest, EnterWhileNothingIsSelectedShowsTheFirstStop) {
  openFork();
  action("show_review").setChecked(true);
  document().selection().clear();
  view().setFocus();
  key(Qt::Key_Return);
  EXPECT_EQ(chosen(), (std::vector{nodeAt({0, 0, 0}), nodeAt({0, 0, 1})}));
  EXPECT_EQ(document().undoStack().count(), 0) << "nothing is marked";
  EXPECT_FALSE(window().banner().isVisible());
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(nodeAt({0, 0, 1})).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, SamplesOfColorsFollowTheTheme) {
  openFork();
  action("show_review").setChecked(true);
  action("theme_light").trigger();
  const auto& sample = find<QLabel>("review_sample_2");
  const QImage light = sample.pixmap(Qt::ReturnByValue).toImage();
  action("theme_dark").trigger();
  const auto* bar = window().findChild<CoverageBar*>();
  ASSERT_NE(bar, nullptr);
  EXPECT_EQ(sample.pixmap(Qt::ReturnByValue).toImage(),
            bar->sample(ReviewState::reviewed).toImage());
  EXPECT_NE(sample.pixmap(Qt::ReturnByValue).toImage(), light);
  action("theme_light").trigger();
}

TEST_F(ReviewWindowTest, TheListShowsTheNumbersOfAxesOfHighOrder) {
  openFork();
  Skeleton plant = test::stick(1);
  for (std::uint32_t i = 0; i < 120; ++i) // each on the one before
    plant.add({.position = {double(i), 0, 0}, .parent = NodeId{i}, .edge = EdgeType::branching});
  document().openSkeleton(plant, "plant.mtg");
  action("show_review").setChecked(true);
  const auto& list = find<QTableView>("review_axes");
  ASSERT_TRUE(QTest::qWaitFor([&] { return list.model()->rowCount() == 121; }, patience));
  const QStyle& style = *list.style();
  const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &list) + 1;
  for (const int row : {0, 11, 120})
    EXPECT_LE(list.fontMetrics().horizontalAdvance(list.model()->index(row, 0).data().toString()) +
                  2 * margin,
              list.columnWidth(0))
        << row;
}

TEST_F(ReviewWindowTest, EnterInAListOfChoicesOpensItAndMarksNothing) {
  openFork();
  auto* methods = window().findChild<StepForm*>()->findChild<QComboBox*>();
  methods->setFocus();
  QTest::keyClick(methods, Qt::Key_Return);
  EXPECT_TRUE(methods->view()->isVisible());
  methods->hidePopup();
  EXPECT_FALSE(action("show_review").isChecked());
}

TEST_F(ReviewWindowTest, TheWalkGoesFromStretchToStretchAndShowsEach) {
  openFork();
  EXPECT_FALSE(find<QDockWidget>("review").isVisible());
  key(Qt::Key_Period);
  EXPECT_TRUE(find<QDockWidget>("review").isVisible());
  EXPECT_EQ(chosen(), (std::vector{nodeAt({0, 0, 0}), nodeAt({0, 0, 1})}));
  EXPECT_EQ(label("review_place"), "4 stops left");
  const std::vector<NodeId> trunk = chosen();
  key(Qt::Key_Period);
  EXPECT_EQ(chosen(), std::vector{shoot()}) << "the trunk goes on to its tip first";
  waitForView();
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(1, 0, 2), Eigen::Vector3d(0, 0, 1)}) {
    const auto shown = view().project(place);
    ASSERT_TRUE(shown);
    EXPECT_TRUE(view().rect().contains(shown->toPoint()));
  }
  key(Qt::Key_Comma);
  EXPECT_EQ(chosen(), trunk);
  key(Qt::Key_Comma);
  const std::vector<NodeId> last = chosen();
  EXPECT_NE(last, std::vector{shoot()});
  key(Qt::Key_Period);
  EXPECT_EQ(chosen(), trunk) << "after the last comes the first";
  EXPECT_EQ(document().undoStack().count(), 0) << "to look is no edit";
}

TEST_F(ReviewWindowTest, TheWalkFadesTheRestUntilSomethingElseIsSelected) {
  openFork();
  action("theme_light").trigger();
  key(Qt::Key_Period);
  waitForView();
  // On an edge that the walk has not come to, how far the darkest pixel is from white.
  const QPoint place = view().project({0.25, 0, 1.25})->toPoint();
  const auto strength = [&] {
    const QImage seen = view().picture(view().size());
    int darkest = 255;
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y)
        darkest = std::min(darkest, qGray(seen.pixel(place + QPoint(x, y))));
    return 255 - darkest;
  };
  const int onTheWalk = strength();
  document().selection().clear();
  const int afterwards = strength();
  EXPECT_GT(afterwards, 40) << "no edge there";
  EXPECT_LT(onTheWalk, afterwards / 2);
}

TEST_F(ReviewWindowTest, TheWalkBeginsWhereOneHasClicked) {
  openFork();
  click(placeOf(shoot()));
  key(Qt::Key_Period);
  EXPECT_EQ(chosen(), std::vector{shoot()});
  EXPECT_EQ(label("review_place"), "4 stops left");
  key(Qt::Key_Period);
  EXPECT_NE(chosen(), std::vector{shoot()});
}

TEST_F(ReviewWindowTest, EnterMarksAStretchAndGoesOnUntilAllIsReviewed) {
  openFork();
  key(Qt::Key_Period);
  for (const char* left : {"4 stops left", "3 stops left", "2 stops left", "1 stop left"}) {
    EXPECT_EQ(label("review_place"), left);
    key(Qt::Key_Return);
  }
  EXPECT_EQ(label("review_place"), "No stop left");
  for (const NodeId id : document().skeleton().ids())
    EXPECT_EQ(markOf(id).state, ReviewState::reviewed);
  EXPECT_EQ(document().undoStack().count(), 4);
  EXPECT_EQ(document().undoStack().text(0), "Mark 2 nodes reviewed");
  EXPECT_TRUE(waitForLabel("review_share", "100.0 % reviewed"));
  EXPECT_EQ(label("review_length_0"), formatLength(0, LengthUnit::meter));
  EXPECT_EQ(label("review_length_2"), formatLength(1 + 3 * std::sqrt(2.0), LengthUnit::meter, 3));
  EXPECT_EQ(window().statusLine().shownText(), "All is reviewed: the structure can be signed");
  key(Qt::Key_O);
  EXPECT_EQ(window().statusLine().shownText(), "Every end is reviewed");
  key(Qt::Key_B);
  EXPECT_EQ(window().statusLine().shownText(), "Every branching is reviewed");
  for (int step = 0; step < 4; ++step)
    key(Qt::Key_Z, Qt::ControlModifier);
  for (const NodeId id : document().skeleton().ids())
    EXPECT_EQ(markOf(id), ReviewMark());
}

TEST_F(ReviewWindowTest, ThePanelShowsWhatIsLeftEvenIfItHasNoLength) {
  openFork();
  action("show_review").setChecked(true);
  const NodeId root = document().skeleton().roots().front();
  std::vector<NodeId> others = document().skeleton().ids();
  std::erase(others, root);
  document().selection().set(others);
  action("mark_all_selected").trigger();
  EXPECT_TRUE(waitForLabel("review_share", "99.9 % reviewed"));
  EXPECT_EQ(label("review_length_0"), "1 node");
  const QAbstractItemModel& axes = *find<QTableView>("review_axes").model();
  EXPECT_EQ(axes.index(0, 2).data().toString(), "99 %");
  EXPECT_TRUE(axes.index(0, 2).data(Qt::ToolTipRole).toString().endsWith("1 node to do"));
  EXPECT_EQ(axes.index(1, 2).data().toString(), "✓");
  document().selection().set({root});
  key(Qt::Key_Return);
  EXPECT_TRUE(waitForLabel("review_share", "100.0 % reviewed"));
  EXPECT_EQ(axes.index(0, 2).data().toString(), "✓");
}

TEST_F(ReviewWindowTest, KeysLeadToOpenEndsAndBranchings) {
  openFork();
  key(Qt::Key_O);
  EXPECT_EQ(chosen().back(), shoot());
  key(Qt::Key_O);
  EXPECT_TRUE(document().skeleton().children(chosen().back()).empty());
  EXPECT_NE(chosen().back(), shoot());
  key(Qt::Key_B);
  EXPECT_EQ(chosen().back(), nodeAt({0, 0, 1}));
}

TEST_F(ReviewWindowTest, DoubtIsMarkedCommentedAndTakenBackByKeys) {
  openFork();
  auto& reviewer = find<QLineEdit>("reviewer");
  click(placeOf(shoot()));
  key(Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::doubtful);
  EXPECT_EQ(markOf(shoot()).reviewer, reviewer.text().toStdString());
  key(Qt::Key_K);
  auto& comment = find<QLineEdit>("review_comment");
  ASSERT_TRUE(comment.hasFocus());
  QTest::keyClicks(&comment, "crosses b, or not.");
  QTest::keyClick(&comment, Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).comment, "crosses b, or not.");
  EXPECT_EQ(markOf(shoot()).state, ReviewState::doubtful) << "Enter took the comment, no more";
  EXPECT_TRUE(view().hasFocus());
  EXPECT_EQ(document().undoStack().undoText(),
            "Comment on " + QString("node %1").arg(indexOf(shoot())));
  key(Qt::Key_Backspace);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::toDo);
  EXPECT_EQ(markOf(shoot()).reviewer, "");
  EXPECT_EQ(markOf(shoot()).comment, "crosses b, or not.");
  EXPECT_EQ(document().undoStack().count(), 3);
}

TEST_F(ReviewWindowTest, ACommentIsOfTheNodeUnderThePointerIfNothingIsSelected) {
  openFork();
  hover(placeOf(shoot()));
  key(Qt::Key_K);
  EXPECT_EQ(chosen(), std::vector{shoot()});
  auto& comment = find<QLineEdit>("review_comment");
  ASSERT_TRUE(comment.hasFocus());
  QTest::keyClicks(&comment, "dead");
  QTest::keyClick(&comment, Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).comment, "dead");
}

TEST_F(ReviewWindowTest, ACommentOnNothingIsRefusedAndWhatIsTypedOnEditsNothing) {
  openFork();
  const Skeleton start = document().skeleton();
  hover({5, 5});
  key(Qt::Key_K);
  EXPECT_EQ(window().banner().text(), "Nothing is selected to comment on: put the pointer on a "
                                      "node, or select some");
  hover(placeOf(shoot())); // where the keys would be those of the node
  for (const char letter : std::string("nem x"))
    QTest::keyClick(QApplication::focusWidget(), letter);
  EXPECT_EQ(find<QLineEdit>("review_comment").text(), "nem x");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_TRUE(window().banner().isVisible());
  EXPECT_TRUE(view().hasFocus());
  EXPECT_EQ(document().skeleton(), start);
  EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(ReviewWindowTest, EscapeDropsWhatIsTypedOfAComment) {
  openFork();
  click(placeOf(shoot()));
  key(Qt::Key_K);
  auto& comment = find<QLineEdit>("review_comment");
  QTest::keyClicks(&comment, "dead");
  QTest::keyClick(&comment, Qt::Key_Escape);
  EXPECT_EQ(comment.text(), "");
  EXPECT_TRUE(view().hasFocus());
  EXPECT_EQ(markOf(shoot()).comment, "");
  EXPECT_EQ(chosen(), std::vector{shoot()});
}

TEST_F(ReviewWindowTest, EnterInANumberFieldMarksNothing) {
  openFork();
  click(placeOf(shoot()));
  auto& radius = find<QDoubleSpinBox>("node_radius");
  radius.setFocus();
  radius.selectAll();
  QTest::keyClicks(&radius, "0.25");
  QTest::keyClick(&radius, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(document().skeleton()[shoot()].radius, 0.25);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::toDo);
}

TEST_F(ReviewWindowTest, EnterWithoutThePanelOnlyBeginsTheReview) {
  openFork();
  click(placeOf(shoot()));
  key(Qt::Key_Return); // as one too many after a preview was accepted
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(action("show_review").isChecked());
  const std::vector<NodeId> stretch = chosen();
  ASSERT_FALSE(stretch.empty());
  EXPECT_EQ(markOf(stretch.front()).state, ReviewState::toDo);
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(stretch.front()).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, EnterWithThePanelBehindAnotherOnlyBringsItToTheFront) {
  openFork();
  key(Qt::Key_F9);
  action("show_findings").trigger();
  const auto& panel = find<ReviewPanel>("review_panel");
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel.visibleRegion().isEmpty(); }, patience));
  click(placeOf(shoot()));
  key(Qt::Key_Return);
  EXPECT_EQ(document().undoStack().count(), 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel.visibleRegion().isEmpty(); }, patience));
  const std::vector<NodeId> stretch = chosen();
  ASSERT_FALSE(stretch.empty());
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(stretch.front()).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, EnterInMidGestureMarksNothing) {
  openFork();
  key(Qt::Key_F9);
  click(placeOf(shoot()));
  key(Qt::Key_P); // and now Enter attaches to the nearest wood
  key(Qt::Key_Return);
  EXPECT_EQ(document().undoStack().count(), 1);
  for (const NodeId id : document().skeleton().ids())
    EXPECT_EQ(markOf(id).state, ReviewState::toDo);
  document().undoStack().undo();
  click(placeOf(shoot()));
  key(Qt::Key_P);
  key(Qt::Key_Escape);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::toDo);
  key(Qt::Key_Return);
  EXPECT_EQ(markOf(shoot()).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, AReviewedNodeThatIsDraggedIsToDoAgainUntilUndo) {
  openFork();
  key(Qt::Key_F9);
  click(placeOf(shoot()));
  key(Qt::Key_Return);
  ASSERT_EQ(markOf(shoot()).state, ReviewState::reviewed);
  const NodeId id = shoot();
  view().frameAll();
  waitForView();
  const QPoint place = placeOf(id);
  drag(place, place + QPoint(30, 20));
  EXPECT_EQ(markOf(id).state, ReviewState::toDo);
  EXPECT_EQ(document().undoStack().count(), 2) << "the move and its mark are one step";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(markOf(id).state, ReviewState::reviewed);
}

TEST_F(ReviewWindowTest, ThePanelListsAxesAndItsButtonsDoAsTheKeys) {
  openFork();
  key(Qt::Key_F9);
  auto& axes = find<QTableView>("review_axes");
  ASSERT_EQ(axes.model()->rowCount(), 3);
  const QModelIndex second = axes.model()->index(1, 0);
  QTest::mouseClick(axes.viewport(), Qt::LeftButton, {}, axes.visualRect(second).center());
  ASSERT_EQ(chosen().size(), 1U);
  const NodeId id = chosen().front();
  EXPECT_NE(id, shoot()) << "the first shoot is of the trunk's own axis";
  for (auto* button : window().findChildren<QToolButton*>())
    if (button->text() == "Reviewed, Go On") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(markOf(id).state, ReviewState::reviewed);
  const auto stateText = [&] { return axes.model()->index(1, 2).data().toString(); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return stateText() == "✓"; }, patience));
  EXPECT_EQ(axes.model()->index(0, 2).data().toString(), "0 %");
}

TEST_F(ReviewWindowTest, TheReviewersNameIsRememberedAndSignsTheSteps) {
  openFork();
  key(Qt::Key_F9);
  auto& reviewer = find<QLineEdit>("reviewer");
  reviewer.setFocus();
  reviewer.selectAll();
  QTest::keyClicks(&reviewer, "Anna");
  QTest::keyClick(&reviewer, Qt::Key_Return);
  key(Qt::Key_Period);
  key(Qt::Key_Return);
  EXPECT_EQ(document().step(0).author, "Anna");
  EXPECT_EQ(markOf(nodeAt({0, 0, 0})).reviewer, "Anna");
  restart();
  EXPECT_EQ(find<QLineEdit>("reviewer").text(), "Anna");
}

} // namespace
} // namespace espalier
