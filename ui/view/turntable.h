#pragma once

#include "ui/view/camera.h"
#include "ui/view/offscreen_renderer.h"
#include "ui/view/overlay.h"
#include "ui/view/scene.h"

#include <QImage>
#include <QSize>

#include <memory>

namespace espalier {

/// A plant that turns once about its vertical axis, in pictures.
struct TurntableOptions {
  static constexpr int perSecond = 15; // pictures
  static constexpr int leastSeconds = 2;
  static constexpr int mostSeconds = 60;

  QSize size{800, 500};  // [pixels], not empty
  double pixelRatio = 1; // as of picture()
  int seconds = 6;       // a turn, leastSeconds to mostSeconds

  [[nodiscard]] int frames() const { return seconds * perSecond; }
};

/// The camera after a part of a turn, in [0, 1]: about the pivot, counterclockwise from above.
[[nodiscard]] Camera turned(const Camera& camera, double part);

/// The camera of cameraOf(), from as far as shows all of the scene at each part of a turn.
[[nodiscard]] Camera cameraAround(const Scene& scene, StandardView view, double aspect);

/// Draws the pictures of a turn, of the scene as it is when this is made.
class Turntable {
public:
  /// @throws Error if there is no OpenGL
  Turntable(const Scene& scene, const Camera& camera, const Overlay& overlay,
            const TurntableOptions& options);

  [[nodiscard]] const TurntableOptions& options() const { return options_; }
  [[nodiscard]] QImage frame(int number); // in [0, options().frames())

private:
  Scene scene_;
  Camera camera_;
  Overlay overlay_;
  TurntableOptions options_;
  OffscreenRenderer renderer_;
};

} // namespace espalier
