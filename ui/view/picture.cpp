#include "ui/view/picture.h"

#include "ui/view/offscreen_renderer.h"

#include <QBuffer>

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
  return OffscreenRenderer(copy, makeSceneBuffers()).picture(camera, overlay, size, pixelRatio);
}

Camera cameraOf(const Scene& scene, StandardView view, double aspect) {
  Camera camera{.upAxis = scene.up};
  camera.face(view);
  const std::vector<Eigen::Vector3d> places = scene.outline();
  if (!places.empty()) camera.frame(places, aspect);
  return camera;
}

} // namespace espalier
