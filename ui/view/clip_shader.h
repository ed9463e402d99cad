#pragma once

#include "ui/view/gl_objects.h"

/// What shaders ask of a ClipVolume, and how far a depth is faded; to be put before their main().
#define ESPALIER_CLIP                                                                              \
  "uniform int clipped;\n"                                                                         \
  "uniform vec2 clipDepths;\n"                                                                     \
  "uniform vec3 clipLow;\n"                                                                        \
  "uniform vec3 clipHigh;\n"                                                                       \
  "bool isClipped(vec3 place, float depth) {\n"                                                    \
  "  return clipped != 0 && (depth < clipDepths.x || depth > clipDepths.y ||\n"                    \
  "                          any(lessThan(place, clipLow)) ||\n"                                   \
  "                          any(greaterThan(place, clipHigh)));\n"                                \
  "}\n"

namespace espalier {

inline void setClip(vtkShaderProgram& program, const ClipVolume& clip) {
  program.SetUniformi("clipped", clip.isAll() ? 0 : 1);
  program.SetUniform2f("clipDepths", clip.depths().data());
  program.SetUniform3f("clipLow", clip.low().data());
  program.SetUniform3f("clipHigh", clip.high().data());
}

} // namespace espalier
