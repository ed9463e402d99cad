// Root and up axis, chosen before the first reconstruction, in the real window.
#include "app/window/preview/preview_flow.h"
#include "core/pipeline/presets.h"
#include "tests/app/window/project_fixture.h"
#include "ui/panels/status_line.h"
#include "ui/panels/step_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QTest>

#include <fstream>

namespace espalier {
namespace {

/// Beside a trunk with branches, a scan of a trunk that lies along y, which a file with y up holds.
struct StandTest : test::ProjectWindowTest {
  /// A stick from the origin to (0, 2, 0), with a twig to one side near its top.
  QString writeLyingScan(const QString& name) {
    std::ofstream out(path(name).toStdString());
    for (int i = 0; i <= 400; ++i)
      for (const double side : {-0.03, 0.0, 0.03})
        out << side << ' ' << 0.005 * i << ' ' << 0.03 - std::abs(side) << '\n';
    for (int i = 0; i <= 100; ++i)
      out << 0.005 * i << ' ' << 1.5 + 0.003 * i << " 0.01\n";
    return path(name);
  }
  [[nodiscard]] Eigen::Vector3d rootOfPlant() {
    return document().skeleton()[document().skeleton().roots().front()].position;
  }
  void reconstruct() {
    key(Qt::Key_R, Qt::ControlModifier);
    waitForJob();
  }
  /// Where the view shows a point of the scan, near a place.
  QPoint pixelOfPointAt(const Eigen::Vector3d& place) {
    const auto pixel = view().project(place).value_or(QPointF());
    EXPECT_TRUE(view().pick(pixel).point) << "no point of the scan is drawn there";
    return pixel.toPoint();
  }
  [[nodiscard]] StepForm::State stateOf(const std::string& step) {
    for (const StepForm* form : window().findChild<PipelinePanel*>()->steps())
      if (form->step().name == step) return form->state();
    ADD_FAILURE() << step;
    return StepForm::State::idle;
  }
};

TEST_F(StandTest, TheRootIsPickedByAClickBeforeTheFirstReconstruction) {
  open({writeScan("plant.xyz")}); // its foot is at the origin
  key(Qt::Key_R, Qt::ShiftModifier);
  EXPECT_TRUE(action("tool_root").isChecked());
  const QImage before = view().picture({300, 200});
  click(pixelOfPointAt({0.8, 0, 1.6})); // the end of a branch
  ASSERT_TRUE(document().root());
  EXPECT_LT((*document().root() - Eigen::Vector3d(0.8, 0, 1.6)).norm(), 0.1);
  EXPECT_TRUE(action("tool_move").isChecked()) << "the tool before";
  EXPECT_EQ(find<QComboBox>("root").currentIndex(), 2) << "at that place";
  EXPECT_TRUE(find<QComboBox>("root").currentText().startsWith("at ")) << "and says so";
  reconstruct();
  EXPECT_LT((rootOfPlant() - *document().root()).norm(), 0.1);
}

TEST_F(StandTest, WithoutAChoiceTheRootIsTheLowestPoint) {
  open({writeScan("plant.xyz")});
  EXPECT_EQ(find<QComboBox>("root").currentText(), "lowest point");
  EXPECT_FALSE(action("root_lowest").isEnabled());
  document().setRoot(Eigen::Vector3d(0.8, 0, 1.6));
  EXPECT_TRUE(action("root_lowest").isEnabled());
  key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(document().root());
  EXPECT_EQ(find<QComboBox>("root").count(), 2);
  reconstruct();
  EXPECT_LT((rootOfPlant() - Eigen::Vector3d(0, 0, 0)).norm(), 0.15);
}

TEST_F(StandTest, TheListOfThePanelStartsTheTool) {
  open({writeScan("plant.xyz")});
  auto& root = find<QComboBox>("root");
  const auto choose = [&](int row) {
    root.setCurrentIndex(row);
    emit root.activated(row);
  };
  choose(1);
  EXPECT_TRUE(action("tool_root").isChecked());
  EXPECT_EQ(root.currentText(), "lowest point") << "until one is picked";
  EXPECT_TRUE(window().statusLine().shownText().startsWith("Click the foot of the trunk"))
      << window().statusLine().shownText().toStdString();
  key(Qt::Key_Escape);
  EXPECT_TRUE(action("tool_move").isChecked());
  EXPECT_FALSE(document().root());
  document().setRoot(Eigen::Vector3d(0.8, 0, 1.6));
  choose(0);
  EXPECT_FALSE(document().root());
}

TEST_F(StandTest, AClickOnEmptyGroundSaysWhatToClick) {
  open({writeScan("plant.xyz")});
  action("tool_root").trigger();
  click({5, view().height() - 120});
  EXPECT_FALSE(document().root());
  EXPECT_TRUE(action("tool_root").isChecked());
  EXPECT_TRUE(window().statusLine().shownText().contains("Click a point of the scan"))
      << window().statusLine().shownText().toStdString();
}

TEST_F(StandTest, ThePickedRootIsMarkedInTheView) {
  open({writeScan("plant.xyz")});
  const QImage before = view().grab().toImage();
  document().setRoot(Eigen::Vector3d(0.8, 0, 1.6));
  waitForView();
  const QPoint at = view().project({0.8, 0, 1.6})->toPoint();
  const QRect around(at - QPoint(8, 8), at + QPoint(60, 8));
  EXPECT_NE(view().grab(around).toImage(), before.copy(around));
  document().setRoot(std::nullopt);
  EXPECT_EQ(view().grab(around).toImage(), before.copy(around));
}

TEST_F(StandTest, AnotherRootOrUpMakesTheStepsStale) {
  open({writeScan("plant.xyz")});
  reconstruct();
  ASSERT_EQ(stateOf("contract"), StepForm::State::done);
  document().setRoot(Eigen::Vector3d(0.8, 0, 1.6));
  EXPECT_EQ(stateOf("clean"), StepForm::State::done) << "it looks for no root";
  EXPECT_EQ(stateOf("contract"), StepForm::State::stale);
  reconstruct();
  EXPECT_EQ(stateOf("contract"), StepForm::State::done);
  action("up_x").trigger();
  EXPECT_EQ(stateOf("clean"), StepForm::State::stale) << "rules follow from the height";
  action("up_z").trigger();
  reconstruct();
  view().setFocus();
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_LT((rootOfPlant() - Eigen::Vector3d(0, 0, 0)).norm(), 0.15);
}

TEST_F(StandTest, UpTurnsThePlantUprightInTheView) {
  open({writeLyingScan("lying.xyz")});
  const auto height = [&] { // of the stick, on the screen
    const QPointF foot = view().project({0, 0, 0}).value();
    const QPointF top = view().project({0, 2, 0}).value();
    return foot.y() - top.y();
  };
  EXPECT_LT(std::abs(height()), 100) << "it lies";
  action("up_y").trigger();
  waitForView();
  EXPECT_GT(height(), 0.6 * view().height()) << "it stands, and fills the view";
  EXPECT_EQ(find<QComboBox>("up").currentText(), "y");
  action("view_top").trigger();
  waitForView();
  EXPECT_LT((view().camera().forward() + Eigen::Vector3d::UnitY()).norm(), 1e-9);
  action("view_front").trigger();
  waitForView();
  EXPECT_LT((view().camera().up() - Eigen::Vector3d::UnitY()).norm(), 1e-9);
  EXPECT_GT(height(), 0.6 * view().height());
}

TEST_F(StandTest, UpIsWhereTheLowestPointIsSoughtAlong) {
  open({writeLyingScan("lying.xyz")});
  auto& up = find<QComboBox>("up");
  up.setCurrentIndex(1);
  emit up.activated(1);
  EXPECT_EQ(document().up(), UpAxis::y);
  EXPECT_TRUE(action("up_y").isChecked());
  reconstruct();
  EXPECT_LT((rootOfPlant() - Eigen::Vector3d(0, 0, 0)).norm(), 0.15) << "the foot of the stick";
}

TEST_F(StandTest, AProjectKeepsRootAndUp) {
  open({writeLyingScan("lying.xyz")});
  const QString file = saveProject("plant.espalier");
  action("up_y").trigger();
  document().setRoot(Eigen::Vector3d(0, 1, 0.03));
  reconstruct();
  waitForView();
  const Camera seen = view().camera();
  window().close();
  restart();
  open({file});
  EXPECT_EQ(document().up(), UpAxis::y);
  ASSERT_TRUE(document().root());
  EXPECT_EQ(*document().root(), Eigen::Vector3d(0, 1, 0.03));
  EXPECT_EQ(options().up, UpAxis::y);
  EXPECT_EQ(view().camera(), seen) << "upright, and seen from where it was";
  EXPECT_EQ(stateOf("contract"), StepForm::State::done) << "made with these";
  document().setRoot(std::nullopt);
  EXPECT_EQ(stateOf("contract"), StepForm::State::stale);
  action("new_plant").trigger();
  EXPECT_EQ(document().up(), UpAxis::z);
}

TEST_F(StandTest, EscWithLivePreviewLeavesRootAndUpOfAnotherPlant) {
  open({writeLyingScan("lying.xyz")});
  action("up_y").trigger();
  document().setRoot(Eigen::Vector3d(0, 1, 0.03));
  reconstruct();
  const QString file = saveProject("plant.espalier");
  action("live_preview").trigger();
  open({writeScan("plant.xyz")});
  const auto isShown = [&] {
    return window().part<PreviewFlow>().shown() && !window().part<PreviewFlow>().isBusy();
  };
  ASSERT_TRUE(QTest::qWaitFor(isShown, patience));
  const UpAxis up = document().up();
  const auto root = document().root();
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_EQ(document().up(), up);
  EXPECT_EQ(document().root(), root);
  open({file});
  ASSERT_TRUE(QTest::qWaitFor(isShown, patience));
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_EQ(document().up(), UpAxis::y);
  EXPECT_EQ(document().root(), Eigen::Vector3d(0, 1, 0.03));
}

TEST_F(StandTest, UpIsChosenOfASkeletonWithoutAScan) {
  EXPECT_FALSE(find<QComboBox>("up").isEnabled());
  EXPECT_FALSE(action("up_y").isEnabled());
  open({writeFork("fork.txt")});
  EXPECT_TRUE(find<QComboBox>("up").isEnabled());
  action("up_y").trigger();
  EXPECT_EQ(document().up(), UpAxis::y);
  EXPECT_EQ(find<QComboBox>("up").currentText(), "y");
}

TEST_F(StandTest, RulesOfTheStepsFollowThePointsThatAreKept) {
  std::ofstream out(path("two.xyz").toStdString());
  for (int i = 0; i < 1000; ++i) // a line of dense points, and one of sparse points beside it
    out << "0 0 " << 0.001 * i << "\n1 0 " << 0.01 * i << '\n';
  out.close();
  open({path("two.xyz")});
  const double before = document().scale().spacing;
  const auto lengthOf = [this] {
    for (StepForm* form : window().findChild<PipelinePanel*>()->steps())
      if (form->step().name == "contract")
        return form->findChild<QDoubleSpinBox*>("radius")->value();
    return 0.0;
  };
  const double length = lengthOf();
  std::vector<Eigen::Index> dense;
  for (Eigen::Index i = 0; i < document().scan()->cloud()->size(); ++i)
    if (document().scan()->cloud()->position(i).x() < 0.5) dense.push_back(i);
  document().leaveOut("Set aside", PointSet::of(dense));
  ASSERT_GT(document().scale().spacing, 1.5 * before);
  EXPECT_NEAR(lengthOf() / length, document().scale().spacing / before, 0.02);
}

TEST_F(StandTest, PresetsAreOfStepsAndLeaveTheScanAsItStands) {
  open({writeLyingScan("lying.xyz")});
  action("up_y").trigger();
  document().setRoot(Eigen::Vector3d(0, 1, 0.03));
  action("preset_thesis").trigger();
  PipelineOptions expected = presetNamed("thesis")->options;
  expected.up = UpAxis::y;
  expected.root = Eigen::Vector3d(0, 1, 0.03);
  EXPECT_EQ(options(), expected);
}

TEST_F(StandTest, NoRootCanBeChosenWithoutAScan) {
  open({writeFork("fork.mtg")});
  EXPECT_FALSE(find<QComboBox>("root").isEnabled());
  EXPECT_FALSE(action("root_lowest").isEnabled());
}

} // namespace
} // namespace espalier
