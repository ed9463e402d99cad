#include "ui/view/ghost_overlay.h"
#include "ui/view/palette.h"

#include <QImage>
#include <QLineF>
#include <QPainter>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace espalier {
namespace {

constexpr int width = 400;
constexpr int height = 300;

/// A pixel a length, from the front.
ScreenMap screenMap() {
  Camera camera{.projection = Projection::parallel};
  camera.distance = height / 2.0 / std::tan(Camera::fieldOfView / 2);
  return {camera, {width, height}};
}

ShownGhost ghost(int number, std::vector<Eigen::Vector3d> line,
                 ShownGhost::Look look = ShownGhost::Look::proposed) {
  return {.lines = {std::move(line)}, .look = look, .number = number};
}

/// Pixels that have the color of a ghost, outside the numbers.
int pixelsOf(int number, const std::vector<ShownGhost>& ghosts) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::black);
  QPainter painter(&image);
  paintGhosts(painter, ghosts, screenMap(), false);
  painter.setBrush(Qt::black);
  painter.setPen(Qt::black);
  for (const GhostNumber& each : numbersOf(ghosts, screenMap()))
    painter.drawEllipse(each.at, GhostNumber::radius + 1, GhostNumber::radius + 1);
  painter.end();
  const Color color = colorOfGhost(number, false);
  int pixels = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels += image.pixel(x, y) == qRgb(color[0], color[1], color[2]) ? 1 : 0;
  return pixels;
}

// A number that stood on it would cover it whole.
TEST(GhostOverlay, NumbersLeaveAShortLineFree) {
  const std::vector<ShownGhost> ghosts = {
      ghost(1, {{0, 0, 0}, {12, 0, 0}}, ShownGhost::Look::present),
      ghost(2, {{0, 0, 0}, {0, 0, 60}}), ghost(3, {{0, 0, 0}, {60, 0, 60}})};
  const std::vector<GhostNumber> numbers = numbersOf(ghosts, screenMap());
  ASSERT_EQ(numbers.size(), 3U);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(numbers[i].number, int(i) + 1);
    EXPECT_LT(QLineF(numbers[i].at, numbers[i].of).length(), 50) << "beside what it names";
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(QLineF(numbers[i].at, numbers[j].at).length(), 2 * GhostNumber::radius);
  }
  EXPECT_GT(pixelsOf(1, ghosts), 4 * 9);
}

TEST(GhostOverlay, ShortLinesLieOverLongOnes) {
  const ShownGhost small = ghost(1, {{0, 0, 0}, {12, 0, 0}}, ShownGhost::Look::present);
  const ShownGhost large = ghost(2, {{-60, 0, 0}, {60, 0, 0}}, ShownGhost::Look::present);
  EXPECT_GT(pixelsOf(1, {small, large}), 4 * 9);
}

// The wood comes to its cross from the right, where a number would else stand.
TEST(GhostOverlay, NumbersLeaveACrossFree) {
  const std::vector<ShownGhost> ghosts = {
      ghost(1, {{80, 0, 0}, {0, 0, 0}}, ShownGhost::Look::present),
      ghost(2, {{80, 0, 0}, {0, 0, 0}}, ShownGhost::Look::removed)};
  const GhostNumber number = numbersOf(ghosts, screenMap()).at(1);
  for (const double x : {-9.0, 9.0})
    for (const double y : {-9.0, 9.0})
      EXPECT_GT(QLineF(number.at, number.of + QPointF(x, y)).length(), GhostNumber::radius + 2);
}

TEST(GhostOverlay, NumbersStayOnTheScreen) {
  for (const double x : {-198.0, 198.0}) {
    const std::vector<ShownGhost> ghosts = {
        ghost(1, {{x, 0, 140}, {x, 0, 148}}), ghost(2, {{x, 0, 148}}, ShownGhost::Look::present),
        ghost(3, {{x, 0, 130}, {x, 0, 140}}, ShownGhost::Look::removed)};
    const std::vector<GhostNumber> numbers = numbersOf(ghosts, screenMap());
    ASSERT_EQ(numbers.size(), 2U) << "a dot has none";
    for (const GhostNumber& number : numbers)
      EXPECT_TRUE(QRectF(0, 0, width, height).contains(number.at));
    EXPECT_NEAR(numbers[1].of.y(), 10, 1) << "the cross is where it ends";
  }
}

// What is asked about is selected, and its points are lit in the same color.
TEST(GhostOverlay, NoAnswerHasTheColorOfWhatIsSelected) {
  for (const bool dark : {false, true})
    for (int number = 1; number <= 4; ++number) {
      EXPECT_NE(colorOfGhost(number, dark), palette(dark).selected);
      for (int other = 1; other < number; ++other)
        EXPECT_NE(colorOfGhost(number, dark), colorOfGhost(other, dark));
    }
}

} // namespace
} // namespace espalier
