#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Geometry>

namespace espalier {

/// Spacing below: the larger of the point spacings of the two clouds.
struct CloudFitOptions {
  /// Share of the moved points that the fixed cloud has, too, in (0, 1]; 0: it is found.
  double overlap = 0;
  /// [L] How far off the starting motion may leave a point; 0: a tenth of the diagonal of the fixed
  /// cloud without its far points.
  double reach = 0;
};

/// The motion that lays one cloud on another, and how well it does.
struct CloudFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // from the moved frame to the fixed one
  double rms = 0;         // root mean square distance of what overlaps, across its surfaces [L]
  double overlap = 0;     // share of the moved points within 2 spacings of the fixed cloud
  int iterations = 0;     // of all scales
  bool converged = false; // the last step was under a fiftieth of the spacing
};

/// Refines how a cloud lies on another that shows the same plant.
///
/// Pairs each point with the nearest one of the fixed cloud, and takes the small motion that brings
/// the pairs together: iterated closest points. A pair pulls across what the points about it
/// sample: toward the plane of a surface, toward the line of a twig, and from all sides where they
/// show neither. Both clouds are thinned to one point per cube, the coarsest 16 spacings wide, each
/// next half as wide, the last one spacing; the reach shrinks with them. Of the pairs within reach
/// the nearest count: as many as the overlap says, or that share whose fractional distance is the
/// least. Where scanners are known, surfaces that face away from each other are no pairs, those of
/// a pair pull along the middle of their normals, and once a tenth of the points has a surface that
/// faces as its counterpart does, these alone decide: so a stem that is seen from two sides is not
/// pressed flat. Stations on opposite sides of a plant share no surface, and what they show of thin
/// twigs is laid on each other: it ends up to some spacings off.
///
/// @param start  where the moved cloud lies so far
/// @throws Error     if an option is out of its range, a cloud has under 20 points, or the two do
///                   not overlap: under 10 pairs are within reach, or in the end under a tenth of
///                   the moved points have the other cloud near
/// @throws Cancelled if `progress` asks to stop
/// Deterministic for any number of threads. Time O(N log N), and 20 to 30 iterations of 20 000
/// queries; 200 at most.
/// Source: P. Besl, N. McKay, "A method for registration of 3-D shapes", PAMI 14(2), 1992; pulling
/// across surfaces: Y. Chen, G. Medioni, Image and Vision Computing 10(3), 1992, by the spread of
/// the neighbors after A. Segal et al., "Generalized-ICP", RSS 2009; trimmed: D. Chetverikov et
/// al., ICPR 2002; its share: J. Phillips et al., "Outlier robust ICP for minimizing fractional
/// RMSD", 3DIM 2007; middle of normals: S. Rusinkiewicz, "A symmetric objective function for ICP",
/// ACM Trans. Graph. 38(4), 2019.
[[nodiscard]] CloudFit fitClouds(const PointCloud& fixed, const PointCloud& moved,
                                 const Eigen::Isometry3d& start,
                                 const CloudFitOptions& options = {},
                                 const Progress& progress = {});

} // namespace espalier
