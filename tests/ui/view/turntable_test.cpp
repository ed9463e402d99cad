#include "tests/support/cloud_of.h"
#include "tests/support/plants.h"
#include "tests/ui/view/pictures.h"
#include "ui/view/animated_png.h"
#include "ui/view/picture.h"
#include "ui/view/turntable.h"

#include <QtEndian>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

namespace espalier {
namespace {

Scene sceneOfFork() {
  Scene scene;
  scene.setSkeleton(test::fork(2));
  return scene;
}

TEST(Turntable, IsBackAfterOneTurn) {
  const Scene scene = sceneOfFork();
  const TurntableOptions options{.size = {200, 160}, .seconds = 2};
  const Camera camera = cameraAround(scene, StandardView::front, 200.0 / 160);
  Turntable turntable(scene, camera, {}, options);
  ASSERT_EQ(options.frames(), 30);
  const QImage first = turntable.frame(0);
  EXPECT_EQ(first, picture(scene, camera, {}, options.size));
  EXPECT_GT(test::countDifferences(turntable.frame(8), first), 100) << "about from the side";
  Camera quarter = turned(camera, 0.25);
  EXPECT_NEAR(quarter.yaw, camera.yaw + std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR((turned(camera, 1).eye() - camera.eye()).norm(), 0, 1e-9);
}

TEST(Turntable, ShowsAllOfThePlantAtEachPartOfTheTurn) {
  Scene scene; // which is wide from one side only
  scene.setCloud(test::cloudOf(std::vector<Eigen::Vector3d>{{0, -5, 0}, {0, 5, 0}, {0.1, 0, 1}}));
  const Camera camera = cameraAround(scene, StandardView::right, 1.25);
  for (int i = 0; i < 36; ++i) {
    const ScreenMap screen(turned(camera, i / 36.0), {200, 160});
    for (const Eigen::Vector3d& place : scene.outline()) {
      const auto at = screen.project(place);
      ASSERT_TRUE(at);
      EXPECT_TRUE(QRectF(0, 0, 200, 160).contains(at->pixel.x(), at->pixel.y())) << i;
    }
  }
}

/// The types of the chunks of a PNG, and what is in each.
std::vector<std::pair<std::string, QByteArray>> chunksIn(const QByteArray& png) {
  std::vector<std::pair<std::string, QByteArray>> chunks;
  for (qsizetype at = 8; at + 12 <= png.size();) {
    const auto size = static_cast<qsizetype>(qFromBigEndian<quint32>(png.constData() + at));
    chunks.emplace_back(png.mid(at + 4, 4).toStdString(), png.mid(at + 8, size));
    at += 12 + size;
  }
  return chunks;
}

TEST(AnimatedPng, HoldsEachPictureAsItIs) {
  std::ostringstream out;
  std::vector<QImage> frames;
  AnimatedPng movie(out, 3, 15);
  for (const Qt::GlobalColor color : {Qt::red, Qt::green, Qt::blue}) {
    QImage frame(40, 30, QImage::Format_RGB888);
    frame.fill(Qt::white);
    frame.setPixelColor(7, 3, color);
    movie.add(frame);
    frames.push_back(frame);
  }
  const std::string written = out.str();
  const QByteArray png(written.data(), static_cast<qsizetype>(written.size()));
  EXPECT_EQ(QImage::fromData(png).convertToFormat(QImage::Format_RGB888), frames.front())
      << "who knows no animation shows the first";
  const auto chunks = chunksIn(png);
  std::vector<std::string> types;
  for (const auto& [type, data] : chunks)
    types.push_back(type);
  EXPECT_THAT(types, testing::ElementsAre("IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "fcTL",
                                          "fdAT", "IEND"));
  EXPECT_EQ(qFromBigEndian<quint32>(chunks[1].second.constData()), 3U);
  quint32 sequence = 0;
  std::size_t shown = 0;
  for (const auto& [type, data] : chunks) {
    if (type != "fcTL" && type != "fdAT") continue;
    EXPECT_EQ(qFromBigEndian<quint32>(data.constData()), sequence++) << "in order, without a gap";
    if (type == "fcTL") {
      EXPECT_EQ(qFromBigEndian<quint16>(data.constData() + 20), 1);
      EXPECT_EQ(qFromBigEndian<quint16>(data.constData() + 22), 15) << "a fifteenth of a second";
      continue;
    }
    // A PNG of one picture, made of its data, is that picture.
    QByteArray one = pngOf(frames[++shown]);
    EXPECT_TRUE(one.contains(data.mid(4)));
  }
  EXPECT_EQ(shown, 2U);
}

} // namespace
} // namespace espalier
