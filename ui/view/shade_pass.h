#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/palette.h"

namespace espalier {

/// Puts the picture of the points on the background, their relief shown by eye-dome lighting.
///
/// A point is darkened by how far its neighbors on the screen stand out before it, counted in
/// widths of a pixel: so the relief looks the same from near and far, and in any unit.
/// Source: C. Boucheny, "Interactive scientific visualization of large datasets: towards a
/// perceptive-based approach", PhD thesis, 2009. Differs: linear depths, and their bound.
class ShadePass {
public:
  /// Shades anew, into a picture that is kept.
  /// @param relief  false: no shading
  void shade(const DrawSettings& settings, const GlPicture& points, const Palette& palette,
             bool relief);

  /// Copies the shaded picture into the framebuffer that is bound, and with `withDepth` the depths
  /// of the points, to hide what is behind them.
  void copy(const DrawSettings& settings, const GlPicture& points, bool withDepth);
  void release();

private:
  void fill();

  GLuint vertexArray_ = 0;
  GlPicture shaded_;
};

} // namespace espalier
