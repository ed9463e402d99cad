#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <QString>

#include <functional>
#include <vector>

namespace espalier {

struct Camera;

/// Shows what one flies to, as ShownFlow::reveal.
using Reveal =
    std::function<QString(const std::vector<NodeId>& nodes,
                          const std::vector<Eigen::Vector3d>& places, const Camera& camera)>;

} // namespace espalier
