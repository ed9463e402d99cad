#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/attachment_overlay.h"
#include "ui/view/legend.h"
#include "ui/view/overlay.h"
#include "ui/view/overlay_of_tools.h"
#include "ui/view/palette.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

#include <cstdlib>

namespace espalier {
namespace {

/// What is left of a red ground at a corner of the box of a color bar, clear of its text.
QColor groundUnderBar(const QSize& size) {
  Legend legend;
  legend.title = "Height";
  legend.to = 1;
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::red);
  QPainter painter(&image);
  const QRectF veil =
      legendBoxes({legend}, size, QFontMetricsF(painter.font(), painter.device()), Corner::topRight)
          .front()
          .veil;
  paintLegends(painter, {legend}, size, Corner::topRight, false);
  return image.pixelColor(veil.bottomLeft().toPoint() + QPoint(8, -3));
}

TEST(Legends, VeilThePlantOnlyWhereThereIsRoomBesideIt) {
  EXPECT_NE(groundUnderBar({800, 600}), QColor(Qt::red));
  EXPECT_EQ(groundUnderBar({400, 600}), QColor(Qt::red));
}

/// How far a color on a ground of points in the accent stands out from it, in [0, 3 * 255].
int contrastWith(const Color& accent, const QColor& color) {
  return std::abs(color.red() - accent[0]) + std::abs(color.green() - accent[1]) +
         std::abs(color.blue() - accent[2]);
}

TEST(Attachments, MarkWhereAPartIsAttachedAndThePathToWhereItBelongs) {
  constexpr Color purple{0xcc, 0x79, 0xa7};
  for (const bool isDark : {false, true}) {
    const Palette colors = palette(isDark);
    QImage image(200, 200, QImage::Format_RGB32);
    image.fill(qRgb(purple[0], purple[1], purple[2])); // on a plant of its own color
    QPainter painter(&image);
    Camera camera;
    camera.frame(Eigen::AlignedBox3d(Eigen::Vector3d(-1, 0, -1), Eigen::Vector3d(1, 0, 1)), 1);
    const ScreenMap screen(camera, {200, 200});
    const ShownAttachment shown{.wrong = {{0, 0, 0}, {0.5, 0, 0.5}},
                                .right = {{0, 0, 0}, {-0.5, 0, -0.5}},
                                .color = purple,
                                .wrongLabel = "wrong here",
                                .rightLabel = "belongs here"};
    paintAttachment(painter, shown, screen, isDark);
    const auto rimsAbout = [&](const Eigen::Vector3d& place) {
      const auto at = screen.project(place);
      int count = 0;
      for (int y = -11; y <= 11; ++y)
        for (int x = -11; x <= 11; ++x) {
          const QColor color =
              image.pixelColor(QPointF(at->pixel.x() + x, at->pixel.y() + y).toPoint());
          if (contrastWith(colors.text, color) < 60) ++count;
        }
      return count;
    };
    EXPECT_GT(rimsAbout({0.5, 0, 0.5}), 20) << "the cross";
    EXPECT_GT(rimsAbout({-0.5, 0, -0.5}), 20) << "the ring";
    EXPECT_GT(rimsAbout({-0.25, 0, -0.25}), 20) << "the path";
    EXPECT_EQ(rimsAbout({-0.5, 0, 0.5}), 0);
  }
}

TEST(PaintedByTools, StandsOutFromPointsOfItsColor) {
  for (const bool isDark : {false, true}) {
    const Color accent = palette(isDark).contracted;
    QImage image(200, 100, QImage::Format_RGB32);
    image.fill(qRgb(accent[0], accent[1], accent[2]));
    QPainter painter(&image);
    paintBand(painter, QPolygonF({{10, 20}, {190, 20}}), isDark);
    Camera camera;
    camera.frame(Eigen::AlignedBox3d(Eigen::Vector3d(-1, 0, -1), Eigen::Vector3d(1, 0, 1)), 2);
    const ScreenMap screen(camera, {200, 100});
    const Preview preview{.lines = {{{-0.5, 0, 0}, {0.5, 0, 0}}}, .nodes = {}, .label = {}};
    paintPreview(painter, preview, screen, isDark);
    EXPECT_GT(contrastWith(accent, image.pixelColor(100, 18)), 100) << "beside the stroke";
    const auto middle = screen.project({0, 0, 0});
    ASSERT_TRUE(middle);
    const QPoint beside(int(middle->pixel.x()), int(middle->pixel.y()) - 3);
    EXPECT_GT(contrastWith(accent, image.pixelColor(beside)), 100) << "beside the preview";
  }
}

TEST(PaintedByTools, AnArrowAtTheRimLeadsToWhatTheViewDoesNotShow) {
  Camera camera;
  camera.frame(Eigen::AlignedBox3d(Eigen::Vector3d(-1, 0, -1), Eigen::Vector3d(1, 0, 1)), 2);
  const ScreenMap screen(camera, {200, 100});
  /// Where the middle of what is drawn lies, as seen from the middle of the view.
  const auto drawnToward = [&](const Eigen::Vector3d& place) -> std::optional<QPointF> {
    QImage image(200, 100, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintPreview(painter, {.lines = {}, .nodes = {}, .label = {}, .subjects = {place}}, screen,
                 false);
    QPointF sum;
    int count = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 200; ++x)
        if (image.pixelColor(x, y) != QColor(Qt::white)) {
          sum += QPointF(x - 100, y - 50);
          ++count;
        }
    if (count == 0) return std::nullopt;
    EXPECT_GT(count, 60);
    return sum / count;
  };
  EXPECT_FALSE(drawnToward({0.5, 0, 0}));
  const auto right = drawnToward({9, 0, 0});
  ASSERT_TRUE(right);
  EXPECT_GT(right->x(), 75);
  EXPECT_NEAR(right->y(), 0, 3);
  const auto above = drawnToward({0, 0, 9});
  ASSERT_TRUE(above);
  EXPECT_LT(above->y(), -25);
  const auto behind = drawnToward({-2, -50, 0}); // behind the eye, to the left
  ASSERT_TRUE(behind);
  EXPECT_LT(behind->x(), -75);
}

/// A cloud colored by height, and another state of it on the right.
class LegendsOfStates : public testing::Test {
protected:
  LegendsOfStates() {
    scene_.setCloud(test::cloudOf({{0, 0, 0}, {0, 0, 1}}));
    scene_.setOther(Side::right, state_);
  }
  [[nodiscard]] QStringList titles(double divider) const {
    QStringList titles;
    for (const Legend& legend : legendsOf(scene_, "m", SeenSides::of(divider)))
      titles.append(legend.title);
    return titles;
  }

