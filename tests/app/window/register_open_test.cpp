// Another scan of the plant is opened, or another plant while one is registered, in the real
// window.
#include "tests/app/window/register_fixture.h"

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QTest>

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

struct RegisterOpenTest : test::RegistrationTest {};

TEST_F(RegisterOpenTest, AnotherScanIsOfferedToBeRegistered) {
  open({north_});
  answer(press("Cancel"), [this] { window().open({south_}); });
  EXPECT_FALSE(window().jobs().isBusy());
  answer(press("Register"), [this] { window().open({south_}); });
  waitForJob();
  EXPECT_TRUE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().scanPath(), north_);
  answer(
      [](QDialog& dialog) {
        EXPECT_THAT(dynamic_cast<QMessageBox&>(dialog).text().toStdString(),
                    HasSubstr("Open south.ply in place of north.xyz?"));
        QTest::keyClick(&dialog, Qt::Key_Return);
      },
      [this] { window().open({south_}); });
  waitForJob();
  EXPECT_FALSE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().scanPath(), south_) << "Enter opens it";
}

TEST_F(RegisterOpenTest, TheOpenScanIsReadAgainWithoutAQuestion) {
  open({north_});
  expectNoDialog([this] {
    window().open({north_});
    waitForJob();
  });
  EXPECT_EQ(document().scanPath(), north_);
  EXPECT_FALSE(action("fit_scan").isEnabled());
}

TEST_F(RegisterOpenTest, WhatTakesThePlantAwayAsksForTheTargetsFirst) {
  const QString other = writeScan("other.xyz");
  open({other});
  const QString project = saveProject("other.espalier");
  begin();
  pickPair(0);
  const auto openOther = [&](const QString& answered) {
    answer(press("Open"), [&] { window().open({other}); });
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

TEST_F(RegisterOpenTest, AWindowThatStaysOpenKeepsItsProject) {
  open({north_});
  const QString file = saveProject("plant.espalier");
  beginAgain();
  pickPair(0);
  answer(press("Go On"), [this] { window().close(); });
  document().leaveOut("Set points aside", PointSet::of({1}));
  EXPECT_EQ(onDisk(file).steps.size(), 1U);
}

TEST_F(RegisterOpenTest, AStructureIsOpenedWhileItGoesOn) {
  begin();
  pickPair(0);
  const QString fork = writeFork("fork.mtg");
  expectNoDialog([&] { open({fork}); });
  EXPECT_FALSE(document().skeleton().isEmpty());
  EXPECT_EQ(pairs().rowCount(), 1);
}

TEST_F(RegisterOpenTest, AScanThatIsDroppedOnAnotherIsOfferedToBeRegistered) {
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

TEST_F(RegisterOpenTest, TwoScansAreOpenedOneToBeRegisteredToTheOther) {
  answer(press("Register"), [this] { window().open({north_, south_}); });
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("fit_scan").isEnabled(); }, patience));
  EXPECT_EQ(document().scanPath(), north_);
}

TEST_F(RegisterOpenTest, OfTwoScansTheFirstIsOpenedAlone) {
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

TEST_F(RegisterOpenTest, HowTheOtherScanIsReadIsAskedWhereItIsInDoubt) {
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

TEST_F(RegisterOpenTest, ThePageOfTheOtherScanCanBeLeft) {
  open({north_});
  std::ofstream(path("south.txt").toStdString()) << "height north east\n1 2 3\n";
  answer(chooseFile(path("south.txt")), [this] { action("register_scan").trigger(); });
  answer([](QDialog& page) { page.reject(); }, [this] { waitForJob(); });
  EXPECT_FALSE(action("fit_scan").isEnabled());
  EXPECT_EQ(document().scanPath(), north_);
}

} // namespace
} // namespace espalier
