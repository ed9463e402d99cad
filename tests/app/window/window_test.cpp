#include "app/window/frame/action_set.h"
#include "core/skeleton/edits.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/plants.h"
#include "tests/support/shared_data.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/panels/status_line.h"
#include "ui/panels/step_form.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionButton>
#include <QTest>
#include <QTextBrowser>
#include <QTextDocument>
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

TEST_F(MainWindowTest, StartsWithWhatToDoAndNoPanels) {
  EXPECT_TRUE(window().statusLine().shownText().contains("Open a scan"));
  EXPECT_FALSE(find<QDockWidget>("pipeline").isVisible());
  EXPECT_FALSE(action("save").isEnabled());
  EXPECT_FALSE(action("reconstruct").isEnabled());
  EXPECT_EQ(window().windowTitle(), "Espalier");
}

// Where a screen is scaled up, it has little room.
TEST_F(MainWindowTest, MayBeMadeAsSmallAsTheScreen) {
  const QSize room = window().screen()->availableSize();
  EXPECT_LT(window().minimumWidth(), room.width());
  EXPECT_LT(window().minimumHeight(), room.height());
  EXPECT_LE(window().minimumWidth(), 960);
  EXPECT_LE(window().minimumHeight(), 600);
}

TEST_F(MainWindowTest, AsksForNoScanWhileOneIsRead) {
  window().open({writeScan("plant.xyz")});
  ASSERT_TRUE(window().jobs().isBusy());
  EXPECT_FALSE(window().statusLine().shownText().contains("Open a scan"));
  waitForJob();
  EXPECT_TRUE(window().statusLine().shownText().contains("Drag: turn"));
}

TEST_F(MainWindowTest, ShowsThePanelsOnceThereIsAPlant) {
  open({writeFork("fork.mtg")});
  EXPECT_TRUE(find<QDockWidget>("pipeline").isVisible());
  EXPECT_TRUE(find<QDockWidget>("inspector").isVisible());
  EXPECT_TRUE(action("save").isEnabled());
  EXPECT_EQ(window().statusLine().counts(), "5 nodes · m") << "as a plant of 2 m";
}

// As Ctrl+C does where a list has the keyboard and no row is current.
TEST_F(MainWindowTest, CopiesNothingFromAListWithoutARow) {
  open({writeFork("fork.mtg")});
  edit();
  int models = 0;
  for (const QAbstractItemView* list : window().findChildren<QAbstractItemView*>()) {
    if (list->model() == nullptr) continue;
    EXPECT_FALSE(list->model()->data({}).isValid()) << list->objectName().toStdString();
    EXPECT_FALSE(list->model()->flags({}).testFlag(Qt::ItemIsEditable));
    ++models;
  }
  EXPECT_GT(models, 10);
}

TEST_F(MainWindowTest, RemembersWhichPanelsWereClosed) {
  open({writeFork("fork.mtg")});
  find<QDockWidget>("inspector").close();
  restart();
  open({path("fork.mtg")});
  EXPECT_FALSE(find<QDockWidget>("inspector").isVisible());
  action("reset_layout").trigger();
  EXPECT_TRUE(find<QDockWidget>("inspector").isVisible());
}

TEST_F(MainWindowTest, PanelsBesideThePlantComeToTheFrontByTheirKeysAndThenGo) {
  open({writeFork("fork.mtg")});
  const auto isInFront = [&](const QString& panel) {
    QCoreApplication::processEvents();
    return !find<QDockWidget>(panel).visibleRegion().isEmpty();
  };
  const std::vector<std::pair<QString, Qt::Key>> panels = {
      {"inspector", Qt::Key_F7}, {"findings", Qt::Key_F8}, {"review", Qt::Key_F9}};
  key(Qt::Key_F8);
  key(Qt::Key_F9);
  for (const auto& [panel, its] : panels) {
    EXPECT_FALSE(isInFront(panel) && panel != "review") << panel.toStdString();
    if (!isInFront(panel)) key(its);
    EXPECT_TRUE(isInFront(panel)) << panel.toStdString();
    EXPECT_TRUE(action("show_" + panel).isChecked());
    key(its);
    EXPECT_TRUE(find<QDockWidget>(panel).isHidden()) << panel.toStdString();
    EXPECT_FALSE(action("show_" + panel).isChecked());
    key(its);
    EXPECT_TRUE(isInFront(panel)) << panel.toStdString();
  }
}

