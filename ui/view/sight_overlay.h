#pragma once

#include "ui/view/camera.h"

#include <Eigen/Core>
#include <QPainter>
#include <QStringList>

#include <optional>
#include <vector>

namespace espalier {

/// What a method sees at a point, as it is drawn. Places in the frame of the file [L].
struct ShownSight {
  struct Circle {
    Eigen::Vector3d center;
    Eigen::Vector3d normal; // unit
    double radius;
  };
  struct Cone {
    Eigen::Vector3d apex;
    Eigen::Vector3d direction; // unit
    double angle;              // full opening [rad]
    double length;
  };
  std::optional<Eigen::Vector3d> point;                // none: there is only the key
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();     // where it goes
  std::vector<Eigen::Vector3d> neighbors;              // linked to it
  std::vector<Eigen::Vector3d> ball;                   // what its new place is from
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); // unit, of either sign; zero: not known
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    // likewise
  double reach = 0;                                    // of the lines for these
  std::optional<Circle> circle;
  std::vector<Cone> cones;
  QStringList lines; // beside the key, a line each
};

/// Paints it over the plant.
void paintSight(QPainter& painter, const ShownSight& sight, const ScreenMap& screen, bool dark);

/// Paints the lines about it, and what its colors stand for, at the top left of a view.
void paintSightKey(QPainter& painter, const ShownSight& sight, bool dark);

} // namespace espalier
