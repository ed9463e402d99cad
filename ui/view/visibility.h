#pragma once

#include "ui/view/camera.h"
#include "ui/view/scene.h"
#include "ui/view/screen_part.h"

#include <QRectF>

#include <vector>

namespace espalier {

/// Finds what is hidden behind wood in a part of the screen: behind the points of the scan, and
/// behind the edges where these are drawn with their radius.
///
/// A node lies inside its own wood, whose front is nearer to the eye than the node: what is within
/// the reach of that wood hides nothing of it. Points are taken as wide as they are apart, so that
/// a surface seen from close by has no holes.
class Visibility {
public:
  /// Time O(points in the part), some 10 ns each. Keeps a reference to the scene.
  /// @param part of the screen that will be asked about [logical pixels]
  Visibility(const Scene& scene, const ScreenMap& screen, const QRectF& part);

  /// Is most of what stands for a node or edge on the screen, some pixels wide, hidden?
  [[nodiscard]] bool hidesNode(std::size_t slot, const ScreenMap::Place& at) const;
  [[nodiscard]] bool hidesEdge(const EdgeGlyph& edge, double fraction,
                               const ScreenMap::Place& at) const;
  /// Is there another point clearly in front of this one?
  [[nodiscard]] bool hidesPoint(const ScreenMap::Place& at) const;

private:
  void addPoints(const PointLayer& layer);
  void addFrusta(const SkeletonGlyphs& glyphs);
  void addFrustum(const EdgeGlyph& edge);
  void add(const ScreenPart::Place& at, int half); // covers 2 half + 1 cells each way
  [[nodiscard]] double nearest(const Eigen::Vector2d& pixel) const;
  [[nodiscard]] bool hides(const ScreenMap::Place& at, double reach) const;
  /// How far wood of this radius about `place` reaches toward the eye [L].
  [[nodiscard]] double reachOf(double radius, const Eigen::Vector3f& place,
                               const Eigen::Vector3f& axis) const;

  const Scene& scene_;
  const ScreenMap& screen_;
  ScreenPart part_;
  ClipVolume clip_;
  FocusDepths focus_; // what is drawn behind it hides nothing
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> depths_; // the least in each cell
};

} // namespace espalier
