#include "ui/view/stereo.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(Stereo, HasAnEyeOnEitherSideOfTheCamera) {
  const Camera camera{.focus = {1, 2, 3}, .distance = 6};
  const auto [left, right] = eyesOf(camera);
  EXPECT_LT(left.aside, 0);
  EXPECT_EQ(right.aside, -left.aside);
  Camera between = left;
  between.aside = 0;
  EXPECT_EQ(between, camera);
}

TEST(Stereo, TakesRedOfTheLeftAndTheRestOfTheRight) {
  QImage left(2, 1, QImage::Format_RGB32);
  left.setPixelColor(0, 0, QColor(10, 20, 30));
  left.setPixelColor(1, 0, QColor(255, 255, 255));
  QImage right(2, 1, QImage::Format_RGB32);
  right.setPixelColor(0, 0, QColor(40, 50, 60));
  right.setPixelColor(1, 0, QColor(0, 0, 0));
  const QImage both = redCyan(left, right);
  EXPECT_EQ(both.pixelColor(0, 0), QColor(10, 50, 60));
  EXPECT_EQ(both.pixelColor(1, 0), QColor(255, 0, 0));
}

} // namespace
} // namespace espalier
