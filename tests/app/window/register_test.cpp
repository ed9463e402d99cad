// Another scan of the plant, laid on the open one, in the real window.
#include "core/base/random.h"
#include "tests/app/window/register_fixture.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QTest>
#include <QToolButton>

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

struct RegisterTest : test::RegistrationTest {
  const std::vector<Vector3d> spheres_ = {{0.9, -0.3, 0.3}, {-0.8, -0.3, 0.5}, {0.4, -0.4, 2.2}};

  void addSpheres(const Vector3d& beside = Vector3d::Zero()) {
    std::ofstream out(north_.toStdString(), std::ios::app);
    Random random(5);
    for (const Vector3d& center : spheres_)
      for (int i = 0; i < 1500; ++i) {
        const Vector3d direction(random.normal(), random.normal(), random.normal());
        out << (center + beside + 0.07 * direction.normalized()).transpose() << '\n';
      }
  }
  /// @param beside  how far those of the other scan were put elsewhere
  void pickSpheres(const Vector3d& beside = Vector3d::Zero()) {
    find<QCheckBox>("registration_spheres").setChecked(true);
    find<QDoubleSpinBox>("registration_radius").setValue(0.07);
    for (std::size_t i = 0; i < spheres_.size(); ++i) {
      const QString before = next();
      clickPlace(spheres_[i]);
      EXPECT_TRUE(QTest::qWaitFor([&] { return next() != before; }, patience));
      clickPlace(truth_.inverse() * (spheres_[i] + beside));
      EXPECT_TRUE(QTest::qWaitFor([&] { return pairs().rowCount() == int(i) + 1; }, patience));
    }
  }
};

TEST_F(RegisterTest, AsksForATargetInOneScanThenInTheOther) {
  begin();
  EXPECT_EQ(next(), "Click a target in the open scan (blue)");
  EXPECT_TRUE(
      window().statusLine().shownText().startsWith("Click a target in the open scan (blue)"))
      << window().statusLine().shownText().toStdString();
  clickPlace(targets_[0]);
  EXPECT_EQ(next(), "Click the same target in south.ply (orange)");
  clickPlace(truth_.inverse() * targets_[0]);
  EXPECT_EQ(next(), "Click a target in the open scan (blue)");
  EXPECT_EQ(pairs().rowCount(), 1);
  EXPECT_FALSE(action("join_scans").isEnabled());
}

TEST_F(RegisterTest, ThreePairsMoveTheScanAndShowHowFarEachIsApart) {
  begin();
  pickPair(0);
  pickPair(1);
  const QImage before = view().picture({400, 400});
  EXPECT_EQ(pairs().item(0, 1)->text(), "");
  pickPair(2);
  ASSERT_EQ(pairs().rowCount(), 3);
  for (int row = 0; row < 3; ++row)
    EXPECT_TRUE(pairs().item(row, 1)->text().endsWith("m")) << row;
  EXPECT_THAT(find<QLabel>("registration_by_pairs").text().toStdString(),
              HasSubstr("Of all pairs"));
  EXPECT_NE(view().picture({400, 400}), before);
  EXPECT_TRUE(action("join_scans").isEnabled());
}

TEST_F(RegisterTest, ATargetOrAPairIsTakenBack) {
  begin();
  pickThree();
  clickPlace(targets_[3]);
  key(Qt::Key_Backspace);
  EXPECT_THAT(next().toStdString(), HasSubstr("Click another target in the open scan"));
  EXPECT_EQ(pairs().rowCount(), 3);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(pairs().rowCount(), 2);
  EXPECT_FALSE(action("join_scans").isEnabled());
  QTest::mouseClick(window().findChildren<QToolButton*>("registration_remove").front(),
                    Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([this] { return pairs().rowCount() == 1; }, patience));
  action("reset_registration").trigger();
  EXPECT_EQ(pairs().rowCount(), 0);
  EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(RegisterTest, CentersOfSpheresAreFoundFromAClickAnywhereOnThem) {
  addSpheres();
  writeSouth();
  begin();
  pickSpheres();
  const QString rms = find<QLabel>("registration_by_pairs").text();
  EXPECT_THAT(rms.toStdString(), testing::ContainsRegex("0\\.000"));
}

TEST_F(RegisterTest, ItsPointsAreFittedAndColoredByDistance) {
  begin();
  pickThree();
  fit();
  EXPECT_THAT(find<QLabel>("registration_by_points").text().toStdString(), HasSubstr("100 % over"));
  const QImage before = view().picture({400, 400});
  action("color_scan_distance").trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return view().picture({400, 400}) != before; }, patience));
  action("color_scan_distance").trigger();
  EXPECT_EQ(view().picture({400, 400}), before);
}

// The spheres were put elsewhere before the other scan.
TEST_F(RegisterTest, SaysThatTargetsLieFartherApartByPointsAndTakesTheFitBack) {
  const Vector3d beside(0, 0, -0.05);
  writeScan("north.xyz");
  addSpheres(beside);
  writeSouth();
  writeScan("north.xyz");
  addSpheres();
  begin();
  pickSpheres(beside);
  auto& warning = find<QLabel>("registration_warning");
  EXPECT_EQ(warning.text(), "");
  fit();
  EXPECT_THAT(warning.text().toStdString(),
              testing::AllOf(HasSubstr("By points, the targets are"), HasSubstr("Ctrl+Z")));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(warning.text(), "");
  EXPECT_EQ(pairs().rowCount(), 3);
  EXPECT_EQ(find<QLabel>("registration_by_points").text(), "");
}

TEST_F(RegisterTest, AFitThatIsCanceledChangesNothing) {
  begin();
  const QImage before = view().picture({400, 400});
  action("fit_scan").trigger();
  window().jobs().cancel();
  waitForJob();
  EXPECT_TRUE(find<QLabel>("registration_by_points").text().isEmpty());
  EXPECT_EQ(view().picture({400, 400}), before);
  EXPECT_FALSE(action("join_scans").isEnabled());
}

TEST_F(RegisterTest, EscapeAsksOnlyIfThereIsWorkToLose) {
  begin();
  expectNoDialog([this] { key(Qt::Key_Escape); });
  EXPECT_FALSE(action("fit_scan").isEnabled());
  beginAgain();
  pickPair(0);
  clickPlace(targets_[1]);
  expectNoDialog([this] { key(Qt::Key_Escape); }); // drops the place that waits for its other
  answer(press("Go On"), [this] { key(Qt::Key_Escape); });
  EXPECT_TRUE(action("fit_scan").isEnabled());
  answer(press("Leave"), [this] { key(Qt::Key_Escape); });
  EXPECT_FALSE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(RegisterTest, NothingIsReconstructedMeanwhile) {
  begin();
  fit();
  EXPECT_FALSE(action("reconstruct").isEnabled());
  answer(press("Leave"), [this] { action("leave_registration").trigger(); });
  EXPECT_TRUE(action("reconstruct").isEnabled());
}

TEST_F(RegisterTest, WarnsOfPairsThatDoNotFitTogether) {
  begin();
  auto& warning = find<QLabel>("registration_warning");
  pickThree();
  EXPECT_EQ(warning.text(), "");
  key(Qt::Key_Backspace);
  clickPlace(targets_[2]);
  clickPlace(truth_.inverse() * targets_[3]);
  ASSERT_EQ(pairs().rowCount(), 3);
  EXPECT_THAT(warning.text().toStdString(), HasSubstr("The pairs do not fit together"));
}

} // namespace
} // namespace espalier
