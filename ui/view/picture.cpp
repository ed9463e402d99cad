#include "ui/view/picture.h"

#include "ui/view/corner.h"
#include "ui/view/offscreen_renderer.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QImage>

namespace espalier {

QByteArray pngOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

QImage picture(const Scene& scene, const Camera& camera, const Overlay& overlay, const QSize& size,
               double pixelRatio) {
  Scene copy = scene; // drawing takes from a scene what changed in it
  Overlay placed = overlay;
  if (!overlay.isBare && overlay.hasLegends) {
    const QSizeF logical = QSizeF(size) / pixelRatio;
    const QImage device(1, 1, QImage::Format_ARGB32_Premultiplied);
    placed.giveWay(scene,
                   plantOnScreen(scene, ScreenMap(camera, {logical.width(), logical.height()})),
                   logical, QFontMetricsF(QFont(), &device));
  }
  return OffscreenRenderer(copy, makeSceneBuffers()).picture(camera, placed, size, pixelRatio);
}

Camera cameraOf(const Scene& scene, StandardView view, double aspect) {
  Camera camera{.upAxis = scene.up};
  camera.face(view);
  const std::vector<Eigen::Vector3d> places = scene.outline();
  if (!places.empty()) camera.frame(places, aspect);
  return camera;
}

} // namespace espalier
