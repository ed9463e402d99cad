#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"
#include "ui/view/scene_buffers.h"

namespace espalier {

/// Draws the skeleton over what is there: as lines and discs of constant size, or with its radii.
class SkeletonPass {
public:
  SkeletonPass(Scene& scene, SceneBuffers& buffers) : scene_(scene), buffers_(buffers) {}

  void draw(const DrawSettings& settings);
  void release();

private:
  void drawEdges(const DrawSettings& settings);
  void drawNodes(const DrawSettings& settings, bool spheres);
  void drawQuads(std::size_t count); // of the vertex array that is bound
  void setCommon(vtkShaderProgram& program, const DrawSettings& settings, bool isSolid) const;
  /// How much room nodes have on the screen, in [0, 1]: from far, discs of full size would hide
  /// the edges between them.
  [[nodiscard]] float roominess(const DrawSettings& settings) const;

  Scene& scene_; // written only to take what changed
  SceneBuffers& buffers_;
  GLuint nodeArray_ = 0;
  GLuint edgeArray_ = 0;
};

} // namespace espalier
