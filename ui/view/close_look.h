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
  bool isOfOther = false; // than the plant, in its place: nothing of the plant stands before it

  [[nodiscard]] bool isEmpty() const { return nodes.empty() && places.empty(); }
};

/// From where a part of the plant is seen best: it fills the screen, nothing stands before it, and
/// its edges are seen at their full length rather than end on.
///
/// Some fifty directions are tried, from below to steeply above. Of those from which all that is
/// meant is seen, and most nodes around it, the one is taken that shows the edges longest and turns
/// the camera least; if there is none, the one from which most is seen.
/// @param now  keeps its projection
/// @param size of the screen [logical pixels]
/// pre: the sight is not empty, and the scene has its nodes
/// Time O(points on the screen) for each direction tried; mostly few are.
[[nodiscard]] Camera cameraToSee(const Scene& scene, const Camera& now, const Sight& sight,
                                 const QSizeF& size);

} // namespace espalier
