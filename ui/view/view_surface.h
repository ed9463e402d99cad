#pragma once

#include "ui/view/plant_renderer.h"

#include <QWidget>

#include <functional>
#include <memory>

namespace espalier {

/// What a surface asks of the view it belongs to.
struct SurfaceClient {
  std::function<PlantRenderer::Frame(QSize devicePixels, double pixelRatio)> nextFrame;
  std::function<void(const PlantRenderer::Result& result, double milliseconds)> drawn;
};

/// A widget in which a scene appears; it draws when asked to by QWidget::update().
///
/// With OpenGL where the platform of Qt has it; else drawn off screen and painted as an image: on
/// the platforms without windows, which tests and servers use.
/// @param scene   must outlive the widget, which `parent` owns
/// @param buffers of this scene; surfaces in one window may have the same
[[nodiscard]] QWidget* makeSurface(Scene& scene, std::shared_ptr<SceneBuffers> buffers,
                                   SurfaceClient client, QWidget* parent);

} // namespace espalier
