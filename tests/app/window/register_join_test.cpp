// Two scans of a plant are joined, and a structure moves with one of them, in the real window.
#include "core/skeleton/bounds.h"
#include "tests/app/window/register_fixture.h"
#include "ui/jobs/job_slot.h"

#include <QAction>
#include <QApplication>
#include <QMessageBox>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

struct RegisterJoinTest : test::RegistrationTest {};

TEST_F(RegisterJoinTest, TheJoinedScanIsOneStepThatIsUndoneAndRedone) {
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

TEST_F(RegisterJoinTest, AProjectOpensTheJoinedScanWithAllItsSteps) {
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

TEST_F(RegisterJoinTest, AJoinThatWasUndoneForAnotherStepStaysSetAside) {
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

TEST_F(RegisterJoinTest, ContractedPointsOfAllStepsGrowWithTheScan) {
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

TEST_F(RegisterJoinTest, AJoinThatIsCanceledLeavesEachFileAsItWas) {
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

TEST_F(RegisterJoinTest, TheOpenPartOfAScanIsJoined) {
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

TEST_F(RegisterJoinTest, AStructureMovesWithItsScan) {
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