TEST_F(MainWindowTest, NothingInTheInspectorIsCutBesideItsScrollBar) {
  open({writeFork("fork.mtg")});
  window().resize(1280, 600);
  document().selection().set({nodeAt({1, 0, 2})});
  QCoreApplication::processEvents();
  auto& page = find<QWidget>("inspector_page");
  auto* bar = static_cast<QScrollArea*>(page.parentWidget()->parentWidget())->verticalScrollBar();
  ASSERT_TRUE(bar->isVisible());
  for (const QComboBox* list : page.findChildren<QComboBox*>())
    EXPECT_TRUE(list->isHidden() || list->width() >= list->sizeHint().width())
        << list->currentText().toStdString() << ": " << list->width() << " of "
        << list->sizeHint().width();
  const auto& radius = find<QDoubleSpinBox>("node_radius");
  EXPECT_GE(radius.findChild<QLineEdit*>()->width(),
            radius.fontMetrics().horizontalAdvance(radius.text()));
}

TEST_F(MainWindowTest, AStepThatIsOpenedIsSeen) {
  open({writeScan("plant.xyz")});
  window().resize(1280, 600);
  for (const StepForm* form : window().findChildren<PipelinePanel*>().front()->steps()) {
    QWidget* view = form->parentWidget()->parentWidget();
    auto* header = form->findChild<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
    if (header->isChecked()) continue;
    static_cast<QScrollArea*>(view->parentWidget())->ensureWidgetVisible(header, 0, 0);
    QTest::mouseClick(header, Qt::LeftButton);
    ASSERT_TRUE(header->isChecked());
    const auto seen = [&] { return QRect(form->mapTo(view, QPoint()), form->size()); };
    const auto isSeen = [&] {
      return seen().top() >= 0 && (seen().bottom() < view->height() || seen().top() == 0);
    };
    EXPECT_TRUE(QTest::qWaitFor(isSeen, patience))
        << form->step().name << ": " << seen().top() << " to " << seen().bottom();
  }
}

// Cleaning leaves two places with many points each, on which all nodes lie.

TEST_F(MainWindowTest, SaysWhatAStepNotes) {
  std::ofstream scan(path("crowds.xyz").toStdString());
  for (int i = 0; i < 9; ++i)
    scan << "0 0 0\n0 0 3\n";
  scan << "30 0 0\n30 0 0.1\n";
  scan.close();
  open({path("crowds.xyz")});
  action("preset_thesis").trigger();
  clickButton("reconstruct_button");
  waitForJob();
  EXPECT_TRUE(window().banner().text().contains("Radius: nothing is measured at the foot"))
      << window().banner().text().toStdString();
  const auto noted = [this](const std::string& step) {
    for (const StepForm* form : window().findChildren<PipelinePanel*>().front()->steps())
      if (form->step().name == step)
        return form->findChild<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)
            ->toolTip()
            .contains("nothing is measured at the foot");
    return false;
  };
  EXPECT_TRUE(noted("radius"));
  EXPECT_FALSE(noted("skeleton"));
}

TEST_F(MainWindowTest, AnotherPanelOfASideTakesTheWidthItHas) {
  open({writeFork("fork.mtg")});
  auto& inspector = find<QDockWidget>("inspector");
  window().resizeDocks({&inspector}, {300}, Qt::Horizontal);
  QCoreApplication::processEvents();
  const int width = inspector.width();
  key(Qt::Key_F9);
  QCoreApplication::processEvents();
  EXPECT_EQ(find<QDockWidget>("review").width(), width);
  action("reset_layout").trigger();
  QCoreApplication::processEvents();
  EXPECT_LT(inspector.width(), width);
}

TEST_F(MainWindowTest, NamesTheStepsInUndoAndRedo) {
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(action("undo").isEnabled());
  edit();
  EXPECT_EQ(action("undo").text(), "&Undo: Move");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(action("redo").text(), "&Redo: Move");
  EXPECT_FALSE(action("undo").isEnabled());
}

TEST_F(MainWindowTest, PutsANodeBackOnEscapeInMidDrag) {
  open({writeFork("fork.mtg")});
  const Skeleton start = document().skeleton();
  const NodeId apex = nodeAt({1, 0, 2});
  const QPoint from = placeOf(apex);
  hover(from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(40, 20));
  EXPECT_NE(document().skeleton(), start);
  EXPECT_TRUE(window().statusLine().shownText().contains("Esc"));
  QTest::keyClick(&view(), Qt::Key_Escape);
  QTest::mouseMove(&view(), from + QPoint(60, 20));
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(60, 20));
  EXPECT_EQ(document().skeleton(), start);
  EXPECT_FALSE(document().isModified());
}

TEST_F(MainWindowTest, UndoInMidDragLeavesTheDrag) {
  open({writeFork("fork.mtg")});
  const Skeleton start = document().skeleton();
  const QPoint from = placeOf(nodeAt({1, 0, 2}));
  hover(from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(40, 20));
  key(Qt::Key_Z, Qt::ControlModifier);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(60, 20));
  EXPECT_EQ(document().skeleton(), start);
}

