#include "ui/panels/start_page.h"

#include <QApplication>
#include <QPushButton>
#include <gtest/gtest.h>

namespace espalier {
namespace {

struct StartPageTest : testing::Test {
  StartPage page;

  StartPageTest() {
    QStringList files, works;
    for (int i = 0; i < 6; ++i)
      files.append(QStringLiteral("/plants/tree%1.ply").arg(i));
    for (int i = 0; i < 4; ++i)
      works.append(QStringLiteral("/sessions/%1.espalier").arg(i));
    page.setRecentFiles(files);
    page.setSessions({"oak, 3 edits", "ash, 1 edit", "fir, 2 edits", "yew, 5 edits"}, works);
  }
};

// Panels below it may take most of a small screen.
TEST_F(StartPageTest, ScrollsWhereThereIsNotRoomForAll) {
  EXPECT_LT(page.minimumSizeHint().height(), 200);
  page.resize(800, 250);
  page.show();
  QApplication::processEvents();
  EXPECT_GT(page.widget()->height(), 250);
  for (const QPushButton* button : page.findChildren<QPushButton*>())
    EXPECT_GE(button->height(), button->sizeHint().height()) << button->text().toStdString();
}

TEST_F(StartPageTest, SaysWhatIsCoveredOfIt) {
  page.resize(800, 900);
  EXPECT_EQ(page.covered(page.rect()), 0) << "it is hidden";
  page.show();
  QApplication::processEvents();
  EXPECT_GT(page.covered(page.rect()), 1000);
  EXPECT_EQ(page.covered(QRect(0, 0, 40, 40)), 0);
}

} // namespace
} // namespace espalier
