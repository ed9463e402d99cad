// Previews by mouse and keys in the real window.
#include "core/base/random.h"
#include "tests/app/window/preview_fixture.h"
#include "tests/support/shared_data.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/status_line.h"
#include "ui/panels/sweep_strip.h"
#include "ui/view/color_bar.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QTimer>
#include <QUndoStack>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>

namespace espalier {
namespace {

using test::PreviewTest;

TEST_F(PreviewTest, ShowsWhatTheStepsWouldMakeAndChangesNothing) {
  turnOn();
  EXPECT_TRUE(panel().isLive());
  EXPECT_FALSE(shown()->skeleton->isEmpty());
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_FALSE(document().undoStack().canUndo());
  EXPECT_EQ(view().divider(), 0) << "it fills the view";
  key(Qt::Key_L, Qt::ControlModifier);
  EXPECT_FALSE(shown());
  EXPECT_EQ(view().divider(), 1);
}

TEST_F(PreviewTest, ThePlantIsDrawnUntilSomethingIsDoneOtherwise) {
  const QImage scan = view().picture({300, 200});
  type("contract", "radius", 0.1);
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  const auto saysPreview = [&] { return window().statusLine().shownText().startsWith("Preview"); };
  const QImage before = view().picture({300, 200});
  turnOn();
  EXPECT_EQ(view().picture({300, 200}), before);
  type("contract", "radius", 0.2);
  waitForPreview();
  EXPECT_NE(view().picture({300, 200}), before);
  EXPECT_TRUE(QTest::qWaitFor(saysPreview, patience)) << "once it has reported the step";
  type("contract", "radius", 0.1);
  waitForPreview();
  EXPECT_EQ(view().picture({300, 200}), before);
  EXPECT_FALSE(saysPreview());
  view().setFocus();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_NE(view().picture({300, 200}), scan) << "the preview is other than nothing";
}

TEST_F(PreviewTest, ShowsWhatAnotherRootWouldMakeAndDropsIt) {
  turnOn();
  const auto rootShown = [&] {
    const Skeleton& skeleton = *shown()->skeleton;
    return skeleton[skeleton.roots().front()].position;
  };
  const Eigen::Vector3d lowest = rootShown();
  document().setRoot(Eigen::Vector3d(0.8, 0, 1.6)); // the end of a branch
  waitForPreview();
  EXPECT_LT((rootShown() - *document().root()).norm(), 0.1);
  EXPECT_TRUE(window().part<PreviewFlow>().name().startsWith("Root: picked"));
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_FALSE(document().root()) << "with the choices that led to it";
  EXPECT_FALSE(shown());
  ASSERT_TRUE(panel().isLive()) << "what is chosen next is shown";
  key(Qt::Key_L, Qt::ControlModifier);
  turnOn();
  ASSERT_TRUE(shown());
  EXPECT_EQ(rootShown(), lowest);
}

TEST_F(PreviewTest, TheScanKeepsItsPlacesAndColorsUntilItIsContractedOtherwise) {
  const auto isKeyShown = [&] {
    return std::ranges::any_of(view().findChildren<ColorBar*>(), &QWidget::isVisible);
  };
  ASSERT_TRUE(isKeyShown());
  turnOn();
  waitForView();
  EXPECT_TRUE(isKeyShown());
  type("prune", "length", 0.3);
  waitForPreview();
  waitForView();
  EXPECT_TRUE(isKeyShown());
  type("contract", "radius", 0.12);
  waitForPreview();
  waitForView();
  EXPECT_FALSE(isKeyShown()) << "contracted points have one color";
}

TEST_F(PreviewTest, GoesOnWithAnotherScan) {
  turnOn();
  open({writeScan("other.xyz")});
  waitForPreview();
  EXPECT_TRUE(panel().isLive());
}

TEST_F(PreviewTest, OfAReconstructedPlantGoesWhenAnotherScanIsOpened) {
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  turnOn();
  ASSERT_TRUE(shown());
  open({writeScan("other.xyz")});
  waitForPreview();
  EXPECT_TRUE(document().skeleton().isEmpty());
  EXPECT_TRUE(shown());
}

TEST_F(PreviewTest, PanelsStayWithinTheSmallestWindowAndShowAllScoresInALargerOne) {
  window().resize(window().minimumSize());
  key(Qt::Key_F7, Qt::ShiftModifier);
  const auto& dock = find<QDockWidget>("sweep");
  QCoreApplication::processEvents();
  EXPECT_LT(dock.geometry().right(), window().width());
  EXPECT_LT(dock.geometry().bottom(), window().height());
  window().resize(1280, 800);
  find<QSpinBox>("sweep_count").setValue(2);
  clickButton("sweep_run");
  const auto& strip = find<SweepStrip>("sweep_strip");
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return strip.cards().size() == 2 && !strip.cards()[1]->item().scores.empty() &&
               strip.height() >= strip.heightForScores();
      },
      patience))
      << strip.height() << " of " << strip.heightForScores();
}

