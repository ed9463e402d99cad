#include "tests/ui/view/pictures.h"

#include <algorithm>
#include <cstdlib>

namespace espalier::test {
namespace {

bool isAbout(QRgb pixel, const Color& color, int tolerance) {
  return std::abs(qRed(pixel) - color[0]) <= tolerance &&
         std::abs(qGreen(pixel) - color[1]) <= tolerance &&
         std::abs(qBlue(pixel) - color[2]) <= tolerance;
}

int countIn(const QImage& picture, const QRect& part, const Color& color, int tolerance) {
  int count = 0;
  for (int y = part.top(); y <= part.bottom(); ++y)
    for (int x = part.left(); x <= part.right(); ++x)
      if (isAbout(picture.pixel(x, y), color, tolerance)) ++count;
  return count;
}

} // namespace

int countPixels(const QImage& picture, const QPointF& place, int reach, const Color& color,
                int tolerance) {
  const QPoint at = place.toPoint();
  const QRect around(at - QPoint(reach, reach), at + QPoint(reach, reach));
  return countIn(picture, around & picture.rect(), color, tolerance);
}

int countPixels(const QImage& picture, const Color& color, int tolerance) {
  return countIn(picture, picture.rect(), color, tolerance);
}

int countDifferences(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return std::max(a.width() * a.height(), b.width() * b.height());
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y)) ++count;
  return count;
}

std::shared_ptr<const PointCloud> cloudOf(const std::vector<Eigen::Vector3d>& positions) {
  RawPoints raw;
  raw.positions = positions;
  return std::make_shared<const PointCloud>(std::move(raw));
}

std::shared_ptr<const PointCloud> block(const Eigen::Vector3d& middle) {
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j)
      for (int k = 0; k < 40; ++k)
        positions.emplace_back(middle + Eigen::Vector3d(i, j, k) / 39.0 -
                               Eigen::Vector3d::Constant(0.5));
  return cloudOf(positions);
}

} // namespace espalier::test
