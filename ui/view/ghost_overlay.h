#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/camera.h"

#include <Eigen/Core>
#include <QPainter>
#include <QString>

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

/// Paints ghosts over the plant: dots bright, below lines; of these, the present with a full one,
/// what is not there dashed, where one would go a cross, each with its number. Numbers keep apart.
void paintGhosts(QPainter& painter, const std::vector<ShownGhost>& ghosts, const ScreenMap& screen,
                 bool dark);

/// The color of the ghost of a number, distinct to the color-blind on both backgrounds.
[[nodiscard]] Color colorOfGhost(int number, bool dark);

} // namespace espalier
