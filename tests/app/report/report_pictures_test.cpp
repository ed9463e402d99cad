#include "app/report/comparison_colors.h"
#include "app/report/report_pictures.h"
#include "tests/app/report/reported_plants.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

/// How many pixels are near a color.
int pixelsOf(const QImage& image, const QColor& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int apart = std::abs(pixel.red() - color.red()) +
                        std::abs(pixel.green() - color.green()) +
                        std::abs(pixel.blue() - color.blue());
      count += apart < 60 ? 1 : 0;
    }
  return count;
}

class Pictures : public testing::Test {
protected:
  void draw(const Skeleton& result, const Skeleton& reference) {
    data_ = test::reported(result, reference, 0.02);
    pictures_ = reportPictures(data_, UpAxis::z, "m");
    if (!pictures_.problem.isEmpty()) GTEST_SKIP() << qPrintable(pictures_.problem);
  }
  const QColor missed_{0x1b, 0x87, 0xd0};
  const QColor invented_{0xd5, 0x5e, 0x00};
  ReportData data_;
  ReportPictures pictures_;
};

TEST_F(Pictures, ShowWhatIsMissedInItsColor) {
  draw(test::stick(21, 0.1), test::branched());
  EXPECT_GT(pixelsOf(pictures_.front, missed_), 300);
  EXPECT_EQ(pixelsOf(pictures_.front, invented_), 0);
  ASSERT_EQ(pictures_.errors.size(), 1U);
  EXPECT_GT(pixelsOf(pictures_.errors.front(), missed_), 300);
}

TEST_F(Pictures, ShowWhatIsInventedInItsColor) {
  draw(test::branched(), test::stick(21, 0.1));
  EXPECT_GT(pixelsOf(pictures_.front, invented_), 300);
  EXPECT_EQ(pixelsOf(pictures_.front, missed_), 0);
}

TEST_F(Pictures, AreDrawnOneByOne) {
  draw(test::stick(21, 0.1), test::branched());
  PictureSession session(data_);
  EXPECT_EQ(session.done(), 0);
  int drawn = 1;
  while (session.drawNext())
    ++drawn;
  EXPECT_EQ(drawn, 5); // from two sides, each alone, one error
  EXPECT_EQ(session.done(), 1);
  EXPECT_FALSE(session.drawNext());
  EXPECT_TRUE(session.pictures().scan.isNull()) << "there is no scan";
}

TEST(ComparisonColors, SayWithWhatIsCompared) {
  EXPECT_EQ(comparisonColors({}).legend.title, "Compared with the reference");
  EXPECT_EQ(comparisonColors({}, "A").legend.title, "Compared with A");
}

TEST_F(Pictures, AreTheSameEachTime) {
  draw(test::stick(21, 0.1), test::branched());
  const ReportPictures again = reportPictures(data_, UpAxis::z, "m");
  EXPECT_EQ(again.front, pictures_.front);
  EXPECT_EQ(again.errors, pictures_.errors);
}

} // namespace
} // namespace espalier
