#include "ui/view/skeleton_pass.h"

#include "ui/view/palette.h"
#include "ui/view/skeleton_shaders.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <cstddef>

namespace espalier {
namespace {

static_assert(sizeof(NodeGlyph) == 20 && sizeof(EdgeGlyph) == 36, "the shaders read them");

/// An attribute that is the same at all four corners of a glyph.
void addAttribute(GLuint index, GLint count, GLenum type, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, type, GL_FALSE, static_cast<GLsizei>(stride),
                        static_cast<const char*>(nullptr) + offset);
  glVertexAttribDivisor(index, 1);
}

template <class Glyph>
void uploadChanges(GlBuffer& buffer, const std::vector<Glyph>& glyphs, const SlotRange& changed) {
  const std::size_t bytes = glyphs.size() * sizeof(Glyph);
  if (buffer.size() < bytes || buffer.size() > 2 * bytes + 4096) {
    // Room for nodes to come: adding one does not move all others.
    std::vector<Glyph> roomy(glyphs);
    roomy.resize(glyphs.size() + glyphs.size() / 4 + 64);
    buffer.upload(roomy.data(), roomy.size() * sizeof(Glyph));
  } else if (!changed.isEmpty()) {
    buffer.write(glyphs.data() + changed.begin, changed.begin * sizeof(Glyph),
                 (changed.end - changed.begin) * sizeof(Glyph));
  }
}

void setColor(vtkShaderProgram& program, const char* name, const Color& color) {
  const float values[3] = {color[0] / 255.0F, color[1] / 255.0F, color[2] / 255.0F};
  program.SetUniform3f(name, values);
}

} // namespace

void SkeletonPass::draw(const DrawSettings& settings) {
  if (!scene_.skeletonVisible || scene_.skeleton.nodes().empty()) return;
  upload();
  vtkOpenGLState* state = settings.window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE,
                                GL_ONE_MINUS_SRC_ALPHA);
  drawEdges(settings);
  if (scene_.showRadii) drawNodes(settings, true);
  drawNodes(settings, false);
  glBindVertexArray(0);
}

void SkeletonPass::upload() {
  uploadChanges(nodes_, scene_.skeleton.nodes(), scene_.skeleton.takeChangedNodes());
  uploadChanges(edges_, scene_.skeleton.edges(), scene_.skeleton.takeChangedEdges());
}

void SkeletonPass::setCommon(vtkShaderProgram& program, const DrawSettings& settings,
                             bool isSolid) const {
  program.SetUniformMatrix4x4("toView", const_cast<float*>(settings.toView.data()));
  program.SetUniformMatrix4x4("toClip", const_cast<float*>(settings.toClip.data()));
  const float half[2] = {settings.size.x() / 2, settings.size.y() / 2};
  program.SetUniform2f("halfScreen", half);
  program.SetUniformf("pixelRatio", settings.pixelRatio);
  program.SetUniformf("pixelSize", settings.pixelSize);
  program.SetUniformi("perspective", settings.perspective ? 1 : 0);
  const Palette colors = palette(scene_.dark);
  setColor(program, "successorColor", isSolid ? colors.solid : colors.successor);
  setColor(program, "branchingColor", isSolid ? colors.solid : colors.branching);
  setColor(program, "selectedColor", colors.selected);
  setColor(program, "hoveredColor", colors.hovered);
  setColor(program, "outlineColor", colors.outline);
}

void SkeletonPass::drawEdges(const DrawSettings& settings) {
  using namespace shaders;
  const bool tubes = scene_.showRadii;
  vtkShaderProgram& program = readyProgram(*settings.window, tubes ? tubeVertex : lineVertex,
                                           tubes ? tubeFragment : lineFragment);
  setCommon(program, settings, tubes);
  if (edgeArray_ == 0) glGenVertexArrays(1, &edgeArray_);
  glBindVertexArray(edgeArray_);
  edges_.bind();
  const std::size_t stride = sizeof(EdgeGlyph);
  addAttribute(0, 4, GL_FLOAT, stride, offsetof(EdgeGlyph, parent));
  addAttribute(1, 4, GL_FLOAT, stride, offsetof(EdgeGlyph, child));
  addAttribute(2, 4, GL_UNSIGNED_BYTE, stride, offsetof(EdgeGlyph, shape));
  const auto count = static_cast<GLsizei>(scene_.skeleton.edges().size());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

void SkeletonPass::drawNodes(const DrawSettings& settings, bool spheres) {
  using namespace shaders;
  vtkShaderProgram& program =
      readyProgram(*settings.window, nodeVertex, spheres ? sphereFragment : discFragment);
  setCommon(program, settings, spheres);
  program.SetUniformi("spheres", spheres ? 1 : 0);
  program.SetUniformf("scale", nodeScale(settings));
  program.SetUniformf("pushed", scene_.showRadii ? 1.1F : 0.0F);
  if (nodeArray_ == 0) glGenVertexArrays(1, &nodeArray_);
  glBindVertexArray(nodeArray_);
  nodes_.bind();
  const std::size_t stride = sizeof(NodeGlyph);
  addAttribute(0, 4, GL_FLOAT, stride, offsetof(NodeGlyph, position));
  addAttribute(1, 4, GL_UNSIGNED_BYTE, stride, offsetof(NodeGlyph, shape));
  const auto count = static_cast<GLsizei>(scene_.skeleton.nodes().size());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

float SkeletonPass::nodeScale(const DrawSettings& settings) const {
  // From far, discs of full size would hide the edges between them.
  constexpr float roomy = 16; // [logical pixels] between nodes
  const Eigen::Vector3d middle = scene_.skeleton.bounds().center() - scene_.origin();
  const float depth = -(settings.toView * middle.cast<float>().homogeneous()).z();
  const float pixel = settings.pixelSize * (settings.perspective ? std::max(depth, 0.0F) : 1.0F);
  const auto length = static_cast<float>(scene_.skeleton.typicalLength());
  const float spacing = length / std::max(pixel * settings.pixelRatio, 1e-30F);
  return length > 0 ? std::clamp(spacing / roomy, 0.5F, 1.0F) : 1;
}

void SkeletonPass::release() {
  nodes_.release();
  edges_.release();
  for (GLuint* array : {&nodeArray_, &edgeArray_}) {
    if (*array != 0) glDeleteVertexArrays(1, array);
    *array = 0;
  }
}

} // namespace espalier
