#pragma once

#include "core/decide/error_evidence.h"

#include <vector>

namespace espalier {

/// How probable it is of each edge that it is invented or wrongly attached, by id of its upper
/// node, in [0, 1]; 0 of roots and where there is no node. Each edge is rated with the piece of its
/// axis that it is in. Uncertain radii are no error. Parameters, errors and cost as
/// errorEvidence().
[[nodiscard]] std::vector<double>
errorProbabilities(const Skeleton& skeleton, const PointDistances& distances,
                   const SpatialIndex& index, const PlantScale& scale, const Eigen::Vector3d& up,
                   const Progress& progress = {});

} // namespace espalier
