#pragma once

#include "core/cloud/point_cloud.h"
#include "ui/view/point_look.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// Which of two scans is looked at: the other steps back, behind it and paler.
enum class Foreground : std::uint8_t { both, fixed, moved };

/// A target that two scans show, as far as it was picked.
struct ShownTarget {
  int number = 0;
  std::optional<Eigen::Vector3d> fixed; // [L], frame of the file
  std::optional<Eigen::Vector3d> moved; // [L], frame of the scan that is moved
  bool isWorst = false;                 // the places of no other pair are as far apart
};

/// Another scan over the one of the plant, where it was moved to: each has a color of its own.
struct ShownScan {
  std::shared_ptr<const PointCloud> cloud;                  // not null
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // to the frame of the file
  Foreground foreground = Foreground::both;
  std::optional<PointValues> values = {}; // its points are colored by, in place of its color
  std::vector<ShownTarget> targets = {};
};

} // namespace espalier