TEST_F(PreviewTest, EnterInAnOpenListChoosesThereAlone) {
  auto* method = step("contract").findChild<QComboBox*>();
  method->setFocus();
  method->showPopup();
  QTest::keyClick(method->view(), Qt::Key_Down);
  QTest::keyClick(method->view(), Qt::Key_Return);
  EXPECT_EQ(method->currentIndex(), 1);
  EXPECT_FALSE(action("show_review").isChecked()) << "whose key it is elsewhere";
}

TEST_F(PreviewTest, FollowsAKnobAndIsTheRealRunBitForBit) {
  turnOn();
  const Skeleton before = *shown()->skeleton;
  type("contract", "radius", 0.12);
  waitForPreview();
  EXPECT_EQ(radiusOf(*shown()), 0.12);
  EXPECT_NE(*shown()->skeleton, before);
  const Outcome preview = *shown();
  Pipeline pipeline;
  const Reconstruction real = pipeline.run(document().scan()->cloud(), panel().options());
  EXPECT_EQ(*preview.contracted, *real.contracted);
  EXPECT_EQ(*preview.skeleton, *real.skeleton);
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  EXPECT_FALSE(shown()) << "it is the plant now";
  EXPECT_EQ(document().contracted(), preview.contracted) << "what the preview computed was at hand";
  EXPECT_EQ(document().skeleton().size(), preview.skeleton->size());
  EXPECT_EQ(view().divider(), 1);
}

TEST_F(PreviewTest, EscapeDropsItAndTheChoicesThatLedToIt) {
  const PipelineOptions before = panel().options();
  turnOn();
  type("contract", "radius", 0.12);
  waitForPreview();
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_FALSE(shown());
  EXPECT_EQ(panel().options(), before);
  EXPECT_FALSE(document().undoStack().canUndo());
}

TEST_F(PreviewTest, ShowsOnlyTheLastOfManyTurnsOfAKnob) {
  turnOn();
  std::vector<double> seen;
  QObject::connect(&window().part<PreviewFlow>(), &PreviewFlow::changed, &window(), [&] {
    if (shown() && shown()->options.settings.contains("contract"))
      seen.push_back(radiusOf(*shown()));
  });
  auto* slider = step("contract").findChildren<QSlider*>().back(); // of the radius
  for (int i = 0; i < 30; ++i)
    QTest::keyClick(slider, Qt::Key_Right);
  waitForPreview();
  EXPECT_EQ(shown()->options, panel().options());
  EXPECT_LE(seen.size(), 8U) << "what is out of date is dropped, never queued";
}

TEST_F(PreviewTest, SaysWhyAStepFails) {
  auto* method = step("contract").findChild<QComboBox*>();
  method->setCurrentIndex(method->findData("adaptive_geodesic"));
  emit method->activated(method->currentIndex());
  turnOn();
  type("contract", "along", 0);
  type("contract", "across", 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window().banner().isVisible(); }, patience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window().part<PreviewFlow>().isBusy(); }, patience));
  EXPECT_TRUE(window().banner().text().contains("raise one of them"))
      << window().banner().text().toStdString();
  EXPECT_TRUE(document().skeleton().isEmpty());
  type("contract", "along", 1);
  waitForPreview();
  EXPECT_FALSE(window().banner().isVisible()) << "it is mended";
}

TEST_F(PreviewTest, StepsShowHowTheyStand) {
  using State = StepForm::State;
  EXPECT_EQ(step("prune").state(), State::idle);
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  for (const StepForm* form : panel().steps())
    EXPECT_EQ(form->state(), State::done) << form->step().name;
  type("contract", "radius", 0.2);
  EXPECT_EQ(step("clean").state(), State::done);
  for (const char* name : {"contract", "skeleton", "prune", "radius"})
    EXPECT_EQ(step(name).state(), State::stale) << name << ": of another choice";
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  EXPECT_EQ(step("radius").state(), State::done);
  turnOn();
  type("contract", "radius", 0.12);
  waitForPreview();
  view().setFocus();
  key(Qt::Key_Escape);
  EXPECT_EQ(step("contract").state(), State::done) << "the plant is of these choices again";
  QUndoStack& stack = document().undoStack();
  EXPECT_TRUE(stack.undoText().startsWith("Reconstruct: Contract: radius 0.2"));
  stack.undo();
  EXPECT_EQ(step("clean").state(), State::done);
  EXPECT_EQ(step("contract").state(), State::stale) << "the plant before has another radius";
  stack.undo();
  EXPECT_EQ(step("clean").state(), State::idle) << "there is no plant";
  stack.redo();
  stack.redo();
  EXPECT_EQ(step("radius").state(), State::done);
}