TEST_F(MainWindowTest, SaysWhyAReparentIsRefusedAndGoesOn) {
  open({writeFork("fork.mtg")});
  const NodeId top = nodeAt({0, 0, 1});
  const NodeId apex = nodeAt({1, 0, 2});
  hover(placeOf(top));
  key(Qt::Key_P);
  EXPECT_TRUE(action("tool_reparent").isChecked());
  click(placeOf(apex));
  EXPECT_TRUE(window().statusLine().shownText().contains("which it carries itself"));
  EXPECT_EQ(document().skeleton()[top].parent, nodeAt({0, 0, 0}));
  key(Qt::Key_Escape);
  EXPECT_TRUE(action("tool_move").isChecked());
}

TEST_F(MainWindowTest, InsertsANodeWhereAnEdgeIsPressedWithTheAddTool) {
  open({writeFork("fork.mtg")});
  key(Qt::Key_D);
  const auto from = view().project({0, 0, 0});
  const auto to = view().project({0, 0, 1});
  click(((from.value() + to.value()) / 2).toPoint());
  ASSERT_EQ(document().skeleton().size(), 6U);
  const Eigen::Vector3d place =
      document().skeleton()[document().selection().current().value()].position;
  EXPECT_NEAR(place.z(), 0.5, 0.05);
}

TEST_F(MainWindowTest, ShowsAndSetsThePropertiesOfTheChosenNode) {
  open({writeFork("fork.mtg")});
  const NodeId apex = nodeAt({1, 0, 2});
  click(placeOf(apex));
  auto& radius = find<QDoubleSpinBox>("node_radius");
  EXPECT_NEAR(radius.value(), 0.1, 1e-4);
  radius.setFocus();
  radius.selectAll();
  QTest::keyClicks(&radius, "0.25");
  QTest::keyClick(&radius, Qt::Key_Return);
  EXPECT_NEAR(document().skeleton()[apex].radius, 0.25, 1e-9);
  EXPECT_EQ(document().undoStack().count(), 1) << "one edit, when the number is complete";
  EXPECT_EQ(find<QLabel>("radius_origin").text(), "by hand");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(find<QLabel>("radius_origin").isVisible()) << "a file does not say";
}

TEST_F(MainWindowTest, EnterInTheRadiusGivesTheKeysBackToThePlant) {
  open({writeFork("fork.mtg")});
  click(placeOf(nodeAt({1, 0, 2})));
  auto& radius = find<QDoubleSpinBox>("node_radius");
  radius.setFocus();
  QTest::keyClick(&radius, Qt::Key_Return);
  EXPECT_TRUE(view().hasFocus());
}

TEST_F(MainWindowTest, ACommandTakesTheNumberThatIsBeingTyped) {
  open({writeFork("fork.mtg")});
  const NodeId apex = nodeAt({1, 0, 2});
  click(placeOf(apex));
  auto& radius = find<QDoubleSpinBox>("node_radius");
  radius.setFocus();
  radius.selectAll();
  QTest::keyClicks(&radius, "0.25");
  action("save").trigger();
  EXPECT_NEAR(document().skeleton()[apex].radius, 0.25, 1e-9);
  EXPECT_FALSE(document().isModified()) << "it was saved without the number";
}

TEST_F(MainWindowTest, ANumberTypedForANodeThatIsRemovedIsDropped) {
  open({writeFork("fork.mtg")});
  const NodeId tip = nodeAt({1, 0, 2});
  document().selection().set({tip});
  QTest::keyClick(&find<QDoubleSpinBox>("node_radius"), Qt::Key_6);
  const int steps = document().undoStack().index();
  document().edit("Remove", [&](SkeletonEditor& editor) { removeSubtree(editor, tip); });
  EXPECT_EQ(document().undoStack().index(), steps + 1);
}

TEST_F(MainWindowTest, ShowsThatTheRadiiOfTheChosenNodesDiffer) {
  open({writeFork("fork.mtg")});
  document().selection().set(document().skeleton().ids());
  const auto names = [this] {
    QStringList texts;
    for (const QLabel* label : find<QWidget>("inspector").findChildren<QLabel*>())
      if (label->isVisible()) texts.append(label->text());
    return texts;
  };
  EXPECT_TRUE(names().contains("Radius"));
  document().edit("Thicken", [](SkeletonEditor& editor) { editor.setRadius(NodeId{0}, 0.7); });
  EXPECT_TRUE(names().contains("Mean radius"));
}

TEST_F(MainWindowTest, AKeyPressedTwiceDoesNotFallOnNodesSelectedBefore) {
  open({writeFork("fork.mtg")});
  const NodeId selected = nodeAt({1, 0, 2});
  click(placeOf(selected));
  ASSERT_EQ(document().selection().current(), selected);
  hover(placeOf(nodeAt({0, 0, 0})));
  key(Qt::Key_Delete);
  EXPECT_EQ(document().skeleton().size(), 4U);
  key(Qt::Key_Delete); // nothing is under the pointer now
  EXPECT_EQ(document().skeleton().size(), 4U);
  EXPECT_TRUE(document().skeleton().contains(selected));
}

