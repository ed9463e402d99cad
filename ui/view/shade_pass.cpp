#include "ui/view/shade_pass.h"

#include <cmath>

namespace espalier {
namespace {

// One triangle that covers the screen; needs no vertices.
constexpr const char* coverShader = R"(#version 330 core
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
})";

// Apart from each other, since software OpenGL takes the time of all branches.
constexpr const char* backgroundShader = R"(#version 330 core
uniform vec3 top;
uniform vec3 bottom;
uniform float height;      // of the screen, in pixels
out vec4 fragment;
void main() { fragment = vec4(mix(bottom, top, gl_FragCoord.y / height), 1.0); })";

constexpr const char* flatShader = R"(#version 330 core
uniform sampler2D pointColor;
uniform vec3 top;
uniform vec3 bottom;
uniform float height;      // of the screen, in pixels
out vec4 fragment;
void main() {
  vec4 color = texelFetch(pointColor, ivec2(gl_FragCoord.xy), 0);
  vec3 background = mix(bottom, top, gl_FragCoord.y / height);
  fragment = vec4(mix(background, color.rgb, color.a), 1.0);
})";

constexpr const char* reliefShader = R"(#version 330 core
uniform sampler2D pointColor;
uniform sampler2D pointDepth;
uniform vec3 top;
uniform vec3 bottom;
uniform float height;      // of the screen, in pixels
uniform vec2 projection;   // the two terms of the projection matrix that make depths
uniform float pixelSize;   // in perspective at depth 1
uniform int perspective;
uniform int reach;         // of the neighborhood, in pixels
uniform float strength;
out vec4 fragment;

float linear(float stored) {
  float ndc = 2.0 * stored - 1.0;
  return perspective != 0 ? projection.y / (ndc + projection.x)
                          : (projection.y - ndc) / projection.x;
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(pointColor, here, 0);
  if (color.a == 0.0) {
    fragment = vec4(mix(bottom, top, gl_FragCoord.y / height), 1.0);
    return;
  }
  fragment = vec4(color.rgb, 1.0);
  const ivec2 around[8] = ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1),
                                   ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1), ivec2(-1, -1));
  float depth = linear(texelFetch(pointDepth, here, 0).r);
  float unit = pixelSize * float(reach) * (perspective != 0 ? depth : 1.0);
  ivec2 last = textureSize(pointDepth, 0) - 1;
  float hidden = 0.0;
  for (int i = 0; i < 8; ++i) {
    float stored = texelFetch(pointDepth, clamp(here + reach * around[i], ivec2(0), last), 0).r;
    if (stored < 1.0) hidden += clamp((depth - linear(stored)) / (10.0 * unit), 0.0, 1.0);
  }
  fragment.rgb *= exp(-strength * hidden / 8.0);
})";

void bindTexture(vtkOpenGLState& state, int unit, GLuint texture) {
  state.vtkglActiveTexture(static_cast<unsigned>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

void setRelief(vtkShaderProgram& program, const DrawSettings& settings, float strength) {
  program.SetUniformf("strength", strength);
  program.SetUniformi("pointDepth", 1);
  const float projection[2] = {settings.toClip(2, 2), settings.toClip(2, 3)};
  program.SetUniform2f("projection", projection);
  program.SetUniformf("pixelSize", settings.pixelSize);
  program.SetUniformi("perspective", settings.perspective ? 1 : 0);
  program.SetUniformi("reach", static_cast<int>(std::lround(settings.pixelRatio)));
}

} // namespace

vtkShaderProgram& ShadePass::prepare(const DrawSettings& settings, const Palette& palette,
                                     const char* fragmentShader) {
  vtkOpenGLState* state = settings.window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  vtkShaderProgram& program = readyProgram(*settings.window, coverShader, fragmentShader);
  setColor(program, "top", palette.backgroundTop);
  setColor(program, "bottom", palette.backgroundBottom);
  program.SetUniformf("height", settings.size.y());
  return program;
}

void ShadePass::drawBackground(const DrawSettings& settings, const Palette& palette) {
  prepare(settings, palette, backgroundShader);
  fill();
}

void ShadePass::draw(const DrawSettings& settings, const GlPicture& points, const Palette& palette,
                     bool relief) {
  vtkShaderProgram& program = prepare(settings, palette, relief ? reliefShader : flatShader);
  vtkOpenGLState* state = settings.window->GetState();
  bindTexture(*state, 0, points.color());
  program.SetUniformi("pointColor", 0);
  if (relief) {
    bindTexture(*state, 1, points.depth());
    setRelief(program, settings, palette.relief);
  }
  fill();
}

void ShadePass::fill() {
  if (vertexArray_ == 0) glGenVertexArrays(1, &vertexArray_);
  glBindVertexArray(vertexArray_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void ShadePass::release() {
  if (vertexArray_ != 0) glDeleteVertexArrays(1, &vertexArray_);
  vertexArray_ = 0;
}

} // namespace espalier
