#pragma once

#include "ui/view/plant_renderer.h"

#include <memory>

namespace espalier {

/// Draws a scene where there is no window, and with EGL not even a display.
class OffscreenRenderer {
public:
  /// @param scene must outlive the renderer
  /// @throws Error if there is no OpenGL
  explicit OffscreenRenderer(Scene& scene);
  ~OffscreenRenderer();

  PlantRenderer::Result draw(const PlantRenderer::Frame& frame); // as there
  [[nodiscard]] QImage image();

private:
  class Context;

  std::unique_ptr<Context> context_; // outlives what is drawn in it
  std::unique_ptr<PlantRenderer> renderer_;
};

} // namespace espalier
