#include "ui/panels/plant_picture.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// The rectangle of what is drawn.
QRect inked(const QImage& picture) {
  QRect box;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qAlpha(picture.pixel(x, y)) > 0) box |= QRect(x, y, 1, 1);
  return box;
}

/// A trunk of 10 along `up`, with an arm of 2 near its end.
Skeleton trunkAlong(const Eigen::Vector3d& up, const Eigen::Vector3d& across) {
  Skeleton plant;
  NodeId top = plant.add({});
  for (int i = 1; i <= 10; ++i)
    top = plant.add({.position = i * up, .parent = top});
  plant.add({.position = 10 * up + 2 * across, .parent = top});
  return plant;
}

TEST(PlantPicture, StandsUprightWhateverAxisPointsUp) {
  const std::vector<Eigen::Vector3d> axes = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                             Eigen::Vector3d::UnitZ()};
  for (std::size_t up = 0; up < 3; ++up) {
    const QImage picture = pictureOf(trunkAlong(axes[up], axes[(up + 1) % 3]), 64);
    const QRect box = inked(picture);
    EXPECT_GT(box.height(), 55) << up;
    EXPECT_NEAR(box.width(), box.height() / 5.0, 3) << up;
    EXPECT_LT(inked(picture.copy(0, 40, 64, 24)).width(), 5) << "the arm is at the top";
  }
}

TEST(PlantPicture, ShowsPointsOfAScan) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 100; ++i)
    points.emplace_back(0, 0.2 * i, i);
  const QRect box = inked(pictureOf(points, UpAxis::z, 64));
  EXPECT_GT(box.height(), 55);
  EXPECT_NEAR(box.width(), box.height() / 5.0, 3);
}

TEST(PlantPicture, IsEmptyWhereThereIsNothingToDraw) {
  EXPECT_TRUE(inked(pictureOf(Skeleton(), 32)).isEmpty());
  EXPECT_TRUE(inked(pictureOf(std::vector<Eigen::Vector3d>(), UpAxis::z, 32)).isEmpty());
  Skeleton dot;
  dot.add({});
  EXPECT_TRUE(inked(pictureOf(dot, 32)).isEmpty()) << "a node without an edge";
}

} // namespace
} // namespace espalier
