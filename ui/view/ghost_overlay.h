#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/camera.h"

#include <Eigen/Core>
#include <QPainter>
#include <QPointF>

#include <vector>

namespace espalier {

/// What a place of the plant may be like, drawn over it. Places in the frame of the file [L].
struct ShownGhost {
  enum class Look : std::uint8_t {
    present,  // as the plant is
    proposed, // as it is not
    removed   // what would go
  };
  std::vector<std::vector<Eigen::Vector3d>> lines; // a line of one place is a dot, as of a point
  Look look = Look::proposed;
  int number = 0; // its key, and its color; 0: neither label nor a color of its own
};

/// Where a number stands, and what it names [logical pixels].
struct GhostNumber {
  static constexpr double radius = 11; // of its disk

  int number;
  QPointF at; // its middle
  QPointF of; // on the line, or the cross, of its ghost
};

/// The number of each ghost that has one and is seen: beside its longest line, or its cross, where
/// it covers as little of any line as can be, and no other number.
[[nodiscard]] std::vector<GhostNumber> numbersOf(const std::vector<ShownGhost>& ghosts,
                                                 const ScreenMap& screen);

/// Paints ghosts over the plant: dots bright, below lines; of these, the present with a full one,
/// what is not there dashed, where one would go a cross, each with its number.
/// Short lines lie over long ones.
void paintGhosts(QPainter& painter, const std::vector<ShownGhost>& ghosts, const ScreenMap& screen,
                 bool dark);

/// The color of the ghost of a number, distinct to the color-blind on both backgrounds.
[[nodiscard]] Color colorOfGhost(int number, bool dark);

} // namespace espalier
