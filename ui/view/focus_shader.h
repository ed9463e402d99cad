#pragma once

#include <Eigen/Core>
#include <vtkShaderProgram.h>

/// What shaders ask of FocusDepths, by the same rules; to be put before their main(). How far a
/// depth is stepped back, whether it is passed, and where a passed place is drawn in clip space.
#define ESPALIER_FOCUS                                                                             \
  "uniform vec4 focus;\n"                                                                          \
  "float outOfFocus(float depth) {\n"                                                              \
  "  return focus.w * smoothstep(0.0, focus.z, max(focus.x - depth, depth - focus.y));\n"          \
  "}\n"                                                                                            \
  "bool isPassed(float depth) {\n"                                                                 \
  "  return focus.w >= 0.3 && depth < focus.x && outOfFocus(depth) >= 0.5 * focus.w;\n"            \
  "}\n"                                                                                            \
  "vec4 behindFocus(vec4 clip, float depth) {\n"                                                   \
  "  return isPassed(depth) ? vec4(clip.xy, 0.9995 * clip.w, clip.w) : clip;\n"                    \
  "}\n"

namespace espalier {

inline void setFocus(vtkShaderProgram& program, const Eigen::Vector4f& focus) {
  Eigen::Vector4f values = focus;
  program.SetUniform4f("focus", values.data());
}

} // namespace espalier
