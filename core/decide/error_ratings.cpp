#include "core/decide/error_ratings.h"

#include "core/decide/error_odds.h"

#include <algorithm>

namespace espalier {

ErrorRatings errorRatings(const Skeleton& skeleton, const PointDistances& distances,
                          const SpatialIndex& index, const PlantScale& scale,
                          const Eigen::Vector3d& up, const Progress& progress) {
  ErrorRatings ratings{.ofEdges = std::vector<double>(skeleton.idEnd(), 0),
                       .pieces = stretches(skeleton, ratedLength(scale)),
                       .evidence = {}};
  ratings.evidence = errorEvidence(skeleton, ratings.pieces, distances, index, scale, up, progress);
  for (std::size_t i = 0; i < ratings.pieces.size(); ++i)
    for (const NodeId id : ratings.pieces[i])
      if (skeleton[id].parent)
        ratings.ofEdges[indexOf(id)] = probabilityOfError(ratings.evidence[i]);
  return ratings;
}

std::optional<std::size_t> riskiestPiece(const ErrorRatings& ratings,
                                         const std::vector<NodeId>& nodes) {
  std::vector<bool> isAmong(ratings.ofEdges.size(), false);
  for (const NodeId id : nodes)
    if (indexOf(id) < isAmong.size()) isAmong[indexOf(id)] = true;
  std::optional<std::size_t> worst;
  double most = 0; // [spacings] that are probably wrong
  for (std::size_t i = 0; i < ratings.pieces.size(); ++i) {
    const Stretch& piece = ratings.pieces[i];
    const auto among =
        std::ranges::count_if(piece, [&](NodeId id) { return isAmong[indexOf(id)]; });
    const double share = static_cast<double>(among) / static_cast<double>(piece.size());
    const double wrong =
        share * ratings.evidence[i].length * ratings.ofEdges[indexOf(piece.back())];
    if (wrong <= most) continue;
    most = wrong;
    worst = i;
  }
  return worst;
}

} // namespace espalier
