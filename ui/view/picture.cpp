#include "ui/view/picture.h"

#include "ui/view/offscreen_renderer.h"

#include <QBuffer>

#include <limits>

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
  OffscreenRenderer renderer(copy, makeSceneBuffers());
  PlantRenderer::Frame frame{.camera = camera, .size = size, .pixelRatio = pixelRatio};
  frame.points = std::numeric_limits<Eigen::Index>::max();
  frame.divider = overlay.divider;
  while (!renderer.draw(frame).complete) { // points, then their relief
  }
  QImage image = renderer.image();
  QPainter painter(&image);
  painter.scale(pixelRatio, pixelRatio);
  overlay.paint(painter, scene, camera, QSizeF(size) / pixelRatio);
  return image;
}

Camera cameraOf(const Scene& scene, StandardView view, double aspect) {
  Camera camera{.upAxis = scene.up};
  camera.face(view);
  const std::vector<Eigen::Vector3d> places = scene.outline();
  if (!places.empty()) camera.frame(places, aspect);
  return camera;
}

} // namespace espalier
