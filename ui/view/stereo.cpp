#include "ui/view/stereo.h"

#include <QRgb>

#include <cassert>

namespace espalier {

std::pair<Camera, Camera> eyesOf(const Camera& between) {
  constexpr double apart = 1.0 / 30; // of the distance: comfortable for things about the focus
  Camera left = between;
  left.aside = -apart / 2;
  Camera right = between;
  right.aside = apart / 2;
  return {left, right};
}

QImage redCyan(const QImage& left, const QImage& right) {
  assert(left.size() == right.size());
  const QImage reds = left.convertToFormat(QImage::Format_RGB32);
  QImage both = right.convertToFormat(QImage::Format_RGB32);
  constexpr QRgb red = 0x00ff0000;
  for (int row = 0; row < both.height(); ++row) {
    const auto* from = reinterpret_cast<const QRgb*>(reds.constScanLine(row));
    auto* to = reinterpret_cast<QRgb*>(both.scanLine(row));
    for (int i = 0; i < both.width(); ++i)
      to[i] = (from[i] & red) | (to[i] & ~red);
  }
  return both;
}

} // namespace espalier
