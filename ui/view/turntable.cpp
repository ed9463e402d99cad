#include "ui/view/turntable.h"

#include "core/graph/turn_upright.h"
#include "ui/view/picture.h"

#include <numbers>
#include <vector>

namespace espalier {

Camera turned(const Camera& camera, double part) {
  Camera result = camera;
  result.turn(2 * std::numbers::pi * part, 0);
  return result;
}

Camera cameraAround(const Scene& scene, StandardView view, double aspect) {
  constexpr int sides = 24;
  Camera camera = cameraOf(scene, view, aspect);
  const Eigen::Vector3d up = turnUpright(scene.up).row(2);
  std::vector<Eigen::Vector3d> around;
  for (const Eigen::Vector3d& place : scene.outline())
    for (int side = 0; side < sides; ++side)
      around.push_back(camera.pivot + Eigen::AngleAxisd(2 * std::numbers::pi * side / sides, up) *
                                          (place - camera.pivot));
  if (!around.empty()) camera.frame(around, aspect);
  return camera;
}

Turntable::Turntable(const Scene& scene, const Camera& camera, const Overlay& overlay,
                     const TurntableOptions& options)
    : scene_(scene), camera_(camera), overlay_(overlay), options_(options),
      renderer_(scene_, makeSceneBuffers()) {}

QImage Turntable::frame(int number) {
  const Camera now = turned(camera_, static_cast<double>(number) / options_.frames());
  return renderer_.picture(now, overlay_, options_.size, options_.pixelRatio);
}

} // namespace espalier
