#include "core/base/error.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "ui/document/plant_document.h"
#include "ui/panels/cross_section_panel.h"

#include <QComboBox>
#include <QEnterEvent>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr NodeId middle{5};
constexpr double wood = 0.1; // radius of the stem

std::unique_ptr<const Scan> scanOf(const Eigen::Matrix3Xf& points) {
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>());
  return std::make_unique<const Scan>(PointCloud(std::move(raw)));
}

/// An upright stem about the z axis, and nodes 0.1 apart that stand 0.02 beside it. Across it, x is
/// to the right and y is up.
struct CrossSectionPanelTest : testing::Test {
  PlantDocument document;
  CrossSectionPanel panel{document};
  CrossSectionView* view = panel.findChild<CrossSectionView*>("cross_section");
  std::string refusal;

  void SetUp() override {
    QObject::connect(&panel, &CrossSectionPanel::edited,
                     [this](const QString& name, const auto& change, Gesture gesture) {
                       try {
                         document.edit(name, change, gesture);
                       } catch (const Error& error) {
                         refusal = error.what();
                       }
                     });
    Skeleton plant;
    std::optional<NodeId> parent;
    for (int i = 0; i <= 10; ++i)
      parent = plant.add({.position = {0.02, 0, 0.1 * i}, .radius = 0.06, .parent = parent});
    document.setScan(scanOf(test::cylinder({0, 0, 0}, {0, 0, 1}, wood, 0.01)), "stem.ply");
    document.openSkeleton(plant, "stem.mtg");
    document.selection().set({middle});
    panel.resize(240, 400);
    panel.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel));
    view->setFocus();
  }
  [[nodiscard]] const Node& node() const { return document.skeleton()[middle]; }
  /// One pixel [L].
  [[nodiscard]] double pixel() const {
    return 1 / (view->toScreen({1, 0}).x() - view->toScreen({0, 0}).x());
  }
  void press(const Eigen::Vector2d& place) {
    QTest::mousePress(view, Qt::LeftButton, {}, view->toScreen(place).toPoint());
  }
  void move(const Eigen::Vector2d& place) {
    const QPointF at = view->toScreen(place);
    QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(view, &event);
  }
  void release(const Eigen::Vector2d& place) {
    QTest::mouseRelease(view, Qt::LeftButton, {}, view->toScreen(place).toPoint());
  }
  [[nodiscard]] QString words() const { return panel.findChild<QLabel*>("section_words")->text(); }
  void apply() {
    QTest::mouseClick(panel.findChild<QPushButton*>("apply_section"), Qt::LeftButton);
  }
  void chooseMeasure(RadiusMeasure measure) {
    auto* box = panel.findChild<QComboBox*>("section_measure");
    box->setCurrentIndex(box->findData(static_cast<int>(measure)));
  }
};

TEST_F(CrossSectionPanelTest, IsThereForOneNodeOverAScan) {
  EXPECT_TRUE(panel.isVisible());
  document.selection().set({middle, NodeId{6}});
  EXPECT_FALSE(panel.isVisible());
  document.selection().set({NodeId{4}});
  EXPECT_TRUE(panel.isVisible());
  document.setScan(nullptr, "");
  EXPECT_FALSE(panel.isVisible());
}

TEST_F(CrossSectionPanelTest, DragsTheCenterInThePlaneOfTheSection) {
  const Skeleton before = document.skeleton();
  press({0, 0});
  move({-0.01, 0.005});
  move({-0.02, 0.01});
  EXPECT_EQ(document.undoStack().count(), 1) << "it is seen at once";
  release({-0.02, 0.01});
  EXPECT_NEAR(node().position.x(), 0, 2 * pixel());
  EXPECT_NEAR(node().position.y(), 0.01, 2 * pixel());
  EXPECT_EQ(node().position.z(), before[middle].position.z());
  EXPECT_EQ(node().radius, before[middle].radius);
  EXPECT_EQ(document.undoStack().count(), 1) << "one drag, one step";
  const Skeleton after = document.skeleton();
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), before);
  document.undoStack().redo();
  EXPECT_EQ(document.skeleton(), after);
}

