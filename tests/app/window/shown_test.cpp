#include "tests/app/window/read_entry.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QTextStream>
#include <QUndoStack>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// What of the plant is shown, in the real window: test::fork(3), a trunk with three shoots, of
/// which the first continues the trunk.
class ShownTest : public test::WindowTest {
protected:
  ShownTest() {
    open({writeFork("fork.mtg")});
    root_ = nodeAt({0, 0, 0});
    top_ = nodeAt({0, 0, 1});
    for (const NodeId id : document().skeleton().children(top_))
      (document().skeleton()[id].edge == EdgeType::successor ? continuing_ : branch_) = id;
  }
  [[nodiscard]] std::vector<NodeId> seen() {
    const QPolygonF all{QRectF(view().rect())};
    return view().nodesInside(all, Depth::through);
  }
  [[nodiscard]] QMenu& savedViews() {
    auto& menu = find<QMenu>("saved_views");
    emit menu.aboutToShow();
    return menu;
  }
  void saveView(const QString& name) {
    answer(
        [&](QDialog& dialog) {
          static_cast<QInputDialog&>(dialog).setTextValue(name);
          dialog.accept();
        },
        [&] { action("save_view").trigger(); });
  }

  NodeId root_{};
  NodeId top_{};
  NodeId continuing_{}; // the shoot that continues the trunk
  NodeId branch_{};     // one that does not
};

TEST_F(ShownTest, HidesTheSelectedNodesAndUnselectsThem) {
  document().selection().set({branch_});
  key(Qt::Key_H);
  EXPECT_THAT(seen(), testing::Not(testing::Contains(branch_)));
  EXPECT_EQ(seen().size(), document().skeleton().size() - 1);
  EXPECT_TRUE(document().selection().isEmpty());
  EXPECT_EQ(document().undoStack().count(), 0) << "nothing was edited";
  action("select_all").trigger();
  EXPECT_FALSE(document().selection().contains(branch_));
  key(Qt::Key_H, Qt::AltModifier);
  EXPECT_EQ(seen().size(), document().skeleton().size());
  EXPECT_FALSE(action("show_all").isEnabled());
}

TEST_F(ShownTest, HidesThePointsOfTheWoodThatIsHidden) {
  const Skeleton& plant = document().skeleton();
  const auto edgeOf = [&](NodeId id) {
    return std::pair(plant[*plant[id].parent].position, plant[id].position);
  };
  QFile file(path("scan.xyz"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  QTextStream text(&file);
  for (const NodeId id : plant.ids()) {
    if (!plant[id].parent) continue;
    const auto [from, to] = edgeOf(id);
    const Eigen::Matrix3Xf bark = test::cylinder(from + 0.2 * (to - from), to, 0.05, 0.03);
    for (const auto& point : bark.colwise())
      text << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
  }
  file.close();
  open({path("scan.xyz"), path("fork.mtg")});
  const auto shownOf = [&](NodeId id) { // points about the middle of an edge
    const auto [from, to] = edgeOf(id);
    const Eigen::ParametrizedLine<double, 3> axis = {from, (to - from).normalized()};
    const std::vector<Eigen::Index> shown = view().pointsShown();
    return std::ranges::count_if(shown, [&](Eigen::Index point) {
      const Eigen::Vector3d place = document().scan()->cloud()->position(point);
      return axis.distance(place) < 0.06 &&
             (place - (from + to) / 2).norm() < 0.25 * (to - from).norm();
    });
  };
  const auto ofBranch = shownOf(branch_);
  const auto ofTop = shownOf(top_);
  ASSERT_GT(ofBranch, 50);
  ASSERT_GT(ofTop, 50);
  document().selection().set({branch_});
  key(Qt::Key_H);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shownOf(branch_) == 0; }, patience));
  EXPECT_EQ(shownOf(top_), ofTop);
  key(Qt::Key_H, Qt::AltModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shownOf(branch_) == ofBranch; }, patience));
  document().selection().set({branch_});
  key(Qt::Key_H, Qt::ShiftModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shownOf(top_) == 0; }, patience));
  EXPECT_EQ(shownOf(branch_), ofBranch);
  EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(ShownTest, AnEmptyViewSaysWhyItIsEmpty) {
  const auto says = [&](const char* word) {
    const QString wanted = QString::fromUtf8(word);
    return QTest::qWaitFor(
        [&] {
          const QString said = view().accessibleDescription();
          return wanted.isEmpty() ? said.isEmpty() : said.contains(wanted);
        },
        patience);
  };
  waitForView();
  EXPECT_TRUE(says(""));
  view().setClip({.slab = {}, .box = Eigen::AlignedBox3d(Vector3d(5, 5, 5), Vector3d(6, 6, 6))});
  EXPECT_TRUE(says("slab or the box")) << view().accessibleDescription().toStdString();
  key(Qt::Key_H, Qt::AltModifier);
  EXPECT_TRUE(says(""));
  document().selection().set(document().skeleton().ids());
  key(Qt::Key_H);
  EXPECT_TRUE(says("hidden")) << view().accessibleDescription().toStdString();
  key(Qt::Key_H, Qt::AltModifier);
  action("layer_skeleton").setChecked(false);
  EXPECT_TRUE(says("layers are off"));
  action("layer_skeleton").setChecked(true);
  Camera camera = view().camera();
  camera.focus += 100 * Vector3d::UnitZ();
  view().setCamera(camera);
  EXPECT_TRUE(says("not in view"));
  action("frame_all").trigger();
  EXPECT_TRUE(says(""));
}

