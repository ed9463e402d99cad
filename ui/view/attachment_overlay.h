#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/camera.h"

#include <Eigen/Core>
#include <QPainter>
#include <QString>

#include <vector>

namespace espalier {

/// What is wrongly attached: where it is, and the path to where it belongs. Places in the frame of
/// the file [L].
struct ShownAttachment {
  std::vector<Eigen::Vector3d> wrong; // from the part down to what it is attached to
  std::vector<Eigen::Vector3d> right; // from the part down to what it belongs to
  Color color{};
  QString wrongLabel;
  QString rightLabel;
};

/// Paints it over the plant: a cross where it is, arrows along the path, and a ring at its end.
void paintAttachment(QPainter& painter, const ShownAttachment& attachment, const ScreenMap& screen,
                     bool dark);

} // namespace espalier
