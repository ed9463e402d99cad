#include "ui/view/gl_objects.h"

#include "core/base/error.h"

#include <vtkOpenGLShaderCache.h>

#include <utility>

namespace espalier {
namespace {

GLuint makeTexture(GLint format, int width, int height, GLenum channels, GLenum type) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, type, nullptr);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  return name;
}

void removeTexture(GLuint& name) {
  if (name != 0) glDeleteTextures(1, &name);
  name = 0;
}

} // namespace

void GlBuffer::upload(const void* data, std::size_t bytes) {
  if (name_ == 0) glGenBuffers(1, &name_);
  bind();
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
  size_ = bytes;
}

void GlBuffer::write(const void* data, std::size_t offset, std::size_t bytes) {
  bind();
  glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                  data);
}

void GlBuffer::bind() const {
  glBindBuffer(GL_ARRAY_BUFFER, name_);
}

void GlBuffer::bindAsIndices() const {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name_);
}

void GlBuffer::release() {
  if (name_ != 0) glDeleteBuffers(1, &name_);
  name_ = 0;
  size_ = 0;
}

bool GlPicture::resize(int width, int height, bool withDepth) {
  if (framebuffer_ != 0 && width == width_ && height == height_) return false;
  release();
  width_ = width;
  height_ = height;
  color_ = makeTexture(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE);
  if (withDepth)
    depth_ = makeTexture(GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT);
  GLint before = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  if (withDepth)
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
  return true;
}

void GlPicture::copyTo(vtkOpenGLState& state, GLuint framebuffer, GLbitfield what) const {
  const Onto target(state, framebuffer);
  state.vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, what, GL_NEAREST);
}

void GlPicture::release() {
  removeTexture(color_);
  removeTexture(depth_);
  if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
  framebuffer_ = 0;
}

Onto::Onto(vtkOpenGLState& state, GLuint framebuffer) : state_(state) {
  state_.PushFramebufferBindings();
  state_.vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void setColor(vtkShaderProgram& program, const char* name, const Color& color) {
  const float values[3] = {color[0] / 255.0F, color[1] / 255.0F, color[2] / 255.0F};
  program.SetUniform3f(name, values);
}

vtkShaderProgram& readyProgram(vtkOpenGLRenderWindow& window, const char* vertex,
                               const char* fragment) {
  vtkShaderProgram* program = window.GetShaderCache()->ReadyShaderProgram(vertex, fragment, "");
  if (program == nullptr)
    throw Error("OpenGL: a shader does not compile; OpenGL 3.3 is needed, update the driver");
  return *program;
}

} // namespace espalier