TEST_F(ShownTest, HidesTheAxisUnderThePointer) {
  hover(placeOf(root_));
  key(Qt::Key_H);
  EXPECT_THAT(seen(), testing::Not(testing::Contains(root_)));
  EXPECT_THAT(seen(), testing::Not(testing::Contains(top_)));
  EXPECT_THAT(seen(), testing::Not(testing::Contains(continuing_)));
  EXPECT_THAT(seen(), testing::Contains(branch_));
}

TEST_F(ShownTest, IsolatesTheSelectedNodes) {
  document().selection().set({top_, branch_});
  key(Qt::Key_H, Qt::ShiftModifier);
  EXPECT_THAT(seen(), testing::UnorderedElementsAre(top_, branch_));
  EXPECT_EQ(document().selection().nodes().size(), 2U) << "they stay selected";
}

TEST_F(ShownTest, RefusesToHideNothing) {
  hover({3, 3});
  key(Qt::Key_H);
  EXPECT_EQ(seen().size(), document().skeleton().size());
}

TEST_F(ShownTest, ClipsWithThePanelAndShowsAllAgain) {
  action("show_clipping").trigger();
  auto& slab = find<QCheckBox>("clip_slab_on");
  EXPECT_TRUE(slab.isVisible());
  slab.click();
  find<QSlider>("clip_nearest").setValue(100);
  ASSERT_TRUE(view().clip().slab);
  EXPECT_DOUBLE_EQ(view().clip().slab->nearest, 0.5);
  EXPECT_DOUBLE_EQ(view().clip().slab->farthest, 1);
  clickButton("clip_show_all");
  EXPECT_TRUE(view().clip().isAll());
  EXPECT_FALSE(slab.isChecked());
  EXPECT_EQ(find<QSlider>("clip_nearest").value(), 0);
}

TEST_F(ShownTest, OpensAndClosesTheClippingPanelWithoutMovingThePlant) {
  const int width = view().width();
  action("show_clipping").trigger();
  QCoreApplication::processEvents();
  EXPECT_EQ(view().width(), width);
  action("show_clipping").trigger();
  QCoreApplication::processEvents();
  EXPECT_EQ(view().width(), width);
}

TEST_F(ShownTest, TheClippingPanelComesToTheFrontFromBehindATab) {
  action("show_clipping").trigger();
  auto& clipping = find<QDockWidget>("clipping");
  auto& inspector = find<QDockWidget>("inspector");
  window().tabifyDockWidget(&clipping, &inspector);
  inspector.raise();
  QCoreApplication::processEvents();
  ASSERT_TRUE(clipping.visibleRegion().isEmpty());
  action("show_clipping").trigger();
  QCoreApplication::processEvents();
  EXPECT_FALSE(clipping.visibleRegion().isEmpty());
  action("show_clipping").trigger();
  EXPECT_TRUE(clipping.isHidden());
}

TEST_F(ShownTest, BeginsABoxAboutThePlant) {
  action("show_clipping").trigger();
  find<QCheckBox>("clip_box_on").click();
  ASSERT_TRUE(view().clip().box);
  EXPECT_EQ(seen().size(), document().skeleton().size()) << "nothing is cut yet";
}

TEST_F(ShownTest, KeepsTheSlabThickerThanNothing) {
  action("show_clipping").trigger();
  find<QCheckBox>("clip_slab_on").click();
  find<QSlider>("clip_farthest").setValue(0);
  ASSERT_TRUE(view().clip().slab);
  EXPECT_LT(view().clip().slab->nearest, view().clip().slab->farthest);
}

TEST_F(ShownTest, ComesBackToASavedView) {
  document().selection().set({branch_});
  key(Qt::Key_H);
  key(Qt::Key_8); // from above
  waitForView();
  view().setClip({.slab = Clip::Slab{0, 0.9}, .box = {}});
  const Camera camera = view().camera();
  saveView("Crown");
  action("show_all").trigger();
  key(Qt::Key_5);
  waitForView();
  for (QAction* entry : savedViews().actions())
    if (test::asRead(entry) == "Crown") entry->trigger();
  waitForView();
  EXPECT_NEAR(view().camera().pitch, camera.pitch, 1e-12);
  EXPECT_EQ(view().clip().slab, (Clip::Slab{0, 0.9}));
  EXPECT_THAT(seen(), testing::Not(testing::Contains(branch_)));
}

TEST_F(ShownTest, ProposesANameAndRemovesAView) {
  answer([](QDialog& dialog) { dialog.accept(); }, [&] { action("save_view").trigger(); });
  const auto names = [&] {
    QStringList texts;
    for (const QAction* entry : savedViews().actions())
      texts.append(test::asRead(entry));
    return texts;
  };
  EXPECT_TRUE(names().contains("View 1"));
  savedViews().findChildren<QMenu*>().last()->actions().first()->trigger(); // Remove > View 1
  EXPECT_FALSE(names().contains("View 1"));
}

TEST_F(ShownTest, ThePanelFollowsWhatIsDraggedInTheView) {
  action("show_clipping").trigger();
  find<QCheckBox>("clip_slab_on").click();
  const QPoint back(30, view().height() / 2 - 100); // on the gauge, which is 200 high
  drag(back, back + QPoint(0, 100));
  ASSERT_TRUE(view().clip().slab);
  EXPECT_NEAR(view().clip().slab->farthest, 0.5, 0.01);
  EXPECT_NEAR(find<QSlider>("clip_farthest").value(), 100, 2);
  EXPECT_EQ(document().undoStack().count(), 0) << "it is looking, not editing";
  action("show_clipping").trigger();
  drag(back + QPoint(0, 100), back);
  EXPECT_NEAR(view().clip().slab->farthest, 0.5, 0.01) << "without the panel there is no handle";
}

} // namespace
} // namespace espalier
