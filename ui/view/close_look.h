#pragma once

#include "core/skeleton/skeleton.h"
#include "ui/view/camera.h"

#include <Eigen/Core>
#include <QSizeF>

#include <vector>

namespace espalier {

struct Scene;

/// What is to be looked at closely.
struct Sight {
  std::vector<NodeId> nodes;                // with the edges to their parents
  std::vector<Eigen::Vector3d> places = {}; // on the points of the scan [L]
  double margin = 0;                        // [L] that is shown around all of it
  /// Lines, one for each of several choices, that are to be seen apart [L].
  std::vector<std::vector<Eigen::Vector3d>> apart = {};
  bool isOfOther = false; // than the plant, in its place: nothing of the plant stands before it

  [[nodiscard]] bool isEmpty() const { return nodes.empty() && places.empty(); }
  bool operator==(const Sight&) const = default;
};

/// From where a part of the plant is seen best: it fills the screen, nothing stands before it, and
/// its edges are seen at their full length rather than end on.
///
/// Some hundred directions are tried, from below to steeply above. The one is taken from which most
/// of what is meant is seen, and lines that are to be seen apart lie farthest apart on the screen,
/// then most nodes around it; of those that are alike, the one that shows the edges longest and
/// turns the camera least. What hides something is taken from a SightGrid:
/// points as wide as they are apart, and wood that is drawn with its radius.
/// @param now  keeps its projection
/// @param size of the screen [logical pixels]
/// pre: the sight is not empty, and the scene has its nodes
/// Deterministic. Time O(points between it and the eye), once.
[[nodiscard]] Camera cameraToSee(const Scene& scene, const Camera& now, const Sight& sight,
                                 const QSizeF& size);

} // namespace espalier
