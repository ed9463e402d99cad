#include "ui/view/point_pass.h"

#include "ui/view/clip_shader.h"
#include "ui/view/focus_shader.h"
#include "ui/view/palette.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr const char* vertexShader = "#version 330 core\n" ESPALIER_CLIP ESPALIER_FOCUS R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color; // alpha 0: hidden
layout(location = 2) in vec3 scanned;
uniform float blend;          // how far from there to the position
uniform mat4 placement;       // to the frame of the scene
uniform vec4 tint;            // a color, and how much of it there is in that of each point
uniform mat4 toClip;
uniform vec4 toDepth;
uniform vec2 depths;          // of the plant, nearest and farthest
uniform float depthFade;
uniform vec3 backgroundColor;
uniform vec4 sizes;           // [device pixels] least and most; of a point at depth 1, and anywhere
flat out vec3 pointColor;
void main() {
  vec3 place = (placement * vec4(mix(scanned, position, blend), 1.0)).xyz;
  float depth = dot(toDepth, vec4(place, 1.0));
  gl_Position = color.a < 0.5 || isClipped(place, depth) ? vec4(2.0, 2.0, 2.0, 1.0)
                                                         : behindFocus(toClip * vec4(place, 1.0), depth);
  float own = sizes.z > 0.0 ? sizes.z / max(depth, 1e-30) : sizes.w;
  gl_PointSize = clamp(round(own * (1.0 - outOfFocus(depth))), sizes.x, sizes.y);
  float part = clamp((depth - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  float paleness = max(depthFade * part, outOfFocus(depth));
  pointColor = mix(mix(color.rgb, tint.rgb, tint.a), backgroundColor, 0.92 * paleness);
})";

constexpr const char* squareShader = R"(#version 330 core
flat in vec3 pointColor;
out vec4 fragment;
void main() { fragment = vec4(pointColor, 1.0); })";

// Apart from the square one, because discarding costs the early depth test.
constexpr const char* roundShader = R"(#version 330 core
flat in vec3 pointColor;
out vec4 fragment;
void main() {
  vec2 offset = gl_PointCoord - 0.5;
  if (dot(offset, offset) > 0.25) discard;
  fragment = vec4(pointColor, 1.0);
})";

/// Nearest and farthest depth of a scene [L].
Eigen::Vector2f depthsOf(const Scene& scene, const Eigen::Vector4f& toDepth) {
  const Eigen::AlignedBox3d bounds = scene.bounds();
  const Eigen::Vector3f middle = (bounds.center() - scene.origin()).cast<float>();
  const Eigen::Vector3f half = (bounds.sizes() / 2).cast<float>();
  const float depth = toDepth.dot(middle.homogeneous());
  const float reach = std::max(toDepth.head<3>().cwiseAbs().dot(half), 1e-30F);
  return {depth - reach, depth + reach};
}

/// Has an attribute read places from a buffer.
void readPlaces(GLuint attribute, const GlBuffer& buffer) {
  buffer.bind();
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void setPointColor(const Color& color) {
  glDisableVertexAttribArray(1);
  glVertexAttrib4Nub(1, color[0], color[1], color[2], 255);
}

Eigen::Vector3f unitColor(const Color& color) {
  return Eigen::Vector3f(color[0], color[1], color[2]) / 255.0F;
}

/// How large points are, by their depth.
struct PointSizes {
  float least = 1, most = 1; // [device pixels]
  float atDepthOne = 0;      // in perspective; else
  float anywhere = 0;

  [[nodiscard]] float at(float depth) const {
    const float own = atDepthOne > 0 ? atDepthOne / std::max(depth, 1e-30F) : anywhere;
    return std::clamp(own, least, most);
  }
};

/// `pointSize` as far off as all of the plant fits the screen, and farther; nearer points are as
/// much wider as they are nearer, up to how far they are apart: so that near wood looks solid.
/// @param spacing of points [L]; 0: all are alike
PointSizes sizesOf(const Scene& scene, const DrawSettings& settings, float pointSize,
                   double spacing) {
  constexpr float largest = 8; // [logical pixels]
  const float larger = pointSize / (static_cast<float>(scene.pointSize) * settings.pixelRatio);
  const Eigen::AlignedBox3d box = scene.bounds();
  const float whole = box.isEmpty() ? 0 : static_cast<float>(box.diagonal().norm());
  const float width = std::min(static_cast<float>(spacing) / settings.pixelSize * larger,
                               pointSize * whole / (settings.pixelSize * settings.size.y()));
  return {.least = pointSize,
          .most = std::max(pointSize, largest * settings.pixelRatio),
          .atDepthOne = settings.perspective ? width : 0,
          .anywhere = settings.perspective ? 0 : width};
}

double partOf(Eigen::Index all, Eigen::Index atMost) {
  return all > atMost ? static_cast<double>(atMost) / static_cast<double>(all) : 1;
}

/// Points are as many pixels larger as fewer of them are drawn: the plant keeps its body.
float sizeFor(const Scene& scene, const DrawSettings& settings, double part) {
  const auto size = static_cast<float>(scene.pointSize) * settings.pixelRatio;
  return std::round(size * static_cast<float>(std::clamp(std::pow(part, -0.25), 1.0, 2.0)));
}

} // namespace

