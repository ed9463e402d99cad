#pragma once

#include "ui/view/plant_renderer.h"

#include <memory>

namespace espalier {

/// Draws a scene where there is no window, and with EGL not even a display. All of them draw in one
/// context, which lives as long as any.
class OffscreenRenderer {
public:
  /// @param scene   must outlive the renderer
  /// @param buffers of this scene, of no other
  /// @throws Error if there is no OpenGL
  OffscreenRenderer(Scene& scene, std::shared_ptr<SceneBuffers> buffers);
  ~OffscreenRenderer();

  PlantRenderer::Result draw(const PlantRenderer::Frame& frame); // as there
  [[nodiscard]] QImage image();

private:
  class Context;

  std::shared_ptr<Context> context_; // outlives what is drawn in it
  std::unique_ptr<PlantRenderer> renderer_;
};

} // namespace espalier
