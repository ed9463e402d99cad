// The tour of three hints.
#include "tests/app/window/window_fixture.h"
#include "ui/panels/message_banner.h"
#include "ui/panels/tour_hint.h"

#include <QAction>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTest>

#include <cstdlib>

namespace espalier {
namespace {

class TourTest : public test::WindowTest {
protected:
  /// As for one who starts the program for the first time.
  void forget() {
    QSettings(path("settings.ini"), QSettings::IniFormat).remove("tour/was_shown");
    restart();
  }
  TourHint& hint() { return find<TourHint>("tour_hint"); }
};

TEST_F(TourTest, IsShownWithTheFirstScanAndNeverAgainUnasked) {
  forget();
  EXPECT_FALSE(hint().isVisible());
  open({writeScan("first.xyz")});
  EXPECT_TRUE(hint().isVisible());
  EXPECT_TRUE(hint().text().contains("Ctrl+R")) << hint().text().toStdString();
  QTest::qWait(50);
  const auto& button = find<QPushButton>("reconstruct_button");
  const QPoint place = button.mapTo(&window(), button.rect().center());
  EXPECT_GT(hint().geometry().left(), place.x());
  EXPECT_LT(std::abs(hint().geometry().center().y() - place.y()), hint().height()) << "beside it";
  restart();
  open({path("first.xyz")});
  EXPECT_FALSE(hint().isVisible());
  action("tour").trigger();
  EXPECT_TRUE(hint().isVisible());
}

TEST_F(TourTest, GoesOnWithWhatOneDoesAndEnds) {
  open({writeScan("scan.xyz")});
  action("tour").trigger();
  action("reconstruct").trigger();
  waitForJob();
  EXPECT_TRUE(hint().text().contains("F2")) << hint().text().toStdString();
  action("next_finding").trigger();
  EXPECT_TRUE(hint().text().contains("F9")) << hint().text().toStdString();
  action("show_review").trigger();
  EXPECT_FALSE(hint().isVisible());
}

TEST_F(TourTest, BeginsAgainWithAnotherPlant) {
  open({writeScan("scan.xyz")});
  action("tour").trigger();
  action("reconstruct").trigger();
  waitForJob();
  ASSERT_TRUE(hint().text().contains("F2")) << hint().text().toStdString();
  open({writeScan("other.xyz")});
  EXPECT_TRUE(hint().isVisible());
  EXPECT_TRUE(hint().text().contains("Ctrl+R")) << hint().text().toStdString();
}

TEST_F(TourTest, GoesOnByItsButtonAndIsLeftByEscape) {
  open({writeScan("scan.xyz")});
  action("tour").trigger();
  QTest::qWait(50);
  EXPECT_LE(hint().geometry().bottom(), window().statusBar()->geometry().top())
      << "the status line says what the mouse does";
  clickButton("tour_next");
  EXPECT_TRUE(hint().text().contains("F2"));
  clickButton("tour_next");
  clickButton("tour_next");
  EXPECT_FALSE(hint().isVisible()) << "after the third";
  action("tour").trigger();
  key(Qt::Key_Escape);
  EXPECT_FALSE(hint().isVisible());
}

TEST_F(TourTest, StaysOverTheViewWhereWhatItMeansIsNotShown) {
  open({writeScan("scan.xyz")});
  action("tour").trigger();
  action("reconstruct").trigger();
  waitForJob();
  action("show_inspector").trigger();
  ASSERT_FALSE(find<QWidget>("inspector").isVisible());
  const auto isOverView = [this] {
    return window().centralWidget()->geometry().contains(hint().geometry());
  };
  EXPECT_TRUE(QTest::qWaitFor(isOverView, patience));
  action("show_node_table").trigger(); // below the view, which it makes lower
  QTest::qWait(50);
  EXPECT_TRUE(hint().isVisible());
  EXPECT_TRUE(QTest::qWaitFor(isOverView, patience));
}

TEST_F(TourTest, LeavesMessagesInSight) {
  open({writeScan("scan.xyz")});
  action("tour").trigger();
  QTest::qWait(50);
  find<MessageBanner>("message_banner").showError("no plant is here: open another");
  const auto placeOf = [](const QWidget& widget) {
    return QRect(widget.mapToGlobal(QPoint()), widget.size());
  };
  ASSERT_TRUE(hint().isVisible() && window().banner().isVisible());
  EXPECT_FALSE(placeOf(window().banner()).intersects(placeOf(hint())));
}

TEST_F(TourTest, TakesTheSamplePlantWhereNoneIsOpen) {
  action("tour").trigger();
  ASSERT_TRUE(QTest::qWaitFor([this] { return hint().isVisible(); }, patience));
  EXPECT_NE(document().scan(), nullptr);
  EXPECT_TRUE(window().rect().contains(hint().geometry()));
}

} // namespace
} // namespace espalier
