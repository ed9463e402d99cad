#include "ui/panels/message_banner.h"

#include <QCoreApplication>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Over a page on which a plant may stand in some parts.
struct MessageBannerTest : testing::Test {
  QWidget page;
  MessageBanner banner{&page};
  std::vector<QRect> plant;

  void SetUp() override {
    page.resize(1000, 600);
    banner.setCover([this](const QRect& part) {
      int covered = 0;
      for (const QRect& each : plant) {
        const QRect both = each & part;
        covered += both.width() * both.height();
      }
      return covered;
    });
  }
  [[nodiscard]] const QRect& place() {
    banner.showResult("Reconstructed: 1 204 nodes in 2.1 s", "Undo", [] {});
    return banner.geometry();
  }
};

TEST_F(MessageBannerTest, BeginsASentenceLargeAndLeavesNamesOfFiles) {
  banner.showError("nothing grows from these points: choose others");
  EXPECT_EQ(banner.text(), "Nothing grows from these points: choose others");
  for (const char* text : {"oak.xyz, line 12: expected 3 numbers", "oak, line 12: no number"}) {
    banner.showError(text);
    EXPECT_EQ(banner.text(), text);
  }
}

TEST_F(MessageBannerTest, LiesInTheMiddleOfTheFoot) {
  EXPECT_NEAR(place().center().x(), 500, 1);
  EXPECT_GT(place().top(), 500);
  EXPECT_TRUE(page.rect().contains(place()));
}

TEST_F(MessageBannerTest, LeavesTheFootOfThePlantFree) {
  plant = {{480, 100, 40, 500}}; // a trunk
  EXPECT_FALSE(place().intersects(plant.front()));
  EXPECT_GT(place().top(), 480) << "beside the trunk";
  EXPECT_LT(place().right(), 480);
}

TEST_F(MessageBannerTest, LiesAboveAPlantThatIsWideAtItsFoot) {
  plant = {{0, 300, 1000, 300}};
  EXPECT_LT(place().bottom(), 300);
  EXPECT_GE(place().top(), 0);
}

TEST_F(MessageBannerTest, CoversAsLittleAsItCanOfAPlantThatIsEverywhere) {
  plant = {page.rect(), {0, 0, 1000, 100}, {0, 500, 400, 100}, {480, 500, 520, 100}};
  EXPECT_TRUE(page.rect().contains(place()));
  EXPECT_GT(place().top(), 400) << "its top is the denser one";
}

TEST_F(MessageBannerTest, LiesBesideThePlantAtTheRightIfThereIsNoRoomAtTheLeft) {
  plant = {{480, 100, 40, 500}, {0, 100, 480, 500}, {400, 0, 200, 100}};
  EXPECT_GT(place().left(), 520);
  EXPECT_LT(place().bottom(), 600 - 80) << "above the axes of the view";
}

TEST_F(MessageBannerTest, KeepsItsTextInOneLineWhereThereIsRoom) {
  const QString text = "Work on this plant was kept: scan in puu1, 2 edits, today 22:43";
  const auto* label = banner.findChild<QLabel*>();
  const auto show = [&] {
    banner.showOffer(text, {{"Continue", [] {}}, {"Discard", [] {}}});
    return banner.geometry();
  };
  const int line = label->fontMetrics().height();
  const QRect wide = show();
  EXPECT_LT(label->height(), 2 * line);
  plant = {{480, 100, 40, 500}, {0, 0, 1000, 100}}; // a trunk in the way of a long line
  const QRect narrow = show();
  EXPECT_LT(narrow.width(), wide.width());
  EXPECT_GT(narrow.height(), wide.height()) << "the buttons are below";
  EXPECT_FALSE(narrow.intersects(plant.front()));
  page.show();
  QCoreApplication::processEvents();
  EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(text));
  EXPECT_LT(label->height(), 2 * line);
}

TEST_F(MessageBannerTest, CutsNoButtonWhereItIsNarrow) {
  plant = {{320, 0, 680, 600}, {0, 0, 1000, 480}};
  banner.showOffer("Signed by Anna on 26 Nov 2026, 13:55. Only a project keeps the seal",
                   {{"Save Project As…", [] {}}, {"Export Certificate…", [] {}}});
  QCoreApplication::processEvents();
  banner.layout()->activate();
  for (const auto* button : banner.findChildren<QPushButton*>())
    EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
}

TEST_F(MessageBannerTest, StaysOnAPageThatShrinks) {
  static_cast<void>(place());
  page.resize(420, 300);
  page.show();
  EXPECT_TRUE(page.rect().contains(banner.geometry()));
}

} // namespace
} // namespace espalier
