#include "ui/panels/message_banner.h"

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

TEST_F(MessageBannerTest, StaysOnAPageThatShrinks) {
  static_cast<void>(place());
  page.resize(420, 300);
  page.show();
  EXPECT_TRUE(page.rect().contains(banner.geometry()));
}

} // namespace
} // namespace espalier
