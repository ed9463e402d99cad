#include "ui/view/skeleton_pass.h"

#include "ui/view/clip_shader.h"
#include "ui/view/focus_shader.h"
#include "ui/view/palette.h"
#include "ui/view/skeleton_shaders.h"
#include "ui/view/state_parts.h"

#include <vtkOpenGLState.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace espalier {
namespace {

static_assert(sizeof(NodeGlyph) == 24 && sizeof(EdgeGlyph) == 40, "the shaders read them");

void addAttribute(GLuint index, GLint count, GLenum type, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  // OpenGL takes offsets as pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto* place = reinterpret_cast<const void*>(offset);
  glVertexAttribPointer(index, count, type, GL_FALSE, static_cast<GLsizei>(stride), place);
}

/// Nearest and farthest depth of the skeleton [L].
Eigen::Vector2f depthsOf(const SkeletonGlyphs& skeleton, const DrawSettings& settings,
                         const Eigen::Vector3d& origin) {
  const Eigen::Vector3f middle = (skeleton.bounds().center() - origin).cast<float>();
  const Eigen::Vector3f half = (skeleton.bounds().sizes() / 2).cast<float>();
  const float depth = -(settings.toView * middle.homogeneous()).z();
  const float reach = settings.toView.row(2).head<3>().cwiseAbs().dot(half);
  return {depth - reach, depth + std::max(reach, 1e-6F * std::abs(depth) + 1e-30F)};
}

} // namespace

void SkeletonPass::draw(const DrawSettings& settings) {
  const bool isVisible = isReference_ ? scene_.referenceVisible : scene_.skeletonVisible;
  if (!isVisible || glyphs().nodes().empty()) return;
  upload();
  if (isReference_) return drawAll(settings, std::nullopt);
  for (const StatePart& part : stateParts(scene_, settings.divider)) {
    if (part.other != other_) continue;
    const OnlyIn only(part, settings);
    drawAll(settings, part.hole);
  }
}

void SkeletonPass::drawAll(const DrawSettings& settings, const std::optional<Ball>& hole) {
  vtkOpenGLState* state = settings.window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                                GL_ONE_MINUS_SRC_ALPHA);
  constexpr GLenum clipSides = 8;
  for (GLenum side = 0; side < clipSides && !settings.clip.isAll(); ++side)
    glEnable(GL_CLIP_DISTANCE0 + side); // of edges only: nodes are drawn or not
  drawEdges(settings, hole);
  for (GLenum side = 0; side < clipSides; ++side)
    glDisable(GL_CLIP_DISTANCE0 + side);
  if (scene_.showRadii && !isReference_) drawNodes(settings, hole, true);
  drawNodes(settings, hole, false);
  glBindVertexArray(0);
}

void SkeletonPass::upload() {
  if (other_)
    buffers_.uploadOther(scene_, *other_);
  else if (isReference_)
    buffers_.uploadReference(scene_);
  else
    buffers_.uploadSkeleton(scene_);
}

void SkeletonPass::setCommon(vtkShaderProgram& program, const DrawSettings& settings,
                             const std::optional<Ball>& hole, bool isSolid) const {
  program.SetUniformMatrix4x4("toView", const_cast<float*>(settings.toView.data()));
  program.SetUniformMatrix4x4("toClip", const_cast<float*>(settings.toClip.data()));
  const float half[2] = {settings.size.x() / 2, settings.size.y() / 2};
  program.SetUniform2f("halfScreen", half);
  program.SetUniformf("pixelRatio", settings.pixelRatio);
  program.SetUniformf("pixelSize", settings.pixelSize);
  program.SetUniformi("perspective", settings.perspective ? 1 : 0);
  const Palette colors = palette(scene_.dark);
  const Color& usual = other_ ? colors.contracted : colors.successor;
  const Color& successor = isReference_ ? colors.reference : usual;
  const Color& branching = isReference_ ? colors.reference : colors.branching;
  setColor(program, "successorColor", isSolid ? colors.solid : successor);
  setColor(program, "branchingColor", isSolid ? colors.solid : branching);
  program.SetUniformi("isReference", isReference_ ? 1 : 0);
  setColor(program, "selectedColor", colors.selected);
  setColor(program, "hoveredColor", colors.hovered);
  setColor(program, "outlineColor", colors.outline);
  setColor(program, "backgroundColor", colors.backgroundBottom);
  const Eigen::Vector2f depths = depthsOf(glyphs(), settings, scene_.origin());
  program.SetUniform2f("depths", depths.data());
  program.SetUniformf("roominess", roominess(settings));
  program.SetUniformf("depthFade", settings.depthFade);
  setClip(program, settings.clip);
  setFocus(program, settings.focus);
  setHole(program, hole, scene_.origin());
}