PointPass::Key PointPass::keyOf(const DrawSettings& settings, float pointSize) const {
  const auto shown = [](const OtherState& other) {
    return (other.isShown ? 1U : 0U) + (other.replacesPoints ? 2U : 0U);
  };
  return {settings.toClip * settings.toView,
          settings.size,
          pointSize,
          {scene_.points.revision, scene_.colorRevision, scene_.contracted.revision,
           scene_.points.visible ? 1U : 0U, scene_.contracted.visible ? 1U : 0U,
           scene_.other(Side::left).contracted.revision, shown(scene_.other(Side::left)),
           scene_.other(Side::right).contracted.revision, shown(scene_.other(Side::right)),
           scene_.displacementsShown ? 1U : 0U, scene_.moved.revision, scene_.moved.colorRevision,
           static_cast<std::uint64_t>(scene_.moved.shown.foreground)},
          scene_.moved.shown.motion.matrix(),
          settings.clip,
          settings.depthFade,
          settings.focus,
          settings.divider,
          scene_.blend.value_or(-1)};
}

Eigen::Index PointPass::total(const DrawSettings& settings) const {
  Eigen::Index count = scene_.moved.size() + (scene_.points.visible ? scene_.points.size() : 0);
  const bool areContracted = scene_.contracted.visible || scene_.blend;
  for (const StatePart& part : stateParts(scene_, settings.divider)) {
    const OtherState* other = part.other ? &scene_.other(*part.other) : nullptr;
    if (areContracted || (other != nullptr && other->replacesPoints))
      count += other != nullptr ? other->contracted.size() : scene_.contracted.size();
  }
  return count;
}

