#include "core/decide/error_probabilities.h"

#include "core/decide/error_odds.h"

namespace espalier {

std::vector<double> errorProbabilities(const Skeleton& skeleton, const PointDistances& distances,
                                       const SpatialIndex& index, const PlantScale& scale,
                                       const Eigen::Vector3d& up, const Progress& progress) {
  const std::vector<Stretch> pieces = stretches(skeleton, ratedLength(scale));
  const std::vector<ErrorEvidence> evidence =
      errorEvidence(skeleton, pieces, distances, index, scale, up, progress);
  std::vector<double> result(skeleton.idEnd(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const NodeId id : pieces[i])
      if (skeleton[id].parent) result[indexOf(id)] = probabilityOfError(evidence[i]);
  return result;
}

} // namespace espalier
