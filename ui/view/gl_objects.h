#pragma once

#include "ui/view/clip.h"
#include "ui/view/palette.h"

#include <Eigen/Core>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>
#include <vtk_glew.h>

#include <cstddef>

namespace espalier {

/// What the passes are drawn with. Matrices are about the origin of the scene.
struct DrawSettings {
  vtkOpenGLRenderWindow* window; // its context is current
  Eigen::Matrix4f toView;
  Eigen::Matrix4f toClip; // of view coordinates
  Eigen::Vector2f size;   // [device pixels]
  float pixelRatio;       // device pixels a logical pixel
  bool perspective;
  float pixelSize;       // width of a device pixel [L]; in perspective at depth 1
  ClipVolume clip;       // what is drawn
  float depthFade;       // how far the back of the plant steps back, in [0, 1]
  Eigen::Vector4f focus; // FocusDepths::forShaders()
  double divider;        // of the view, as PlantView::setDivider
};

/// Memory of the graphics card. The context it was made in must be current at each call and
/// released before it goes.
class GlBuffer {
public:
  void upload(const void* data, std::size_t bytes);                    // replaces all
  void write(const void* data, std::size_t offset, std::size_t bytes); // pre: within its size
  void bind() const;                                       // as what attributes are read from
  void bindAsIndices() const;                              // to the vertex array that is bound
  [[nodiscard]] std::size_t size() const { return size_; } // [bytes]
  void release();

private:
  GLuint name_ = 0;
  std::size_t size_ = 0;
};

/// A picture with depth that can be drawn into and read as textures.
class GlPicture {
public:
  /// Makes it of this size, if it is not. Returns whether it was made anew, and so is undefined.
  bool resize(int width, int height, bool withDepth);
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_; }
  [[nodiscard]] GLuint color() const { return color_; }
  [[nodiscard]] GLuint depth() const { return depth_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// To one of the same size, and the same kind of depth if `what` has GL_DEPTH_BUFFER_BIT.
  void copyTo(vtkOpenGLState& state, GLuint framebuffer, GLbitfield what) const;
  void release();

private:
  GLuint framebuffer_ = 0;
  GLuint color_ = 0;
  GLuint depth_ = 0;
  int width_ = 0;
  int height_ = 0;
};

/// As long as it lives, what is drawn goes to a framebuffer, and what is read comes from there.
class Onto {
public:
  Onto(vtkOpenGLState& state, GLuint framebuffer);
  ~Onto() { state_.PopFramebufferBindings(); }
  Onto(const Onto&) = delete;
  Onto& operator=(const Onto&) = delete;

private:
  vtkOpenGLState& state_;
};

void setColor(vtkShaderProgram& program, const char* name, const Color& color); // of a uniform

/// A shader program, ready for use; kept by VTK's cache. @throws Error if it does not compile
[[nodiscard]] vtkShaderProgram& readyProgram(vtkOpenGLRenderWindow& window, const char* vertex,
                                             const char* fragment);

} // namespace espalier