TEST_F(PreviewTest, UndoSaysThatItDropsThePreviewFirst) {
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  EXPECT_EQ(action("undo").text(), "&Undo: Reconstruct");
  turnOn();
  type("contract", "radius", 0.12);
  waitForPreview();
  EXPECT_EQ(action("undo").text(), "Drop the &Preview");
  view().setFocus();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(shown());
  EXPECT_FALSE(document().skeleton().isEmpty());
  EXPECT_EQ(action("undo").text(), "&Undo: Reconstruct");
}

TEST_F(PreviewTest, AMethodIsFoundAgainAsItWasLeft) {
  const auto choose = [&](const char* name) {
    auto* method = step("contract").findChild<QComboBox*>();
    method->setCurrentIndex(method->findData(name));
    emit method->activated(method->currentIndex());
  };
  type("contract", "radius", 0.12);
  EXPECT_EQ(find<QLabel>("set_of_contract").text(), QString::fromUtf8("↺ 1"));
  const PipelineOptions mine = panel().options();
  choose("adaptive_geodesic");
  EXPECT_FALSE(panel().options().settings.contains("contract"));
  choose("geodesic_centroid");
  EXPECT_EQ(panel().options(), mine);
  choose("geodesic_centroid");
  EXPECT_EQ(panel().options(), mine) << "the same once more";
  panel().setOptions({});
  EXPECT_EQ(find<QLabel>("set_of_contract").text(), "");
  choose("adaptive_geodesic");
  choose("geodesic_centroid");
  EXPECT_FALSE(panel().options().settings.contains("contract")) << "other settings were taken";
}

TEST_F(PreviewTest, RunsUpToOneStep) {
  press("run_to_contract");
  waitForJob();
  EXPECT_TRUE(document().skeleton().isEmpty());
  ASSERT_NE(document().contracted(), nullptr);
  EXPECT_EQ(step("contract").state(), StepForm::State::done);
  EXPECT_EQ(step("skeleton").state(), StepForm::State::idle);
  press("run_to_skeleton");
  waitForJob();
  EXPECT_FALSE(document().skeleton().isEmpty());
  const Skeleton raw = document().skeleton();
  press("run_to_contract");
  waitForJob();
  EXPECT_EQ(document().skeleton(), raw) << "the contracted points alone are new";
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().skeleton().isEmpty());
}

TEST_F(PreviewTest, NamesWhatWasChangedBeforeItWasTurnedOn) {
  type("contract", "radius", 0.12);
  turnOn();
  EXPECT_EQ(window().part<PreviewFlow>().name(), QString::fromUtf8("Contract: radius 0.12\u202fm"));
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  type("prune", "length", 0.3);
  waitForPreview();
  EXPECT_EQ(window().part<PreviewFlow>().name(), QString::fromUtf8("Prune: length 0.3\u202fm"))
      << "the plant has the radius now";
}

TEST_F(PreviewTest, LooksCloselyAtWhatAPreviewDraws) {
  turnOn();
  type("contract", "radius", 0.12);
  waitForPreview();
  waitForView();
  const Camera before = view().camera();
  hover(view().project({0, 0, 1.5})->toPoint());
  key(Qt::Key_Z);
  waitForView();
  EXPECT_LT(view().camera().halfHeight(), 0.7 * before.halfHeight());
  const PointCloud& cloud = *document().scan()->cloud();
  const auto distanceTo = [&](const Eigen::Matrix3Xf& points) {
    const Eigen::Vector3f focus = (view().camera().focus - cloud.origin()).cast<float>();
    return std::sqrt((points.colwise() - focus).colwise().squaredNorm().minCoeff());
  };
  EXPECT_LT(distanceTo(*shown()->contracted), 1e-5) << "where the preview draws a point";
  EXPECT_GT(distanceTo(cloud.positions()), 1e-3);
}

TEST_F(PreviewTest, DrawsWhatTheMethodSeesUnderTheMouse) {
  key(Qt::Key_R, Qt::ControlModifier);
  waitForJob();
  action("layer_skeleton").setChecked(false);
  key(Qt::Key_0, Qt::ControlModifier);
  const QPoint trunk = view().project({0, 0, 1.5})->toPoint();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        hover(trunk);
        return view().sightShown() && view().sightShown()->point;
      },
      patience));
  const ShownSight& sight = *view().sightShown();
  EXPECT_FALSE(sight.neighbors.empty());
  EXPECT_GT(sight.ball.size(), sight.neighbors.size());
  EXPECT_GT(std::abs(sight.direction.z()), 0.9) << "along the trunk";
  EXPECT_LT((sight.moved - *sight.point).norm(), 0.1);
  key(Qt::Key_0, Qt::ControlModifier);
  EXPECT_FALSE(view().sightShown());
}

