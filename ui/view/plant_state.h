#pragma once

#include "core/cloud/ball.h"
#include "core/skeleton/skeleton.h"
#include "ui/view/node_look.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// Of the divider of a view.
enum class Side : std::uint8_t { left, right };

/// Another state of a plant than it has: what other options would make of its scan.
struct PlantState {
  QString name;                                       // written on its side
  std::shared_ptr<const Eigen::Matrix3Xf> contracted; // about the origin of the cloud; null: none
  /// Where each of these points was scanned; null: all points of the cloud, in their order.
  std::shared_ptr<const Eigen::Matrix3Xf> scanned;
  std::vector<Eigen::Index> points = {}; // which of the cloud they are; empty: all, or not known
  Skeleton skeleton;
  std::optional<NodeColors> colors; // of its nodes; none: the accent
  bool replacesPoints = false;      // its contracted points are shown in place of those scanned
  std::optional<Ball> within;       // the plant is as it was elsewhere; none: it shows nowhere
};

} // namespace espalier
