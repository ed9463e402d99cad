// Another scan of the plant, laid on the open one and joined with it, in the real window.
#include "core/base/random.h"
#include "core/cloud/joined_clouds.h"
#include "core/io/formats.h"
#include "core/skeleton/bounds.h"
#include "tests/app/window/project_fixture.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/status_line.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include <fstream>
#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

/// The scan of a plant, north.xyz, and the same again from a frame of its own, south.ply.
struct RegisterTest : test::ProjectWindowTest {
  const QString north_ = writeScan("north.xyz");
  const QString south_ = path("south.ply");
  const Eigen::Isometry3d truth_ =
      Eigen::Translation3d(0.06, -0.05, 0.04) *
      Eigen::AngleAxisd(3 * std::numbers::pi / 180, Vector3d::UnitZ()) *
      Eigen::Isometry3d::Identity();
  /// Where branches end.
  const std::vector<Vector3d> targets_ = {
      {0.8, 0, 1.6}, {-0.7, 0.1, 1.9}, {0.1, 0.7, 1.3}, {0, 0, 0.1}};

  RegisterTest() { writeSouth(); }

  void writeSouth() {
    const auto cloud = std::make_shared<const PointCloud>(readPoints(toPath(north_)).value);
    writePoints(toPath(south_),
                joined({{.cloud = cloud, .motion = truth_.inverse(), .name = "south"}}));
  }

  void begin() {
    open({north_});
    document().setUnit(LengthUnit::meter);
    beginAgain();
  }
  void beginAgain() {
    answer(chooseFile(south_), [this] { action("register_scan").trigger(); });
    waitForJob();
    waitForView();
  }
  [[nodiscard]] const PointCloud& cloud() { return *document().scan()->cloud(); }
  void clickPlace(const Vector3d& place) {
    const QPointF at = view().project(place).value();
    hover(at.toPoint());
    click(at.toPoint());
  }
  /// Clicks a target in the open scan, then in the other one, which lies as it was read.
  void pickPair(std::size_t target) {
    clickPlace(targets_[target]);
    clickPlace(truth_.inverse() * targets_[target]);
  }
  void pickThree() {
    for (const std::size_t target : {0, 1, 2})
      pickPair(target);
  }
  void fit() {
    action("fit_scan").trigger();
    waitForJob();
  }
  void join(const QString& name) {
    answer(chooseFile(path(name)), [this] { action("join_scans").trigger(); });
    waitForJob();
  }
  [[nodiscard]] QString next() { return find<QLabel>("registration_next").text(); }
  [[nodiscard]] QTableWidget& pairs() { return find<QTableWidget>("registration_pairs"); }
  /// How far what was joined lies from where it belongs, at most [L].
  [[nodiscard]] double farthestOff() {
    const Eigen::Index half = cloud().size() / 2;
    const PointCloud moved = readPoints(toPath(south_)).value;
    const SpatialIndex index(moved.positions());
    double farthest = 0;
    for (Eigen::Index i = half; i < cloud().size(); ++i) {
      const Vector3d place = truth_.inverse() * cloud().position(i) - moved.origin();
      const auto nearest = index.nearestOne(place.cast<float>());
      farthest = std::max(
          farthest, double((moved.positions().col(nearest->index) - place.cast<float>()).norm()));
    }
    return farthest;
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
  const std::vector<Vector3d> centers = {{0.9, -0.3, 0.3}, {-0.8, -0.3, 0.5}, {0.4, -0.4, 2.2}};
  std::ofstream out(north_.toStdString(), std::ios::app);
  Random random(5);
  for (const Vector3d& center : centers)
    for (int i = 0; i < 1500; ++i) {
      const Vector3d direction(random.normal(), random.normal(), random.normal());
      out << (center + 0.07 * direction.normalized()).transpose() << '\n';
    }
  out.close();
  writeSouth();
  begin();
  find<QCheckBox>("registration_spheres").setChecked(true);
  find<QDoubleSpinBox>("registration_radius").setValue(0.07);
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const QString before = next();
    clickPlace(centers[i]);
    EXPECT_TRUE(QTest::qWaitFor([&] { return next() != before; }, patience));
    clickPlace(truth_.inverse() * centers[i]);
    EXPECT_TRUE(QTest::qWaitFor([&] { return pairs().rowCount() == int(i) + 1; }, patience));
  }
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

TEST_F(RegisterTest, TheJoinedScanIsOneStepThatIsUndoneAndRedone) {
  begin();
  const Eigen::Index points = cloud().size();
  fit();
  join("both.ply");
  ASSERT_EQ(cloud().size(), 2 * points);
  EXPECT_LT(farthestOff(), 0.01);
  EXPECT_EQ(cloud().stations().size(), 2U);
  EXPECT_EQ(document().undoStack().count(), 1);
  EXPECT_EQ(document().step(0).text, "Join south.ply");
  EXPECT_TRUE(document().leftOut().isEmpty());
  EXPECT_EQ(document().scanPath(), path("both.ply"));
  EXPECT_TRUE(action("tool_move").isEnabled()) << "the registration is over";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().leftOut(), PointSet::firstOf(2 * points) - PointSet::firstOf(points));
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(document().leftOut().isEmpty());
}

