#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/palette.h"

namespace espalier {

/// Puts the picture of the points on the background, their relief shown by eye-dome lighting, or
/// draws the background alone.
///
/// A point is darkened by how far its neighbors on the screen stand out before it, counted in
/// widths of a pixel: so the relief looks the same from near and far, and in any unit.
/// Source: C. Boucheny, "Interactive scientific visualization of large datasets: towards a
/// perceptive-based approach", PhD thesis, 2009. Differs: linear depths, and their bound.
class ShadePass {
public:
  // Both fill the framebuffer that is bound.
  void drawBackground(const DrawSettings& settings, const Palette& palette);
  /// @param relief  false: no shading
  void draw(const DrawSettings& settings, const GlPicture& points, const Palette& palette,
            bool relief);
  void release();

private:
  vtkShaderProgram& prepare(const DrawSettings& settings, const Palette& palette,
                            const char* fragmentShader);
  void fill();

  GLuint vertexArray_ = 0;
};

} // namespace espalier
