#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

struct ContractionQualityOptions {
  double spacing = 0; // between neighboring points of the whole scan [L], > 0
  /// [L], frame of the points. Ends of each connected part are sought from the point of it that
  /// is nearest to the root; without one, from the point farthest from its mean.
  std::optional<Eigen::Vector3f> root = {};
};

/// Numbers by which a contraction, and a skeleton made from it, are judged without a reference.
///
/// The plant is seen through one point per cube of 2 spacings, linked to its 8 nearest within 5
/// spacings; what is connected by fewer than 10 such links is dust and does not count. "Near a
/// point" is within 10 spacings of it along these links, where it was scanned: so a neighboring
/// twig does not count as thickness. An end is that of a branch longer than 14 spacings, a little
/// more than what pruning leaves by default.
struct ContractionQuality {
  /// How thick what was contracted still is [spacings]: the median over the plant of the root mean
  /// square distance of the contracted points near a point from the line through them, their local
  /// axis (its principal component). 0 for lines; its radius for an uncontracted cylinder.
  double residualThickness = 0;
  /// Share of the points near which the contracted ones lie on a line: more than 0.9 of their
  /// variance is along it (the share at which H. Huang et al., ACM Trans. Graph. 32(4), 2013, stop
  /// contracting).
  double shareOnLine = 0;
  /// Ends of the scan: what no part farther from the root follows, on branches that long.
  Eigen::Index tips = 0;
  /// Those with no contracted point, or with a skeleton no apex of it, within 7 spacings: half of
  /// such a branch is gone.
  Eigen::Index lostTips = 0;
  /// Places where contracted points lie within a spacing of each other, though along the plant they
  /// are over 20 spacings apart and over 3 times as far as straight through space.
  Eigen::Index bridgedJunctions = 0;
  double skeletonLength = 0; // [L]; 0 without a skeleton, as the next two
  /// Points whose contracted place is more than 3 spacings off all edges, where these have their
  /// radius. Found by one point per cube for all points in it.
  Eigen::Index unexplainedPoints = 0;
  Eigen::Index nodes = 0;
  // By point [spacings]; not a number for dust:
  std::vector<float>
      thicknesses;              // near it; `residualThickness` is their median, a cube one of them
  std::vector<float> residuals; // distance of its contracted place from the local axis
};

/// @param points     as scanned, 3 x N [L]
/// @param contracted their new places, 3 x N [L]
/// All 0 where nothing but dust is. @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N log N).
[[nodiscard]] ContractionQuality contractionQuality(const Eigen::Matrix3Xf& points,
                                                    const Eigen::Matrix3Xf& contracted,
                                                    const ContractionQualityOptions& options,
                                                    const Progress& progress = {});

/// The same with the numbers of a skeleton.
/// @param origin of the points, in the frame of the skeleton [L]
[[nodiscard]] ContractionQuality
contractionQuality(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& contracted,
                   const Skeleton& skeleton, const Eigen::Vector3d& origin,
                   const ContractionQualityOptions& options, const Progress& progress = {});

} // namespace espalier
