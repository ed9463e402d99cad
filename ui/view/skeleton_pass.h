#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"

namespace espalier {

/// Draws the skeleton over what is there: as lines and discs of constant size, or with its radii.
///
/// Uploads the slots that changed since the last frame, no others.
class SkeletonPass {
public:
  explicit SkeletonPass(Scene& scene) : scene_(scene) {}

  void draw(const DrawSettings& settings);
  void release();

private:
  void upload();
  void drawEdges(const DrawSettings& settings);
  void drawNodes(const DrawSettings& settings, bool spheres);
  void drawQuads(std::size_t count); // of the vertex array that is bound
  void setCommon(vtkShaderProgram& program, const DrawSettings& settings, bool isSolid) const;
  /// How much room nodes have on the screen, in [0, 1]: from far, discs of full size would hide
  /// the edges between them.
  [[nodiscard]] float roominess(const DrawSettings& settings) const;

  Scene& scene_; // written only to take what changed
  GlBuffer nodes_;
  GlBuffer edges_;
  GlBuffer quads_; // which corners make the triangles of a glyph
  GLuint nodeArray_ = 0;
  GLuint edgeArray_ = 0;
};

} // namespace espalier
