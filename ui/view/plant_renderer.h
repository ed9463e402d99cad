#pragma once

#include "ui/view/camera.h"
#include "ui/view/scene.h"

#include <QImage>
#include <QSize>

#include <functional>
#include <memory>

namespace espalier {

class SceneBuffers; // scene_buffers.h, which names OpenGL

/// For renderers of one scene, whose contexts share what they hold.
[[nodiscard]] std::shared_ptr<SceneBuffers> makeSceneBuffers();
/// What a scene takes in the memory of the graphics card [bytes].
[[nodiscard]] std::size_t bytesIn(SceneBuffers& buffers);

/// Draws a scene in an OpenGL context that someone else owns: points, their relief, the reference,
/// the skeleton. VTK keeps the state of OpenGL and the shaders; its own passes would fill the whole
/// screen twice more in each frame, which is most of the time on software OpenGL.
class PlantRenderer {
public:
  /// How the context is reached. Both are called in the middle of drawing.
  struct Context {
    std::function<void()> makeCurrent;
    std::function<bool()> isCurrent;
  };

  /// @param scene   must outlive the renderer
  /// @param buffers of this scene, of no other
  PlantRenderer(Scene& scene, std::shared_ptr<SceneBuffers> buffers, Context context);
  /// The context is made current, if it still can be, to free what is held in it.
  ~PlantRenderer();

  struct Frame {
    Camera camera;
    QSize size;            // [device pixels], not empty
    double pixelRatio = 1; // device pixels a logical pixel
    Eigen::Index points;   // to draw in this frame, at most
    bool moving = false;   // the next frame will show something else
    double divider = 1;    // as PlantView::setDivider
  };
  struct Result {
    bool complete;            // all points are drawn, with their relief
    Eigen::Index pointsDrawn; // by this frame
    bool reliefDrawn;         // anew
  };
  /// Draws into a framebuffer of its own. Still frames that are the same add to each other until
  /// they are complete.
  /// pre: the context is current
  /// @throws Error if OpenGL is older than 3.3
  Result draw(const Frame& frame);

  /// Copies what was drawn into a framebuffer of the same size.
  void copyTo(unsigned int framebuffer);
  [[nodiscard]] QImage image();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace espalier
