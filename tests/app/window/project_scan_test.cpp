#include "core/base/error.h"
#include "tests/app/window/project_fixture.h"

#include <QFile>

namespace espalier {
namespace {

using test::ProjectWindowTest;

TEST_F(ProjectWindowTest, FindsAScanThatMovedWithTheProject) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  window().close();
  QDir().mkpath(path("moved"));
  QFile::rename(path("plant.xyz"), path("moved/plant.xyz"));
  QFile::rename(path("plant.espalier"), path("moved/plant.espalier"));
  restart();
  open({path("moved/plant.espalier")});
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_FALSE(window().banner().isVisible());
}

TEST_F(ProjectWindowTest, AsksForAScanThatIsGone) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  window().close();
  QDir().mkpath(path("elsewhere"));
  QFile::rename(path("plant.xyz"), path("elsewhere/plant.xyz"));
  restart();
  open({path("plant.espalier")});
  EXPECT_EQ(document().scan(), nullptr);
  EXPECT_EQ(document().skeleton().size(), 5U) << "the plant is there all the same";
  EXPECT_TRUE(message().contains("plant.xyz is not where it was"));
  answer(chooseFile(path("elsewhere/plant.xyz")), [this] { clickButton("banner_action"); });
  waitForJob();
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().skeleton().size(), 5U);
}

TEST_F(ProjectWindowTest, RefusesAnotherScanForTheOneThatIsGone) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  window().close();
  QFile::remove(path("plant.xyz"));
  QFile other(path("other.txt"));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  other.write("0 0 0\n1 1 1\n");
  other.close();
  restart();
  open({path("plant.espalier")});
  answer(chooseFile(path("other.txt")), [this] { clickButton("banner_action"); });
  waitForJob();
  EXPECT_TRUE(message().contains("is not the scan of this project"));
  EXPECT_EQ(document().scan(), nullptr);
}

TEST_F(ProjectWindowTest, KeepsTheScanInTheProject) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  EXPECT_FALSE(action("keep_scan").isEnabled()) << "there is no project yet";
  const QString file = saveProject("plant.espalier");
  const Eigen::Matrix3Xf points = document().scan()->cloud()->positions();
  action("keep_scan").trigger();
  EXPECT_FALSE(action("keep_scan").isChecked()) << "not before it is there";
  waitForJob();
  EXPECT_TRUE(action("keep_scan").isChecked());
  EXPECT_EQ(message(), "plant.espalier holds the scan now");
  window().close();
  QFile::remove(path("plant.xyz"));
  restart();
  open({file});
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().scan()->cloud()->positions(), points);
  EXPECT_FALSE(window().banner().isError());
  EXPECT_TRUE(action("keep_scan").isChecked());
  action("keep_scan").trigger();
  waitForJob();
  EXPECT_TRUE(message().contains("only copy")) << message().toStdString();
  EXPECT_TRUE(action("keep_scan").isChecked());
}

TEST_F(ProjectWindowTest, TakesTheScanOutOfTheProjectWhileItsFileIsThere) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  action("keep_scan").trigger();
  waitForJob();
  action("keep_scan").trigger();
  waitForJob();
  EXPECT_FALSE(action("keep_scan").isChecked());
  window().close();
  EXPECT_FALSE(Project::open(toPath(file), Access::readOnly).hasBytes("cloud"));
}

TEST_F(ProjectWindowTest, LeavesTheProjectAsItWasWhenKeepingTheScanIsCanceled) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  const QString file = saveProject("plant.espalier");
  action("keep_scan").trigger();
  window().jobs().cancel();
  waitForJob();
  EXPECT_FALSE(action("keep_scan").isChecked());
  EXPECT_FALSE(Project::open(toPath(file), Access::readOnly).hasBytes("cloud"));
}

TEST_F(ProjectWindowTest, KeepsTheScanInAProjectSavedUnderAnotherName) {
  open({writeScan("plant.xyz"), writeFork("fork.mtg")});
  saveProject("plant.espalier");
  action("keep_scan").trigger();
  waitForJob();
  const QString other = saveProject("other.espalier");
  window().close();
  EXPECT_TRUE(Project::open(toPath(other), Access::readOnly).hasBytes("cloud"));
}

} // namespace
} // namespace espalier
