#pragma once

#include "ui/view/camera.h"
#include "ui/view/overlay.h"
#include "ui/view/scene.h"

#include <QByteArray>
#include <QImage>
#include <QSize>

namespace espalier {

/// A picture of a scene with all its points, drawn without a window; needs a QGuiApplication, on
/// any platform.
/// @param size       in pixels, not empty
/// @param pixelRatio pixels to a logical pixel, in which lines, nodes and texts have their size
/// @throws Error if there is no OpenGL
[[nodiscard]] QImage picture(const Scene& scene, const Camera& camera, const Overlay& overlay,
                             const QSize& size, double pixelRatio = 1);

[[nodiscard]] QByteArray pngOf(const QImage& image); // as a PNG file holds it

/// The camera that shows all of a scene from one side.
/// @param aspect width of the picture over its height
[[nodiscard]] Camera cameraOf(const Scene& scene, StandardView view, double aspect);

} // namespace espalier
