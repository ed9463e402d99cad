#pragma once

#include "core/decide/error_evidence.h"

#include <optional>
#include <vector>

namespace espalier {

/// Where a plant is probably wrong, and by what evidence.
struct ErrorRatings {
  std::vector<double> ofEdges; // probabilities by id of the upper node, in [0, 1]; 0 of roots and
                               // where there is no node
  std::vector<Stretch> pieces; // of axes: an edge is rated with the piece that it is in
  std::vector<ErrorEvidence> evidence; // of each piece
};

/// How probable it is of each edge that it is invented or wrongly attached. Uncertain radii are no
/// error. Parameters, errors and cost as errorEvidence().
[[nodiscard]] ErrorRatings errorRatings(const Skeleton& skeleton, const PointDistances& distances,
                                        const SpatialIndex& index, const PlantScale& scale,
                                        const Eigen::Vector3d& up, const Progress& progress = {});

/// Of the pieces that nodes are in, the one with the most length among them that is probably wrong.
/// None: they have no length, or are not rated. O(N).
[[nodiscard]] std::optional<std::size_t> riskiestPiece(const ErrorRatings& ratings,
                                                       const std::vector<NodeId>& nodes);

} // namespace espalier
