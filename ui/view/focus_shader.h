#pragma once

#include <Eigen/Core>
#include <vtkShaderProgram.h>

/// What shaders ask of FocusDepths; to be put before their main(). How far a depth is stepped back,
/// and a place in clip space that is out of focus and before it, behind all that is in focus.
#define ESPALIER_FOCUS                                                                             \
  "uniform vec4 focus;\n"                                                                          \
  "float outOfFocus(float depth) {\n"                                                              \
  "  return focus.w * smoothstep(0.0, focus.z, max(focus.x - depth, depth - focus.y));\n"          \
  "}\n"                                                                                            \
  "vec4 behindFocus(vec4 clip, float depth) {\n"                                                   \
  "  float back = depth < focus.x ? outOfFocus(depth) : 0.0;\n"                                    \
  "  return vec4(clip.xy, mix(clip.z, 0.9995 * clip.w, back), clip.w);\n"                          \
  "}\n"

namespace espalier {

inline void setFocus(vtkShaderProgram& program, const Eigen::Vector4f& focus) {
  Eigen::Vector4f values = focus;
  program.SetUniform4f("focus", values.data());
}

} // namespace espalier
