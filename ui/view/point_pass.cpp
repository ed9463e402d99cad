#include "ui/view/point_pass.h"

#include "ui/view/clip_shader.h"
#include "ui/view/palette.h"

#include <vtkOpenGLState.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr const char* vertexShader = "#version 330 core\n" ESPALIER_CLIP R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color; // alpha 0: hidden
uniform mat4 toClip;
uniform vec4 toDepth;
uniform vec2 depths;          // of the plant, nearest and farthest
uniform float depthFade;
uniform vec3 backgroundColor;
flat out vec3 pointColor;
void main() {
  float depth = dot(toDepth, vec4(position, 1.0));
  gl_Position = color.a < 0.5 || isClipped(position, depth) ? vec4(2.0, 2.0, 2.0, 1.0)
                                                            : toClip * vec4(position, 1.0);
  float part = clamp((depth - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  pointColor = mix(color.rgb, backgroundColor, 0.92 * depthFade * part);
})";

constexpr const char* squareShader = R"(#version 330 core
flat in vec3 pointColor;
out vec4 fragment;
void main() { fragment = vec4(pointColor, 1.0); })";

// Apart from the square one, because discarding costs the early depth test.
constexpr const char* roundShader = R"(#version 330 core
flat in vec3 pointColor;
out vec4 fragment;
void main() {
  vec2 offset = gl_PointCoord - 0.5;
  if (dot(offset, offset) > 0.25) discard;
  fragment = vec4(pointColor, 1.0);
})";

/// Nearest and farthest depth of a scene [L].
Eigen::Vector2f depthsOf(const Scene& scene, const Eigen::Vector4f& toDepth) {
  const Eigen::AlignedBox3d bounds = scene.bounds();
  const Eigen::Vector3f middle = (bounds.center() - scene.origin()).cast<float>();
  const Eigen::Vector3f half = (bounds.sizes() / 2).cast<float>();
  const float depth = toDepth.dot(middle.homogeneous());
  const float reach = std::max(toDepth.head<3>().cwiseAbs().dot(half), 1e-30F);
  return {depth - reach, depth + reach};
}

/// Points are as many pixels larger as fewer of them are drawn: the plant keeps its body.
float sizeFor(const Scene& scene, const DrawSettings& settings, double part) {
  const auto size = static_cast<float>(scene.pointSize) * settings.pixelRatio;
  return std::round(size * static_cast<float>(std::clamp(std::pow(part, -0.25), 1.0, 2.0)));
}

} // namespace

PointPass::Key PointPass::keyOf(const DrawSettings& settings, float pointSize) const {
  return {settings.toClip * settings.toView,
          settings.size,
          pointSize,
          {scene_.points.revision, scene_.colorRevision, scene_.contracted.revision,
           scene_.points.visible ? 1U : 0U, scene_.contracted.visible ? 1U : 0U},
          settings.clip,
          settings.depthFade};
}

PointPass::Result PointPass::draw(const DrawSettings& settings, Eigen::Index atMost, bool moving) {
  buffers_.uploadPoints(scene_);
  Eigen::Index total = 0;
  for (const PointLayer* layer : {&scene_.points, &scene_.contracted})
    if (layer->visible) total += layer->size();
  const double step = total > atMost ? static_cast<double>(atMost) / static_cast<double>(total) : 1;
  const float pointSize = sizeFor(scene_, settings, moving ? step : 1);
  const bool isNew = picture_.resize(static_cast<int>(settings.size.x()),
                                     static_cast<int>(settings.size.y()), true);
  const Key key = keyOf(settings, pointSize);
  const bool restart = isNew || !key_ || !(*key_ == key);
  if (!restart && (drawn_ >= 1 || moving)) return {false, drawn_ >= 1, 0};
  key_ = key;

  if (restart) drawn_ = 0;
  const double until = std::min(1.0, drawn_ + step);
  drawLayers(settings, pointSize, until);
  const auto drawn = static_cast<Eigen::Index>((until - drawn_) * static_cast<double>(total));
  drawn_ = until;
  return {true, drawn_ >= 1, drawn};
}

void PointPass::drawLayers(const DrawSettings& settings, float pointSize, double until) {
  vtkOpenGLState* state = settings.window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer());
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  if (drawn_ == 0) {
    state->vtkglClearColor(0, 0, 0, 0);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  if (scene_.points.visible)
    drawLayer(settings, scene_.points, buffers_.cloud(), pointSize, drawn_, until);
  if (scene_.contracted.visible)
    drawLayer(settings, scene_.contracted, buffers_.contracted(), pointSize, drawn_, until);
  state->PopFramebufferBindings();
}

void PointPass::drawLayer(const DrawSettings& settings, const PointLayer& points,
                          const SceneBuffers::Points& layer, float pointSize, double from,
                          double to) {
  const auto count = static_cast<double>(points.size());
  const auto first = static_cast<GLint>(std::llround(from * count));
  const auto last = static_cast<GLint>(std::llround(to * count));
  if (first == last) return;
  const bool isRound = pointSize >= 4;
  vtkShaderProgram& program =
      readyProgram(*settings.window, vertexShader, isRound ? roundShader : squareShader);
  const Eigen::Matrix4f matrix = settings.toClip * settings.toView;
  program.SetUniformMatrix4x4("toClip", const_cast<float*>(matrix.data()));
  setClip(program, settings.clip);
  const Eigen::Vector4f toDepth = -settings.toView.row(2).transpose();
  program.SetUniform4f("toDepth", toDepth.data());
  const Eigen::Vector2f depths = depthsOf(scene_, toDepth);
  program.SetUniform2f("depths", depths.data());
  program.SetUniformf("depthFade", settings.depthFade);
  const Color& background = palette(scene_.dark).backgroundBottom;
  const Eigen::Vector3f faded =
      Eigen::Vector3f(background[0], background[1], background[2]) / 255.0F;
  program.SetUniform3f("backgroundColor", faded.data());

  if (vertexArray_ == 0) glGenVertexArrays(1, &vertexArray_);
  glBindVertexArray(vertexArray_);
  layer.positions.bind();
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  if (layer.colors.size() > 0) {
    layer.colors.bind();
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr);
  } else {
    const Color& color = palette(scene_.dark).contracted;
    glDisableVertexAttribArray(1);
    glVertexAttrib4Nub(1, color[0], color[1], color[2], 255);
  }
  glPointSize(pointSize);
  glDrawArrays(GL_POINTS, first, last - first);
  glBindVertexArray(0);
}

void PointPass::release() {
  if (vertexArray_ != 0) glDeleteVertexArrays(1, &vertexArray_);
  vertexArray_ = 0;
  picture_.release();
  key_.reset();
}

} // namespace espalier
