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
  std::function<bool()> isStereo; // whether the frame is drawn for each eye, by redCyan()
};

/// How a picture comes into its widget: painted as an image that was drawn off screen, or drawn by
/// OpenGL into the window.
enum class SurfaceKind { image, openGl };

/// An image on the platforms of Qt without OpenGL, and where OpenGL is software: there Qt would
/// compose the whole window by software for every frame. ESPALIER_SURFACE (image or opengl) in the
/// environment overrules.
[[nodiscard]] SurfaceKind surfaceKind();

/// A widget in which a scene appears; it draws when asked to by QWidget::update().
/// @param scene   must outlive the widget, which `parent` owns
/// @param buffers of this scene; surfaces in one window may have the same
[[nodiscard]] QWidget* makeSurface(Scene& scene, std::shared_ptr<SceneBuffers> buffers,
                                   SurfaceClient client, QWidget* parent);

} // namespace espalier
