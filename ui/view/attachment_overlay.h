#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/camera.h"

#include <Eigen/Core>
#include <QPainter>
#include <QString>

#include <vector>

namespace espalier {

/// What hangs wrong: where it hangs, and the way to where it belongs. Places in the frame of the
/// file [L].
struct ShownAttachment {
  std::vector<Eigen::Vector3d> wrong; // from what hangs down to what it hangs on
  std::vector<Eigen::Vector3d> right; // from what hangs down to what it belongs on
  Color color{};
  QString wrongLabel;
  QString rightLabel;
};

/// Paints it over the plant: a cross where it hangs, arrows along the way, and a ring at its end.
void paintAttachment(QPainter& painter, const ShownAttachment& attachment, const ScreenMap& screen,
                     bool dark);

} // namespace espalier
