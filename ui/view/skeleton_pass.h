#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"
#include "ui/view/scene_buffers.h"

#include <cstdint>
#include <optional>

namespace espalier {

/// Draws a skeleton over what is there: as lines and discs of constant size, or with its radii. The
/// reference is dotted, and only those of its nodes that are marked are drawn. That of another
/// state of the plant, on its side of the divider, is of the accent.
class SkeletonPass {
public:
  enum class What : std::uint8_t { skeleton, reference };
  SkeletonPass(Scene& scene, SceneBuffers& buffers, What what)
      : scene_(scene), buffers_(buffers), isReference_(what == What::reference) {}
  SkeletonPass(Scene& scene, SceneBuffers& buffers, Side other)
      : scene_(scene), buffers_(buffers), other_(other) {}

  void draw(const DrawSettings& settings);
  void release();

private:
  void upload();
  void drawAll(const DrawSettings& settings, const std::optional<Ball>& hole);
  void drawEdges(const DrawSettings& settings, const std::optional<Ball>& hole);
  void drawNodes(const DrawSettings& settings, const std::optional<Ball>& hole, bool spheres);
  void drawQuads(std::size_t count); // of the vertex array that is bound
  void setCommon(vtkShaderProgram& program, const DrawSettings& settings,
                 const std::optional<Ball>& hole, bool isSolid) const;
  /// How much room nodes have on the screen, in [0, 1]: from far, discs of full size would hide
  /// the edges between them.
  [[nodiscard]] const SkeletonGlyphs& glyphs() const {
    if (other_) return scene_.other(*other_).skeleton;
    return isReference_ ? scene_.reference : scene_.skeleton;
  }
  [[nodiscard]] const SceneBuffers::Glyphs& buffers() const {
    if (other_) return buffers_.skeleton(*other_);
    return isReference_ ? buffers_.reference() : buffers_.skeleton();
  }
  [[nodiscard]] float roominess(const DrawSettings& settings) const;

  Scene& scene_; // written only to take what changed
  SceneBuffers& buffers_;
  bool isReference_ = false;
  std::optional<Side> other_; // a state there; none: not one
  GLuint nodeArray_ = 0;
  GLuint edgeArray_ = 0;
};

} // namespace espalier