PointPass::Result PointPass::draw(const DrawSettings& settings, Eigen::Index atMost) {
  buffers_.uploadPoints(scene_);
  const Eigen::Index all = total(settings);
  const float pointSize = sizeFor(scene_, settings, 1);
  const bool isNew = picture_.resize(static_cast<int>(settings.size.x()),
                                     static_cast<int>(settings.size.y()), true);
  const Key key = keyOf(settings, pointSize);
  const bool restart = isNew || !key_ || !(*key_ == key);
  if (!restart && drawn_ >= 1) return {false, true, 0};
  key_ = key;

  vtkOpenGLState& state = *settings.window->GetState();
  const Onto onPicture(state, picture_.framebuffer());
  if (restart) {
    drawn_ = 0;
    state.vtkglDepthMask(GL_TRUE);
    state.vtkglClearColor(0, 0, 0, 0);
    state.vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  const Eigen::Index drawn = drawMore(settings, pointSize, all, atMost);
  return {true, drawn_ >= 1, drawn};
}

Eigen::Index PointPass::drawSample(const DrawSettings& settings, Eigen::Index atMost) {
  buffers_.uploadPoints(scene_);
  const Eigen::Index all = total(settings);
  key_.reset();
  drawn_ = 0;
  return drawMore(settings, sizeFor(scene_, settings, partOf(all, atMost)), all, atMost);
}

Eigen::Index PointPass::drawMore(const DrawSettings& settings, float pointSize, Eigen::Index all,
                                 Eigen::Index atMost) {
  vtkOpenGLState& state = *settings.window->GetState();
  state.vtkglDisable(GL_BLEND);
  state.vtkglEnable(GL_DEPTH_TEST);
  state.vtkglDepthMask(GL_TRUE);
  state.vtkglDepthFunc(GL_LEQUAL);
  const double until = std::min(1.0, drawn_ + partOf(all, atMost));
  drawLayers(settings, pointSize, until);
  return static_cast<Eigen::Index>((until - std::exchange(drawn_, until)) *
                                   static_cast<double>(all));
}

void PointPass::drawLayers(const DrawSettings& settings, float pointSize, double until) {
  if (scene_.points.visible && !scene_.blend) {
    for (const StatePart& part : pointParts(scene_, settings.divider)) {
      const OnlyIn only(part, settings);
      drawLayer(settings, pointsOf(part.hole), pointSize, until);
    }
  }
  for (const StatePart& part : stateParts(scene_, settings.divider))
    drawPart(settings, part, pointSize, until);
  if (scene_.moved.isShown()) drawMoved(settings, pointSize, until);
}

void PointPass::drawMoved(const DrawSettings& settings, float pointSize, double until) {
  const SceneBuffers::Points& buffers = buffers_.moved();
  const bool isByValue = buffers.colors.size() > 0;
  Drawn drawn{.points = scene_.moved,
              .buffers = buffers,
              .colors = isByValue ? &buffers.colors : nullptr,
              .hole = {},
              .color = {},
              .isBehind = scene_.moved.isBehind(),
              .placement = scene_.movedPlacement()};
  if (!isByValue) drawn.color = palette(scene_.dark).movedScan;
  drawLayer(settings, drawn, pointSize, until);
}

PointPass::Drawn PointPass::pointsOf(const std::optional<Ball>& hole) const {
  const SceneBuffers::Points& cloud = buffers_.cloud();
  Drawn drawn{.points = scene_.points,
              .buffers = cloud,
              .spacing = scene_.points.spacing,
              .colors = &cloud.colors,
              .hole = hole,
              .color = {},
              .isBehind = scene_.moved.isShown() && scene_.moved.hidesFixed()};
  if (scene_.moved.isShown()) drawn.color = palette(scene_.dark).fixedScan;
  return drawn;
}

void PointPass::drawPart(const DrawSettings& settings, const StatePart& part, float pointSize,
                         double until) {
  const DrawnPoints& points = part.other ? scene_.other(*part.other).contracted : scene_.contracted;
  const OnlyIn only(part, settings);
  if (points.size() == 0) { // nothing has been contracted: what travels is still where it was
    if (scene_.blend && scene_.points.visible)
      drawLayer(settings, pointsOf(part.hole), pointSize, until);
    return;
  }
  const SceneBuffers::Points& buffers = buffers_.contracted(part.other);
  const bool isWhole = points.size() == scene_.points.size();
  const GlBuffer* own = buffers.scanned.size() > 0 ? &buffers.scanned : nullptr;
  const bool replacesPoints =
      scene_.blend || (part.other && scene_.other(*part.other).replacesPoints);
  const GlBuffer* looks = nullptr;              // the accent
  const bool isKept = part.other == Side::left; // values are of what is on the right
  if (scene_.blend || (replacesPoints && scene_.pointValues && !isKept))
    looks = &buffers_.cloud().colors;
  else if (isWhole)
    looks = &buffers_.contracted(std::nullopt).colors; // the same points
  if (!isWhole) looks = &buffers.colors;
  if (looks != nullptr && looks->size() == 0) looks = nullptr;
  const Drawn drawn{.points = points,
                    .buffers = buffers,
                    .scanned = own == nullptr && isWhole ? &buffers_.cloud().positions : own,
                    .colors = looks,
                    .hole = part.hole,
                    .color = {},
                    .isPreview = replacesPoints && !scene_.blend && !scene_.pointValues &&
                                 !scene_.pointStates}; // whose colors mean something
  const bool isShown = scene_.contracted.visible || replacesPoints;
  if (isShown) drawLayer(settings, drawn, pointSize, until);
  if (scene_.displacementsShown && drawn_ == 0) drawDisplacements(settings, drawn);
}

void PointPass::prepare(const DrawSettings& settings, const Drawn& layer, float pointSize) {
  const Eigen::Vector4f toDepth = -settings.toView.row(2).transpose();
  const Eigen::Vector2f depths = depthsOf(scene_, toDepth);
  const PointSizes sizes = sizesOf(scene_, settings, pointSize, layer.spacing);
  const bool isRound = sizes.at(depths.x()) >= 4;
  vtkShaderProgram& program =
      readyProgram(*settings.window, vertexShader, isRound ? roundShader : squareShader);
  const Eigen::Matrix4f matrix = settings.toClip * settings.toView;
  program.SetUniformMatrix4x4("toClip", const_cast<float*>(matrix.data()));
  setClip(program, settings.clip);
  setHole(program, layer.hole, scene_.origin());
  program.SetUniform4f("toDepth", toDepth.data());
  const float asUniform[] = {sizes.least, sizes.most, sizes.atDepthOne, sizes.anywhere};
  program.SetUniform4f("sizes", asUniform);
  setFocus(program, settings.focus);
  program.SetUniform2f("depths", depths.data());
  program.SetUniformf("depthFade", settings.depthFade);
  const bool travels = scene_.blend && layer.scanned != nullptr;
  program.SetUniformf("blend", travels ? static_cast<float>(*scene_.blend) : 1);
  const Color& background = palette(scene_.dark).backgroundBottom;
  const Eigen::Vector3f faded = unitColor(background);
  program.SetUniform3f("backgroundColor", faded.data());
  const Eigen::Matrix4f placement =
      layer.placement.value_or(Eigen::Isometry3d::Identity()).matrix().cast<float>();
  program.SetUniformMatrix4x4("placement", const_cast<float*>(placement.data()));
  Eigen::Vector4f tint = Eigen::Vector4f::Zero();
  constexpr float paleness = 0.78F; // of what is behind
  if (layer.color) tint << unitColor(*layer.color), 1;
  if (layer.isPreview) tint << faded, 0.5F; // its lines are in the accent, too
  if (layer.isBehind) {
    const Eigen::Vector3f own = layer.color ? unitColor(*layer.color) : faded;
    tint << (1 - paleness) * own + paleness * faded, layer.color ? 1 : paleness;
  }
  program.SetUniform4f("tint", tint.data());
  if (vertexArray_ == 0) glGenVertexArrays(1, &vertexArray_);
  glBindVertexArray(vertexArray_);
}

void PointPass::drawLayer(const DrawSettings& settings, const Drawn& layer, float pointSize,
                          double until) {
  const auto count = static_cast<double>(layer.points.size());
  const auto first = static_cast<GLint>(std::llround(drawn_ * count));
  const auto last = static_cast<GLint>(std::llround(until * count));
  if (first == last) return;
  prepare(settings, layer, pointSize);
  readPlaces(0, layer.buffers.positions);
  readPlaces(2, layer.scanned != nullptr ? *layer.scanned : layer.buffers.positions);
  if (layer.colors != nullptr) {
    layer.colors->bind();
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr);
  } else {
    setPointColor(palette(scene_.dark).contracted);
  }
  glEnable(GL_PROGRAM_POINT_SIZE);
  constexpr double back = 0.99; // of the depth that there is
  if (layer.isBehind) glDepthRange(back, 1);
  glDrawArrays(GL_POINTS, first, last - first);
  if (layer.isBehind) glDepthRange(0, 1);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glBindVertexArray(0);
}

void PointPass::drawDisplacements(const DrawSettings& settings, const Drawn& layer) {
  const GlBuffer& lines = layer.buffers.displacements;
  if (lines.size() == 0) return;
  prepare(settings,
          {.points = layer.points, .buffers = layer.buffers, .hole = layer.hole, .color = {}}, 1);
  readPlaces(0, lines);
  readPlaces(2, lines);
  setPointColor(palette(scene_.dark).reference);
  glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(lines.size() / (3 * sizeof(float))));
  glBindVertexArray(0);
}

void PointPass::release() {
  if (vertexArray_ != 0) glDeleteVertexArrays(1, &vertexArray_);
  vertexArray_ = 0;
  picture_.release();
  key_.reset();
}

} // namespace espalier