TEST_F(RegisterTest, AProjectOpensTheJoinedScanWithAllItsSteps) {
  open({north_});
  const PointSet some = PointSet::of({3, 4, 5, 900});
  document().leaveOut("Set points aside", some);
  const Vector3d place = cloud().position(900);
  const QString file = saveProject("plant.espalier");
  beginAgain();
  fit();
  join("both.ply");
  EXPECT_EQ(document().leftOut(), some);
  EXPECT_LT((cloud().position(900) - place).norm(), 1e-5);
  const Eigen::Matrix3Xf positions = cloud().positions();
  window().close();
  restart();
  open({file});
  EXPECT_EQ(cloud().positions(), positions);
  EXPECT_EQ(document().leftOut(), some);
  EXPECT_EQ(document().undoStack().count(), 2);
  document().goTo(0);
  EXPECT_EQ(document().leftOut(),
            PointSet::firstOf(cloud().size()) - PointSet::firstOf(cloud().size() / 2));
}

TEST_F(RegisterTest, AJoinThatWasUndoneForAnotherStepStaysSetAside) {
  open({north_});
  const PointSet some = PointSet::of({3, 4, 5, 900});
  const Vector3d place = cloud().position(900);
  const Eigen::Index points = cloud().size();
  const QString file = saveProject("plant.espalier");
  beginAgain();
  fit();
  join("both.ply");
  document().undoStack().undo();
  document().leaveOut("Set points aside", document().leftOut() | some);
  window().close();
  restart();
  open({file});
  EXPECT_EQ(cloud().size(), 2 * points);
  EXPECT_EQ(document().undoStack().count(), 1);
  EXPECT_EQ(document().leftOut(),
            some | (PointSet::firstOf(2 * points) - PointSet::firstOf(points)));
  EXPECT_LT((cloud().position(900) - place).norm(), 1e-5);
}

TEST_F(RegisterTest, ContractedPointsOfAllStepsGrowWithTheScan) {
  begin();
  action("leave_registration").trigger();
  auto contracted = std::make_shared<Eigen::Matrix3Xf>(cloud().positions());
  *contracted *= 0.5F;
  document().contract("Contract", contracted);
  const Eigen::Index points = cloud().size();
  const Vector3d place = contracted->col(7).cast<double>() + cloud().origin();
  beginAgain();
  fit();
  join("both.ply");
  ASSERT_EQ(document().contracted()->cols(), 2 * points);
  const auto at = [&] {
    return Vector3d(document().contracted()->col(7).cast<double>() + cloud().origin());
  };
  EXPECT_LT((at() - place).norm(), 1e-5);
  document().goTo(0);
  EXPECT_EQ(document().contracted(), nullptr);
  document().goTo(2);
  EXPECT_LT((at() - place).norm(), 1e-5);
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

TEST_F(RegisterTest, AnotherScanIsOfferedToBeRegistered) {
  open({north_});
  answer(press("Cancel"), [this] { window().open({south_}); });
  EXPECT_FALSE(window().jobs().isBusy());
  answer(press("Register"), [this] { window().open({south_}); });
  waitForJob();
  EXPECT_TRUE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().scanPath(), north_);
  answer(press("Open Alone"), [this] { window().open({south_}); });
  waitForJob();
  EXPECT_FALSE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().scanPath(), south_);
}