/// Over a scan that is too large to be previewed at once.
class RegionPreviewTest : public PreviewTest {
protected:
  RegionPreviewTest() {
    std::ofstream out(path("large.xyz").toStdString());
    Random random(3);
    for (int i = 0; i < 30000; ++i) {
      const double angle = 2 * std::numbers::pi * random.uniform();
      out << 0.05 * std::cos(angle) << ' ' << 0.05 * std::sin(angle) << ' ' << 4 * random.uniform()
          << '\n';
    }
    out.close();
    open({path("large.xyz")});
    action("view_front").trigger();
    waitForView();
  }
};

TEST_F(RegionPreviewTest, ShowsABallAtOnceAndThenTheWhole) {
  std::vector<bool> areParts;
  QStringList names;
  const auto& preview = window().part<PreviewFlow>();
  QObject::connect(&preview, &PreviewFlow::changed, &window(), [&] {
    if (!shown()) return;
    areParts.push_back(shown()->within.has_value());
    names.append(preview.name());
  });
  turnOn();
  ASSERT_GE(areParts.size(), 2U);
  EXPECT_TRUE(areParts.front());
  EXPECT_TRUE(names.front().endsWith(" · in the circle")) << names.front().toStdString();
  EXPECT_FALSE(areParts.back());
  EXPECT_FALSE(names.back().contains("circle")) << names.back().toStdString();
}

TEST_F(RegionPreviewTest, ShowsTheBallWhereThePointerPutIt) {
  const Eigen::Vector3d place(0, -0.05, 3.5);
  hover(view().project(place)->toPoint());
  std::optional<Ball> ball;
  QObject::connect(&window().part<PreviewFlow>(), &PreviewFlow::changed, &window(), [&] {
    if (shown() && shown()->within) ball = shown()->within;
  });
  key(Qt::Key_L, Qt::ShiftModifier);
  waitForPreview();
  ASSERT_TRUE(ball);
  EXPECT_LT((ball->center - place).norm(), 0.1);
}

/// How long the window does not answer while knobs are turned; printed, not judged: machines
/// differ. Its event loop runs as ever, so that no wait of a test counts.
TEST_F(PreviewTest, AnswersWhileKnobsAreTurned) {
  ESPALIER_SHARED_FILE(scan, "puu1/scan.ply");
  open({QString::fromStdString(scan.string())});
  key(Qt::Key_L, Qt::ControlModifier);
  auto* slider = step("contract").findChildren<QSlider*>().back(); // of the radius
  const int turns = qEnvironmentVariableIntValue("ESPALIER_TURNS") + 20;
  int shownParts = 0;
  QObject::connect(&window().part<PreviewFlow>(), &PreviewFlow::changed, &window(), [&] {
    if (shown() && shown()->within) ++shownParts;
  });
  QEventLoop loop;
  int turn = 0;
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, &window(), [&] {
    QTest::keyClick(slider, turn % 20 < 10 ? Qt::Key_Right : Qt::Key_Left);
    ++turn;
    hand.setInterval(turn % 10 == 0 ? 400 : 60); // it rests now and then
    if (turn == turns) loop.quit();
  });
  std::vector<qint64> blocks; // [ms], from beat to beat
  QElapsedTimer sinceBeat;
  QTimer heart;
  QObject::connect(&heart, &QTimer::timeout, &window(),
                   [&] { blocks.push_back(sinceBeat.restart()); });
  sinceBeat.start();
  heart.start(5);
  hand.start(60);
  loop.exec();
  hand.stop();
  heart.stop();
  waitForPreview();
  std::ranges::sort(blocks);
  const auto share = [&](double part) {
    return blocks[static_cast<std::size_t>(part * double(blocks.size() - 1))];
  };
  RecordProperty("longest_block_ms", static_cast<int>(blocks.back()));
  std::cout << "longest block " << blocks.back() << " ms, 99 of 100 within " << share(0.99)
            << " ms, " << blocks.size() << " beats, " << shownParts << " parts shown in " << turns
            << " turns\n";
  EXPECT_GT(std::ssize(blocks), turns) << "the window went on while previews were computed";
  EXPECT_GT(shownParts, 0);
}

} // namespace
} // namespace espalier
