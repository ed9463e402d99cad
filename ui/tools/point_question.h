#pragma once

#include "core/cloud/point_set.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace espalier {

/// What a tool asks of the points of the scan: all of the thing that was clicked.
struct PointQuestion {
  enum class Thing : std::uint8_t { pole, wire, plant };

  Thing thing = Thing::pole;
  std::vector<Eigen::Vector3d> places; // one, of a wire two [L], frame of the file
};

/// Called on the GUI thread, unless the question could not be answered.
using PointAnswer = std::function<void(const PointSet& points)>;

} // namespace espalier