// Another scan, a project, a recent file, a new plant, and the window's close.
TEST_F(RegisterTest, WhatTakesThePlantAwayAsksForTheTargetsFirst) {
  const QString other = writeScan("other.xyz");
  open({other});
  const QString project = saveProject("other.espalier");
  begin();
  pickPair(0);
  const auto openOther = [&](const QString& answered) {
    answer(press("Open Alone"), [&] { window().open({other}); });
    answer(press(answered), [this] { waitForJob(); });
  };
  const auto openProject = [&](const QString& answered) {
    answer(press(answered), [&] {
      window().open({project});
      waitForJob();
    });
  };
  openOther("Go On");
  openProject("Go On");
  answer(press("Go On"), [this] { action("new_plant").trigger(); });
  answer(press("Go On"), [this] { window().close(); });
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(document().scanPath(), north_);
  EXPECT_EQ(pairs().rowCount(), 1);
  openOther("Leave");
  EXPECT_EQ(document().scanPath(), other);
  EXPECT_FALSE(action("fit_scan").isEnabled());
  begin();
  pickPair(0);
  openProject("Leave");
  EXPECT_EQ(document().filePath(), project);
  begin();
  pickPair(0);
  answer(press("Leave"), [this] { action("new_plant").trigger(); });
  EXPECT_EQ(document().scan(), nullptr);
}

// Who goes on with the registration goes on in the same project.
TEST_F(RegisterTest, AWindowThatStaysOpenKeepsItsProject) {
  open({north_});
  const QString file = saveProject("plant.espalier");
  beginAgain();
  pickPair(0);
  answer(press("Go On"), [this] { window().close(); });
  document().leaveOut("Set points aside", PointSet::of({1}));
  EXPECT_EQ(onDisk(file).steps.size(), 1U);
}

// A step would change what is being registered, and be in the way of taking targets back.
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

// A structure comes under the same scan.
TEST_F(RegisterTest, AStructureIsOpenedWhileItGoesOn) {
  begin();
  pickPair(0);
  const QString fork = writeFork("fork.mtg");
  expectNoDialog([&] { open({fork}); });
  EXPECT_FALSE(document().skeleton().isEmpty());
  EXPECT_EQ(pairs().rowCount(), 1);
}

TEST_F(RegisterTest, AScanThatIsDroppedOnAnotherIsOfferedToBeRegistered) {
  open({north_});
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(south_)});
  QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window(), &enter);
  QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  expectNoDialog([&] { QApplication::sendEvent(&window(), &drop); }); // not before it has ended
  answer(press("Register"), [] { QApplication::processEvents(); });
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("fit_scan").isEnabled(); }, patience));
  EXPECT_EQ(document().scanPath(), north_);
}

TEST_F(RegisterTest, TwoScansAreOpenedOneToBeRegisteredToTheOther) {
  answer(press("Register"), [this] { window().open({north_, south_}); });
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("fit_scan").isEnabled(); }, patience));
  EXPECT_EQ(document().scanPath(), north_);
}

TEST_F(RegisterTest, OfTwoScansTheFirstIsOpenedAlone) {
  answer(
      [](QDialog& dialog) {
        EXPECT_THAT(dynamic_cast<QMessageBox&>(dialog).informativeText().toStdString(),
                    HasSubstr("Or open north.xyz alone"));
        press("Open Alone")(dialog);
      },
      [this] {
        window().open({north_, south_});
      });
  waitForJob();
  EXPECT_EQ(document().scanPath(), north_);
  EXPECT_FALSE(action("fit_scan").isEnabled());
}

// The old file of that name, and nothing beside it, is what a stopped join leaves.
TEST_F(RegisterTest, AJoinThatIsCanceledLeavesEachFileAsItWas) {
  begin();
  fit();
  const QString file = path("both.ply");
  ASSERT_TRUE(QFile::copy(south_, file));
  const auto files = [this] { return QDir(path("")).entryList(QDir::Files | QDir::Hidden); };
  const QStringList before = files();
  const auto bytes = QFileInfo(file).size();
  const Eigen::Index points = cloud().size();
  const auto meta =
      QObject::connect(&window().jobs(), &JobSlot::progressed, &window(), [this](double fraction) {
        if (fraction > 0.5) window().jobs().cancel();
      });
  QTimer agrees; // to replace the file
  QObject::connect(&agrees, &QTimer::timeout, &agrees, [] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question != nullptr) press("Yes")(*question);
  });
  agrees.start(0);
  join("both.ply");
  QObject::disconnect(meta);
  EXPECT_EQ(files(), before);
  EXPECT_EQ(QFileInfo(file).size(), bytes);
  EXPECT_EQ(cloud().size(), points);
  EXPECT_EQ(document().undoStack().count(), 0);
  EXPECT_TRUE(action("join_scans").isEnabled());
}

