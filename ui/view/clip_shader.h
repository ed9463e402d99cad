#pragma once

#include "core/cloud/ball.h"
#include "ui/view/gl_objects.h"

#include <optional>

/// What shaders ask of a ClipVolume, and how far a depth is faded; to be put before their main().
#define ESPALIER_CLIP                                                                              \
  "uniform int clipped;\n"                                                                         \
  "uniform vec2 clipDepths;\n"                                                                     \
  "uniform vec3 clipLow;\n"                                                                        \
  "uniform vec3 clipHigh;\n"                                                                       \
  "uniform vec4 hole;\n" /* a ball: its center and radius; radius 0: none */                       \
  "bool isInHole(vec3 place) { return distance(place, hole.xyz) < hole.w; }\n"                     \
  "bool isClipped(vec3 place, float depth) {\n"                                                    \
  "  return isInHole(place) || clipped != 0 && (depth < clipDepths.x || depth > clipDepths.y ||\n" \
  "                          any(lessThan(place, clipLow)) ||\n"                                   \
  "                          any(greaterThan(place, clipHigh)));\n"                                \
  "}\n"

namespace espalier {

/// @param hole   a ball in which nothing is drawn
/// @param origin of the scene
inline void setHole(vtkShaderProgram& program, const std::optional<Ball>& hole,
                    const Eigen::Vector3d& origin) {
  Eigen::Vector4f ball = Eigen::Vector4f::Zero();
  if (hole) ball << (hole->center - origin).cast<float>(), static_cast<float>(hole->radius);
  program.SetUniform4f("hole", ball.data());
}

inline void setClip(vtkShaderProgram& program, const ClipVolume& clip) {
  program.SetUniformi("clipped", clip.isAll() ? 0 : 1);
  program.SetUniform2f("clipDepths", clip.depths().data());
  program.SetUniform3f("clipLow", clip.low().data());
  program.SetUniform3f("clipHigh", clip.high().data());
}

} // namespace espalier
