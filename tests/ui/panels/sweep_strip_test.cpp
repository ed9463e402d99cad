#include "ui/panels/sweep_strip.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

QImage gray() {
  QImage image(40, 20, QImage::Format_RGB32);
  image.fill(QColor(90, 90, 90));
  return image;
}

/// Six values, in a strip that shows two of them; the third is set.
class ShownStrip : public testing::Test {
protected:
  ShownStrip() {
    for (int i = 0; i < 6; ++i)
      items_.push_back({.of = "Contract: Radius",
                        .label = QString("%1 mm").arg(10 * i),
                        .picture = gray(),
                        .scores = {{"Lost tips", QString::number(i), i == 0}, {"Length", "4 m"}},
                        .failure = {},
                        .isCurrent = i == 2});
    strip_.setItems(items_);
    strip_.resize(400, 300);
    strip_.show();
    strip_.activateWindow();
  }

  std::vector<SweepItem> items_;
  SweepStrip strip_;
  QSignalSpy chosen_{&strip_, &SweepStrip::chosen};
};

TEST_F(ShownStrip, IsChosenFromByAClickAndByEnter) {
  QTest::mouseClick(strip_.cards()[1], Qt::LeftButton);
  QTest::keyClick(strip_.cards()[4], Qt::Key_Return);
  ASSERT_EQ(chosen_.size(), 2);
  EXPECT_EQ(chosen_[0][0].value<std::size_t>(), 1U);
  EXPECT_EQ(chosen_[1][0].value<std::size_t>(), 4U);
}

TEST_F(ShownStrip, OffersNothingThatIsNotThere) {
  items_[0].isPending = true;
  items_[1].failure = "No point is left";
  strip_.setItems(items_);
  QTest::mouseClick(strip_.cards()[0], Qt::LeftButton);
  QTest::mouseClick(strip_.cards()[1], Qt::LeftButton);
  EXPECT_EQ(chosen_.size(), 0);
  EXPECT_TRUE(strip_.cards()[1]->toolTip().contains("No point is left"));
  items_[0].isPending = false;
  strip_.setItem(0, items_[0]);
  QTest::mouseClick(strip_.cards()[0], Qt::LeftButton);
  EXPECT_EQ(chosen_.size(), 1) << "once it has come";
}

TEST_F(ShownStrip, IsWalkedByTheArrowKeysAndScrollsAlong) {
  strip_.cards()[0]->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return strip_.cards()[0]->hasFocus(); }));
  QTest::keyClick(strip_.cards()[0], Qt::Key_Left);
  EXPECT_TRUE(strip_.cards()[0]->hasFocus()) << "there is none before it";
  QTest::keyClick(strip_.cards()[0], Qt::Key_Right);
  EXPECT_TRUE(strip_.cards()[1]->hasFocus());
  const QScrollBar* bar = strip_.findChild<QScrollArea*>()->horizontalScrollBar();
  EXPECT_GT(bar->maximum(), 0);
  QTest::keyClick(strip_.cards()[1], Qt::Key_End);
  EXPECT_TRUE(strip_.cards()[5]->hasFocus());
  EXPECT_GT(bar->value(), bar->maximum() / 2);
  QTest::keyClick(strip_.cards()[5], Qt::Key_Home);
  EXPECT_TRUE(strip_.cards()[0]->hasFocus());
}

TEST_F(ShownStrip, ReportsWhichCardIsUnderThePointer) {
  std::vector<std::optional<std::size_t>> seen;
  QObject::connect(&strip_, &SweepStrip::hovered,
                   [&](std::optional<std::size_t> index) { seen.push_back(index); });
  QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
  QCoreApplication::sendEvent(strip_.cards()[1], &enter);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(strip_.cards()[1], &leave);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0], 1U);
  EXPECT_FALSE(seen[1]);
}

TEST_F(ShownStrip, NamesValueAndScoresToThoseWhoDoNotSeeIt) {
  EXPECT_EQ(strip_.cards()[0]->accessibleName(), "0 mm; Lost tips 0, best; Length 4 m");
  EXPECT_EQ(strip_.cards()[2]->accessibleName(), "20 mm; set; Lost tips 2; Length 4 m");
}

TEST_F(ShownStrip, ShowsAllScoresIfItHasTheHeightAndGivesTheRestToPictures) {
  const int before = strip_.heightForScores();
  items_[3].scores.push_back({"Webbed", "0", false});
  strip_.setItem(3, items_[3]);
  EXPECT_GT(strip_.heightForScores(), before);
  strip_.resize(strip_.width(), strip_.heightForScores());
  QCoreApplication::processEvents();
  const int lowest = strip_.cards()[0]->height();
  for (const SweepCard* card : strip_.cards())
    EXPECT_GE(card->height(), card->minimumSizeHint().height());
  EXPECT_EQ(strip_.cards()[0]->visibleRegion().boundingRect().height(), lowest) << "nothing is cut";
  strip_.resize(strip_.width(), strip_.height() + 50);
  QCoreApplication::processEvents();
  for (const SweepCard* card : strip_.cards())
    EXPECT_EQ(card->height(), lowest + 50);
}

TEST_F(ShownStrip, GrowsAndShrinksWithItsItems) {
  items_.resize(2);
  strip_.setItems(items_);
  EXPECT_EQ(strip_.cards().size(), 2U);
  items_.push_back(items_[0]);
  strip_.setItems(items_);
  QTest::mouseClick(strip_.cards()[2], Qt::LeftButton);
  EXPECT_EQ(chosen_.last()[0].value<std::size_t>(), 2U);
  strip_.setItems({});
  EXPECT_TRUE(strip_.cards().empty());
}

TEST_F(ShownStrip, ShowsThePictureUndistorted) {
  const QImage image = strip_.cards()[0]->grab().toImage();
  EXPECT_EQ(image.pixelColor(88, 88), QColor(90, 90, 90)); // in the middle
  EXPECT_NE(image.pixelColor(88, 40), QColor(90, 90, 90)) << "half as high as wide";
}

} // namespace
} // namespace espalier