  PlantState state_;
  Scene scene_;
};

TEST_F(LegendsOfStates, AreThoseOfColorsThatAreSeen) {
  const QStringList height = titles(1);
  ASSERT_EQ(height.size(), 1);
  EXPECT_EQ(titles(0), height) << "the points are where they were";
  state_.replacesPoints = true;
  scene_.setOther(Side::right, state_);
  EXPECT_EQ(titles(0), QStringList()) << "contracted points have one color";
  EXPECT_EQ(titles(0.5), height);
  scene_.blend = 0.5;
  EXPECT_EQ(titles(0), height) << "while they move they keep theirs";
  scene_.blend.reset();
  state_.within = Ball{{0, 0, 0}, 0.1};
  scene_.setOther(Side::right, state_);
  EXPECT_EQ(titles(0), height) << "of what lies around the ball";
}

TEST_F(LegendsOfStates, SayWhatColorsOfItsNodesStandFor) {
  state_.skeleton = test::stick(2);
  state_.colors =
      NodeColors{.values = {0, 1, 0},
                 .legend = {.title = "Differences", .unit = {}, .categories = {{"Matched", {}}}}};
  scene_.setOther(Side::right, state_);
  EXPECT_FALSE(titles(1).contains("Differences"));
  EXPECT_TRUE(titles(0).contains("Differences"));
  EXPECT_EQ(titles(0.5).count("Differences"), 1);
}

TEST(NamesOfStates, AreThoseOfBothSidesThatAreCompared) {
  Scene scene;
  scene.setCloud(test::cloudOf({{0, 0, 0}, {0, 0, 1}}));
  PlantState state;
  state.name = "Prune: length 3";
  scene.setOther(Side::right, state);
  const SeenSides both = SeenSides::of(0.5);
  EXPECT_EQ(nameOf(scene, Side::left, both), "Plant");
  EXPECT_EQ(nameOf(scene, Side::right, both), "Prune: length 3");
  EXPECT_EQ(nameOf(scene, Side::left, SeenSides::of(1)), "") << "the plant alone";
  scene.setOther(Side::left, state);
  scene.setOther(Side::right, std::nullopt);
  EXPECT_EQ(nameOf(scene, Side::right, both), "Plant") << "beside what was kept as A";
  EXPECT_EQ(nameOf(scene, Side::right, SeenSides::of(0)), "");
}

TEST(SightKey, NamesTheColorsAtTheTopLeft) {
  const auto painted = [](const ShownSight& sight) {
    QImage image(400, 300, QImage::Format_RGB32);
    image.fill(Qt::red);
    QPainter painter(&image);
    paintSightKey(painter, sight, false);
    return image;
  };
  ShownSight sight;
  sight.lines = {"Point at the plant"};
  const QImage image = painted(sight);
  const Color link = palette(false).reference;
  const Color cone = palette(false).branching;
  const auto has = [](const QImage& in, const Color& color) {
    for (int y = 0; y < in.height(); ++y)
      if (in.pixelColor(25, y) == QColor(color[0], color[1], color[2])) return true;
    return false;
  };
  EXPECT_NE(image.pixelColor(12, 12), QColor(Qt::red)) << "a veil";
  EXPECT_EQ(image.pixelColor(380, 280), QColor(Qt::red));
  EXPECT_TRUE(has(image, link));
  EXPECT_FALSE(has(image, cone));
  sight.cones.push_back({});
  EXPECT_TRUE(has(painted(sight), cone));
}

} // namespace
} // namespace espalier