TEST_F(CrossSectionPanelTest, DragsTheRim) {
  press({0, 0.06});
  move({0, 0.08});
  move({0, 0.09});
  release({0, 0.09});
  EXPECT_NEAR(node().radius, 0.09, 2 * pixel());
  EXPECT_EQ(node().position, Eigen::Vector3d(0.02, 0, 0.5));
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(CrossSectionPanelTest, KeepsThePointsUnderThePointerDuringADrag) {
  const Eigen::Vector2d place(0.05, 0.05);
  press({0, 0});
  const QPointF before = view->toScreen(place);
  move({-0.02, 0});
  EXPECT_EQ(view->section()->center, Eigen::Vector3d(0.02, 0, 0.5));
  EXPECT_EQ(view->toScreen(place), before);
  release({-0.02, 0});
  EXPECT_EQ(view->section()->center, node().position) << "it is taken anew";
  const Eigen::Vector3d shift = view->section()->center - Eigen::Vector3d(0.02, 0, 0.5);
  const QPointF after = view->toScreen(place - shift.head<2>());
  EXPECT_NEAR(after.x(), before.x(), 1e-6) << "the picture has not jumped";
  EXPECT_NEAR(after.y(), before.y(), 1e-6);
}

TEST_F(CrossSectionPanelTest, LeavesADragWithNothingChanged) {
  const Skeleton before = document.skeleton();
  for (const Eigen::Vector2d& handle : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 0.06)}) {
    press(handle);
    move(handle + Eigen::Vector2d(0.03, 0.03));
    EXPECT_NE(document.skeleton(), before);
    QTest::keyClick(view, Qt::Key_Escape);
    EXPECT_EQ(document.skeleton(), before);
    EXPECT_FALSE(view->isBusy());
    move(handle + Eigen::Vector2d(0.05, 0.05));
    EXPECT_EQ(document.skeleton(), before) << "the drag is over";
    release(handle);
  }
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(CrossSectionPanelTest, LeavesADragInWhichNothingHasMovedYet) {
  const Skeleton before = document.skeleton();
  press({0, 0});
  QTest::keyClick(view, Qt::Key_Escape);
  release({0, 0});
  press({0, 0});
  release({0, 0});
  EXPECT_EQ(document.skeleton(), before);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(CrossSectionPanelTest, AppliesTheCircleAsOneStep) {
  apply();
  EXPECT_LT(node().position.head<2>().norm(), 1e-3);
  EXPECT_NEAR(node().radius, wood, 1e-3);
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(CrossSectionPanelTest, AppliesMeanAndMaximumAboutTheNode) {
  chooseMeasure(RadiusMeasure::maximum);
  apply();
  EXPECT_NEAR(node().radius, wood + 0.02, 2e-3) << "the far wall";
  EXPECT_EQ(node().position, Eigen::Vector3d(0.02, 0, 0.5));
  chooseMeasure(RadiusMeasure::mean);
  apply();
  EXPECT_NEAR(node().radius, wood + 0.02 * 0.02 / (4 * wood), 2e-3);
}

TEST_F(CrossSectionPanelTest, MovesAndGrowsByKeys) {
  QTest::keyClick(view, Qt::Key_Right);
  EXPECT_GT(node().position.x(), 0.02);
  EXPECT_EQ(node().position.y(), 0);
  QTest::keyClick(view, Qt::Key_Up);
  EXPECT_GT(node().position.y(), 0);
  QTest::keyClick(view, Qt::Key_PageUp);
  EXPECT_NEAR(node().radius, 0.06 * 1.02, 1e-12);
  QTest::keyClick(view, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_NEAR(node().radius, 0.06 * 1.02 / 1.005, 1e-12);
  EXPECT_EQ(document.undoStack().count(), 4);
}

TEST_F(CrossSectionPanelTest, SaysHowGoodACircleIs) {
  EXPECT_TRUE(words().contains("all around (100")) << words().toStdString();
  EXPECT_TRUE(words().endsWith("clean")) << words().toStdString();
  EXPECT_TRUE(view->accessibleDescription().contains(words()));
}

TEST_F(CrossSectionPanelTest, SaysWhyThereIsNoCircle) {
  document.setScan(scanOf(test::cylinder({0, 0, 0}, {0, 0, 0.2}, wood, 0.01)), "stump.ply");
  EXPECT_EQ(words(), "No circle: too few points here (0).");
  EXPECT_FALSE(panel.findChild<QPushButton*>("apply_section")->isEnabled());
  apply();
  EXPECT_EQ(document.undoStack().count(), 0);
  Skeleton alone;
  alone.add({.position = {0, 0, 0.1}});
  document.openSkeleton(alone, "alone.mtg");
  document.selection().set({NodeId{0}});
  EXPECT_TRUE(words().startsWith("No section")) << words().toStdString();
}

TEST_F(CrossSectionPanelTest, ChangesNothingInAReadOnlyPlantOrDuringAJob) {
  const Skeleton before = document.skeleton();
  const auto tryAll = [this] {
    press({0, 0});
    move({0.05, 0.05});
    release({0.05, 0.05});
    QTest::keyClick(view, Qt::Key_PageUp);
    apply();
  };
  panel.setEditable(false);
  tryAll();
  panel.setEditable(true);
  document.setReadOnly("it is signed");
  tryAll();
  EXPECT_EQ(document.skeleton(), before);
  EXPECT_EQ(refusal, "") << "it is not even tried";
}

TEST_F(CrossSectionPanelTest, ZoomsAboutThePointerAndShowsAllAgain) {
  const double scale = 1 / pixel();
  const QPointF at = view->toScreen({0.05, 0.05});
  QWheelEvent wheel(at, view->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(view, &wheel);
  EXPECT_NEAR(1 / pixel(), 1.2 * scale, 1e-6 * scale);
  EXPECT_NEAR(view->toScreen({0.05, 0.05}).x(), at.x(), 1e-6);
  EXPECT_NEAR(view->toScreen({0.05, 0.05}).y(), at.y(), 1e-6);
  document.edit("Grow", [](SkeletonEditor& editor) { editor.setRadius(middle, 0.07); });
  EXPECT_NEAR(1 / pixel(), 1.2 * scale, 1e-6 * scale) << "an edit does not zoom out";
  QTest::mouseDClick(view, Qt::LeftButton, {}, QPoint(4, 4));
  EXPECT_NEAR(1 / pixel(), scale, 1e-6 * scale);
}

TEST_F(CrossSectionPanelTest, RingsTheNodeWhileThePointerIsInside) {
  EXPECT_TRUE(panel.ring().empty());
  QEnterEvent enter(QPointF(5, 5), QPointF(5, 5), view->mapToGlobal(QPointF(5, 5)));
  QApplication::sendEvent(view, &enter);
  ASSERT_FALSE(panel.ring().empty());
  EXPECT_TRUE(panel.ring().front().isApprox(panel.ring().back())) << "it is closed";
  for (const Eigen::Vector3d& place : panel.ring()) {
    EXPECT_NEAR((place - node().position).norm(), 0.06, 1e-9);
    EXPECT_NEAR(place.z(), 0.5, 1e-9);
  }
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(view, &leave);
  EXPECT_TRUE(panel.ring().empty());
}

} // namespace
} // namespace espalier
