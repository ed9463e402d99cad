#pragma once

#include "ui/view/overlay.h"
#include "ui/view/plant_renderer.h"

#include <memory>

namespace espalier {

/// Draws a scene where there is no window, and with EGL not even a display. All of them draw in one
/// context, which lives as long as any. Where it is lost, they go on in another.
class OffscreenRenderer {
public:
  /// @param scene   must outlive the renderer
  /// @param buffers of this scene, of no other
  /// @throws Error if there is no OpenGL
  OffscreenRenderer(Scene& scene, std::shared_ptr<SceneBuffers> buffers);
  ~OffscreenRenderer();

  /// As there. @throws Error if there is no OpenGL any more
  PlantRenderer::Result draw(const PlantRenderer::Frame& frame);
  [[nodiscard]] QImage image();
  /// All points, with the overlay; as espalier::picture().
  [[nodiscard]] QImage picture(const Camera& camera, const Overlay& overlay, const QSize& size,
                               double pixelRatio);

private:
  class Context;
  void begin();

  Scene& scene_;
  std::shared_ptr<SceneBuffers> buffers_;
  std::shared_ptr<Context> context_; // outlives what is drawn in it
  std::unique_ptr<PlantRenderer> renderer_;
};

} // namespace espalier