TEST_F(MainWindowTest, SaysThatAKeyHasNothingToActOn) {
  open({writeFork("fork.mtg")});
  hover({5, 5});
  key(Qt::Key_Delete);
  EXPECT_TRUE(window().statusLine().shownText().contains("pointer on a node"));
  EXPECT_FALSE(document().isModified());
}

TEST_F(MainWindowTest, SaysWhatWasUndone) {
  open({writeFork("fork.mtg")});
  hover(placeOf(nodeAt({1, 0, 2})));
  key(Qt::Key_Delete);
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Remove node"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Undone: Remove node"));
}

TEST_F(MainWindowTest, KeepsALongMessageWithinTheWindow) {
  open({writeFork("fork.mtg")});
  window().resize(960, 600);
  auto& banner = find<MessageBanner>("message_banner");
  banner.showError(QString("a long reason why it cannot be done ").repeated(10));
  EXPECT_EQ(window().width(), 960);
  EXPECT_GE(banner.x(), 0);
  EXPECT_LE(banner.geometry().right(), banner.parentWidget()->width());
  EXPECT_GT(banner.height(), 2 * banner.fontMetrics().height()) << "in one line";
}

TEST_F(MainWindowTest, OpensAFlatPlantFromItsBroadSide) {
  std::ofstream out(path("flat.xyz").toStdString());
  for (int i = 0; i < 300; ++i)
    out << 0.01 * (i % 2) << ' ' << i / 300.0 << ' ' << i * 7 % 300 / 300.0 << '\n';
  out.close();
  open({path("flat.xyz")});
  EXPECT_NEAR(std::abs(view().camera().forward().x()), 1, 0.01);
}

TEST_F(MainWindowTest, OpensNoMenuAfterAPan) {
  open({writeFork("fork.mtg")});
  const QPoint from = placeOf(nodeAt({1, 0, 2}));
  QTest::mousePress(&view(), Qt::RightButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(50, 0));
  QTest::mouseMove(&view(), from);
  QTest::mouseRelease(&view(), Qt::RightButton, Qt::NoModifier, from);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(MainWindowTest, TakesTheUnitThatIsChosen) {
  open({writeScan("plant.xyz")});
  EXPECT_EQ(document().unit(), LengthUnit::meter) << "guessed from its extent";
  auto& unit = find<QComboBox>("unit");
  unit.setCurrentIndex(unit.findData("mm"));
  emit unit.activated(unit.currentIndex());
  EXPECT_TRUE(window().statusLine().counts().endsWith("mm"));
}

TEST_F(MainWindowTest, AlignsTheNamesAndValuesOfANode) {
  open({writeFork("fork.mtg")});
  document().selection().set({test::forkTop});
  auto& parent = find<QPushButton>("node_parent");
  QStyleOptionButton option;
  option.initFrom(&parent);
  EXPECT_EQ(parent.style()->subElementRect(QStyle::SE_PushButtonContents, &option, &parent).left(),
            0);
  auto& form = static_cast<QFormLayout&>(*parent.parentWidget()->layout());
  for (int row = 0; row < form.rowCount(); ++row) {
    auto* name = static_cast<QLabel*>(form.itemAt(row, QFormLayout::LabelRole)->widget());
    const QWidget& value = *form.itemAt(row, QFormLayout::FieldRole)->widget();
    const bool isOneLine = value.height() < 2 * name->fontMetrics().height();
    EXPECT_TRUE(isOneLine || name->alignment().testFlag(Qt::AlignTop))
        << name->text().toStdString();
  }
}

TEST_F(MainWindowTest, KeepsTheViewInItsPlaceWhateverIsShown) {
  open({writeScan("scan.xyz"), writeFork("fork.mtg")});
  const QRect before = view().geometry();
  click(placeOf(forkTop));
  QCoreApplication::processEvents();
  EXPECT_EQ(view().geometry(), before); // the inspector has not grown
  open({path("missing.mtg")});
  QCoreApplication::processEvents();
  EXPECT_TRUE(window().banner().isVisible());
  EXPECT_EQ(view().geometry(), before);
}

TEST_F(MainWindowTest, FollowsTheThemeChosen) {
  action("theme_dark").trigger();
  EXPECT_LT(window().palette().color(QPalette::Window).lightness(), 64);
  restart();
  EXPECT_TRUE(action("theme_dark").isChecked());
  action("theme_light").trigger();
  EXPECT_GT(window().palette().color(QPalette::Window).lightness(), 220);
}

} // namespace
} // namespace espalier