void SkeletonPass::drawEdges(const DrawSettings& settings, const std::optional<Ball>& hole) {
  using namespace shaders;
  const bool areFrusta = scene_.showRadii && !isReference_; // dots would not be seen on them
  vtkShaderProgram& program = readyProgram(*settings.window, areFrusta ? frustumVertex : lineVertex,
                                           areFrusta ? frustumFragment : lineFragment);
  setCommon(program, settings, hole, areFrusta);
  if (edgeArray_ == 0) glGenVertexArrays(1, &edgeArray_);
  glBindVertexArray(edgeArray_);
  buffers().edges.bind();
  const std::size_t stride = sizeof(EdgeGlyph);
  addAttribute(0, 4, GL_FLOAT, stride, offsetof(EdgeGlyph, parent));
  addAttribute(1, 4, GL_FLOAT, stride, offsetof(EdgeGlyph, child));
  addAttribute(2, 4, GL_UNSIGNED_BYTE, stride, offsetof(EdgeGlyph, shape));
  addAttribute(3, 4, GL_UNSIGNED_BYTE, stride, offsetof(EdgeGlyph, color));
  drawQuads(glyphs().edges().size());
}

void SkeletonPass::drawNodes(const DrawSettings& settings, const std::optional<Ball>& hole,
                             bool spheres) {
  using namespace shaders;
  vtkShaderProgram& program =
      readyProgram(*settings.window, nodeVertex, spheres ? sphereFragment : discFragment);
  setCommon(program, settings, hole, spheres);
  program.SetUniformi("spheres", spheres ? 1 : 0);
  program.SetUniformf("pushed", scene_.showRadii ? 1.1F : 0.0F);
  if (nodeArray_ == 0) glGenVertexArrays(1, &nodeArray_);
  glBindVertexArray(nodeArray_);
  buffers().nodes.bind();
  const std::size_t stride = sizeof(NodeGlyph);
  addAttribute(0, 4, GL_FLOAT, stride, offsetof(NodeGlyph, position));
  addAttribute(1, 4, GL_UNSIGNED_BYTE, stride, offsetof(NodeGlyph, shape));
  addAttribute(2, 4, GL_UNSIGNED_BYTE, stride, offsetof(NodeGlyph, color));
  drawQuads(glyphs().nodes().size());
}

void SkeletonPass::drawQuads(std::size_t count) {
  buffers_.quads(count).bindAsIndices();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count), GL_UNSIGNED_INT, nullptr);
}

float SkeletonPass::roominess(const DrawSettings& settings) const {
  constexpr float roomy = 16; // [logical pixels] between nodes
  const Eigen::Vector3d middle = glyphs().bounds().center() - scene_.origin();
  const float depth = -(settings.toView * middle.cast<float>().homogeneous()).z();
  const float pixel = settings.pixelSize * (settings.perspective ? std::max(depth, 0.0F) : 1.0F);
  const auto length = static_cast<float>(glyphs().typicalLength());
  const float spacing = length / std::max(pixel * settings.pixelRatio, 1e-30F);
  return length > 0 ? std::min(spacing / roomy, 1.0F) : 1;
}

void SkeletonPass::release() {
  for (GLuint* array : {&nodeArray_, &edgeArray_}) {
    if (*array != 0) glDeleteVertexArrays(1, array);
    *array = 0;
  }
}

} // namespace espalier
