#include "ui/view/in_view.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

/// Looks at places one by one, until one is seen.
class Looking {
public:
  Looking(const Scene& scene, const ScreenMap& screen)
      : toScreen_(screen.toScreen(scene.origin()).cast<float>()),
        half_((screen.size() / 2).cast<float>()), isPerspective_(screen.isPerspective()),
        clip_(scene.clipVolume(screen.camera())) {}

  /// @param place about the origin of the scene
  /// @return whether it is seen
  bool sees(const Eigen::Vector3f& place, bool isShown) {
    const std::optional<Eigen::Vector2f> at = pixelOf(place);
    if (!at || (at->cwiseAbs().array() > half_.array()).any()) return false;
    const bool isClipped = !clip_.contains(place);
    isClipped_ = isClipped_ || (isShown && isClipped);
    isHidden_ = isHidden_ || !isShown;
    return isShown && !isClipped;
  }
  /// The same of a line, whose ends may be beside the screen.
  bool sees(const Eigen::Vector3f& from, const Eigen::Vector3f& to, bool isShown) {
    const std::optional<Eigen::Vector2f> a = pixelOf(from);
    const std::optional<Eigen::Vector2f> b = pixelOf(to);
    if (!a || !b) return sees((from + to) / 2, isShown);
    float begin = 0; // shares of the line that are on the screen
    float end = 1;
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      for (const float side : {-1.0F, 1.0F}) {
        const float outside = side * (*a)[axis] - half_[axis];
        const float change = side * ((*b)[axis] - (*a)[axis]);
        if (change == 0 && outside > 0) return false;
        if (change > 0) end = std::min(end, -outside / change);
        if (change < 0) begin = std::max(begin, -outside / change);
      }
    if (begin > end) return false;
    const float share = (begin + end) / 2;
    return sees(from + share * (to - from), isShown);
  }
  /// pre: nothing was seen
  [[nodiscard]] InView why() const {
    return isClipped_ ? InView::clipped : isHidden_ ? InView::hidden : InView::beside;
  }

private:
  /// From the middle of the screen; none behind the eye.
  [[nodiscard]] std::optional<Eigen::Vector2f> pixelOf(const Eigen::Vector3f& place) const {
    const Eigen::Vector3f at = toScreen_.leftCols<3>() * place + toScreen_.col(3);
    if (at.z() <= 0) return std::nullopt;
    return at.head<2>() / (isPerspective_ ? at.z() : 1);
  }

  Eigen::Matrix<float, 3, 4> toScreen_;
  Eigen::Vector2f half_; // of the screen
  bool isPerspective_;
  ClipVolume clip_;
  bool isClipped_ = false; // something in sight is
  bool isHidden_ = false;
};

bool hasNodes(const SkeletonGlyphs& glyphs) {
  return !glyphs.bounds().isEmpty();
}

} // namespace

InView inView(const Scene& scene, const ScreenMap& screen) {
  constexpr Eigen::Index most = 1'000'000; // points
  const bool isOther = std::ranges::any_of(scene.others, &OtherState::isShown);
  if (scene.bounds().isEmpty() || isOther || scene.moved.isShown()) return InView::plant;
  const bool showsPoints = scene.points.visible && scene.points.size() > 0;
  const bool showsContracted = scene.contracted.visible && scene.contracted.size() > 0;
  const bool showsNodes = scene.skeletonVisible && hasNodes(scene.skeleton);
  const bool showsReference = scene.referenceVisible && hasNodes(scene.reference);
  if (!showsPoints && !showsContracted && !showsNodes && !showsReference) return InView::layersOff;
  Looking looking(scene, screen);
  for (const SkeletonGlyphs* glyphs : {&scene.skeleton, &scene.reference}) {
    if (!(glyphs == &scene.skeleton ? showsNodes : showsReference)) continue;
    const Eigen::Vector3f shift = (glyphs->origin() - scene.origin()).cast<float>();
    for (const NodeGlyph& node : glyphs->nodes())
      if (looking.sees(Eigen::Vector3f(node.position.data()) + shift,
                       node.shape != NodeShape::none))
        return InView::plant;
    for (const EdgeGlyph& edge : glyphs->edges())
      if (edge.shape != EdgeShape::none &&
          looking.sees(Eigen::Vector3f(edge.parent.data()) + shift,
                       Eigen::Vector3f(edge.child.data()) + shift, true))
        return InView::plant;
  }
  const auto seesLayer = [&](const PointLayer& layer) {
    for (Eigen::Index i = 0; i < layer.size(); i += 1 + layer.size() / most)
      if (looking.sees(layer.positions->col(i), &layer == &scene.points
                                                    ? scene.isPointShown(i)
                                                    : scene.isContractedShown(i)))
        return true;
    return false;
  };
  if ((showsPoints && seesLayer(scene.points)) || (showsContracted && seesLayer(scene.contracted)))
    return InView::plant;
  return looking.why();
}

} // namespace espalier