TEST_F(RegisterTest, TheOpenPartOfAScanIsJoined) {
  QSettings(path("settings.ini"), QSettings::IniFormat).setValue("most_points_at_once", 300);
  answer(press("Open"), [this] { open({north_}); });
  waitForJob();
  ASSERT_EQ(cloud().size(), 300);
  QSettings(path("settings.ini"), QSettings::IniFormat).setValue("most_points_at_once", 1'000'000);
  document().leaveOut("Set aside", PointSet::of({3, 4}));
  beginAgain();
  fit();
  const Eigen::Index both = 300 + readPoints(toPath(south_)).value.size();
  join("both.ply");
  EXPECT_THAT(message().toStdString(), HasSubstr("Of north.xyz, it holds the part that was read"));
  EXPECT_EQ(cloud().size(), both);
  EXPECT_EQ(document().leftOut(), PointSet::of({3, 4})) << "what was set aside stays so";
  EXPECT_FALSE(action("read_region").isEnabled()) << "the joined file is read whole";
  document().undoStack().undo();
  EXPECT_EQ(document().leftOut().size(), both - 300 + 2);
  document().undoStack().redo();
  const QString file = saveProject("both.espalier");
  const Eigen::Matrix3Xf points = cloud().positions();
  window().close();
  restart();
  open({file});
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().positions(), points);
  EXPECT_EQ(document().leftOut(), PointSet::of({3, 4}));
  EXPECT_FALSE(action("read_region").isEnabled());
}

TEST_F(RegisterTest, HowTheOtherScanIsReadIsAskedWhereItIsInDoubt) {
  begin();
  const PointCloud south = readPoints(toPath(south_)).value;
  std::ofstream text(path("south.txt").toStdString());
  text << "height north east\n";
  for (Eigen::Index i = 0; i < south.size(); ++i) {
    const Vector3d place = south.position(i);
    text << place.z() << ' ' << place.y() << ' ' << place.x() << '\n';
  }
  text.close();
  answer(chooseFile(path("south.txt")), [this] { action("register_scan").trigger(); });
  answer(
      [](QDialog& page) {
        EXPECT_EQ(page.objectName(), "open_scan");
        EXPECT_FALSE(page.findChild<QComboBox*>("scan_unit")->isEnabled()) << "as the open scan";
        EXPECT_EQ(page.findChild<QComboBox*>("scan_unit")->currentText(), "m");
        const auto choose = [&](const char* column, const char* field) {
          auto& list = *page.findChild<QComboBox*>(column);
          list.setCurrentIndex(list.findText(field));
        };
        choose("column_1", "z");
        choose("column_2", "y");
        choose("column_3", "x");
        press("Open")(page);
      },
      [this] { waitForJob(); });
  waitForJob();
  waitForView();
  ASSERT_TRUE(action("fit_scan").isEnabled()) << message().toStdString();
  fit();
  join("both.ply");
  EXPECT_LT(farthestOff(), 0.02);
}

TEST_F(RegisterTest, ThePageOfTheOtherScanCanBeLeft) {
  open({north_});
  std::ofstream(path("south.txt").toStdString()) << "height north east\n1 2 3\n";
  answer(chooseFile(path("south.txt")), [this] { action("register_scan").trigger(); });
  answer([](QDialog& page) { page.reject(); }, [this] { waitForJob(); });
  EXPECT_FALSE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().scanPath(), north_);
}

TEST_F(RegisterTest, AStructureMovesWithItsScan) {
  begin();
  fit();
  writeFork("fork.mtg");
  int dialogs = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    chooseFile(path(dialogs++ == 0 ? "fork.mtg" : "moved.mtg"))(*dialog);
  });
  timer.start(0);
  action("move_structure").trigger();
  timer.stop();
  EXPECT_EQ(dialogs, 2);
  waitForJob();
  clickButton("banner_action");
  ASSERT_FALSE(document().skeleton().isEmpty());
  EXPECT_EQ(document().undoStack().count(), 1);
  const Vector3d before = bounds(readAnyStructure(toPath(path("fork.mtg"))).value.skeleton).max();
  const Vector3d after = bounds(readAnyStructure(toPath(path("moved.mtg"))).value.skeleton).max();
  EXPECT_LT((after - before - Vector3d(0.06, -0.05, 0.04)).norm(), 0.2);
  EXPECT_GT((after - before).norm(), 0.02);
}

} // namespace
} // namespace espalier
