#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"
#include "ui/view/scene_buffers.h"
#include "ui/view/state_parts.h"

#include <array>
#include <optional>

namespace espalier {

/// Draws the points: those of a still view into a picture of its own, which is kept, so that frames
/// that only change the skeleton draw no point, and which is completed over several frames.
///
/// Points are drawn in steps of the golden ratio through the cloud: since near points are near in
/// memory, every prefix of that order is an even sample of the plant.
class PointPass {
public:
  PointPass(const Scene& scene, SceneBuffers& buffers) : scene_(scene), buffers_(buffers) {}

  struct Result {
    bool changed;       // the picture is another than before
    bool complete;      // all points are in it
    Eigen::Index drawn; // points drawn by this call
  };
  /// @param atMost points to draw in this call
  Result draw(const DrawSettings& settings, Eigen::Index atMost);
  /// Draws an even part of the points, larger, over what the framebuffer that is bound shows: the
  /// next frame will be another. Returns how many. The picture is lost.
  Eigen::Index drawSample(const DrawSettings& settings, Eigen::Index atMost);

  [[nodiscard]] const GlPicture& picture() const { return picture_; }
  void release();

private:
  /// All that the picture depends on, but for how much of it is done.
  struct Key {
    Eigen::Matrix4f matrix;
    Eigen::Vector2f size;
    float pointSize;
    std::array<std::uint64_t, 13> states;
    Eigen::Matrix4d placement; // of the other scan
    ClipVolume clip;
    float depthFade;
    Eigen::Vector4f focus;
    double divider;
    double blend;
    bool operator==(const Key&) const = default;
  };

  [[nodiscard]] Key keyOf(const DrawSettings& settings, float pointSize) const;
  [[nodiscard]] Eigen::Index total(const DrawSettings& settings) const; // points that are shown
  /// Draws as many more of all into the framebuffer that is bound; returns how many.
  Eigen::Index drawMore(const DrawSettings& settings, float pointSize, Eigen::Index all,
                        Eigen::Index atMost);
  /// Draws what is missing up to a part of each layer.
  void drawLayers(const DrawSettings& settings, float pointSize, double until);
  /// A layer as it is drawn by one call.
  struct Drawn {
    const DrawnPoints& points;
    const SceneBuffers::Points& buffers;
    double spacing = 0;                // [L]: near points are drawn that wide; 0: all alike
    const GlBuffer* scanned = nullptr; // where the points come from; null: nothing moves
    const GlBuffer* colors = nullptr;  // null: the accent
    std::optional<Ball> hole;
    std::optional<Color> color; // of all of them; none: as `colors` say
    bool isBehind = false;      // all others, and paler
    bool isPreview = false;     // paler than its lines
    std::optional<Eigen::Isometry3d> placement = std::nullopt; // to those of the cloud
  };
  [[nodiscard]] Drawn pointsOf(const std::optional<Ball>& hole) const; // of the cloud
  void drawLayer(const DrawSettings& settings, const Drawn& layer, float pointSize, double until);
  void drawMoved(const DrawSettings& settings, float pointSize, double until);
  /// What contracted points show in a part of the screen.
  void drawPart(const DrawSettings& settings, const StatePart& part, float pointSize, double until);
  void drawDisplacements(const DrawSettings& settings, const Drawn& layer);
  /// Makes the program ready, but for what its vertices are.
  void prepare(const DrawSettings& settings, const Drawn& layer, float pointSize);

  const Scene& scene_;
  SceneBuffers& buffers_;
  GLuint vertexArray_ = 0;
  GlPicture picture_;
  std::optional<Key> key_;
  double drawn_ = 0; // part of each layer that is in the picture, in [0, 1]
};

} // namespace espalier
