#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"
#include "core/skeleton/point_distances.h"

#include <vector>

namespace espalier {

// What a scan says of a skeleton. Distances are to the surface of the wood (PointDistances), and in
// spacings between the points of the scan. A skeleton without nodes has no findings.

/// All findings that a scan shows: those of the checks below, of beside_points.h and short_foot.h.
/// A branch that no points are near to at all is not reported again for having none of its own, nor
/// wood that is likelier hidden (unseen_wood.h), nor points that are off because wood lies beside
/// them or a foot is short, or that are a blade along an axis (blades_along.h).
/// @param distances of the points of the scan to `skeleton`
/// @param index     of the positions of their cloud
/// @param spacing   between neighboring points [L]
/// @throws Cancelled if `progress` asks to stop
/// Uses all threads, deterministic. Time: the sum of all.
[[nodiscard]] std::vector<Finding> checkAgainstScan(const Skeleton& skeleton,
                                                    const PointDistances& distances,
                                                    const SpatialIndex& index, double spacing,
                                                    const CheckOptions& options = {},
                                                    const Progress& progress = {});

/// Those of them that are clusters of points without wood.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<Finding> pointsWithoutWood(const Skeleton& skeleton,
                                                     const PointDistances& distances,
                                                     double spacing, const CheckOptions& options,
                                                     const Progress& progress = {});

/// What lengths of the checks against a scan count in: the spacing of the points, or where points
/// scatter wider about the wood, or the skeleton was drawn less exactly, how far they are from it:
/// the scatter, or 4/3 of the median distance to the surface, where that is more, but at most twice
/// as much as without [L]. Points over 6 spacings or scatters off are missed, and do not count.
/// Time O(N).
[[nodiscard]] double exactness(const PointDistances& distances, double spacing,
                               const CheckOptions& options);

/// Clusters of points that are far from all wood: what the skeleton lacks. The largest first. Small
/// ones are reported where they stand out, as twigs do and fuzz about wood does not.
/// @param spacing between neighboring points [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) for N points that are far.
[[nodiscard]] std::vector<Finding> unexplainedClusters(const PointDistances& distances,
                                                       double spacing, const CheckOptions& options,
                                                       const Progress& progress = {});

/// Edges that no point is near to along more than half of them: what the skeleton has too much, or
/// nobody saw. Those that are connected are one finding, at the lowest of them.
/// @param index   of the positions of `cloud`
/// @param spacing between neighboring points [L]
/// @throws Cancelled if `progress` asks to stop
/// Uses all threads, deterministic. Time O(length / spacing log N).
[[nodiscard]] std::vector<Finding>
edgesWithoutPoints(const Skeleton& skeleton, const PointCloud& cloud, const SpatialIndex& index,
                   double spacing, const CheckOptions& options, const Progress& progress = {});

/// Branches that begin with a stretch along which no points are their own: spurs, and branches that
/// are attached across a gap to wood they do not grow from. Points may lie all about such a
/// stretch, as long as other wood explains them.
///
/// A point is a branch's own if its surface, or that of what it carries, is the nearest there is,
/// and no other wood is within `ownBeside` spacings. What of a branch is that near to other wood
/// says nothing of it and is passed over. A branch is reported if it begins with over `ownLength`
/// spacings, or is that much as a whole, that have under `ownCount` own points within reach.
/// @param distances of the points of the scan to `skeleton`
/// @param index     of the positions of their cloud
/// @param spacing   between neighboring points [L]
/// @return parents before their children; `amount` is the length of the stretch [L], `others` are
///         the nodes along it behind the first
/// @throws Cancelled if `progress` asks to stop
/// Uses all threads, deterministic. Time O(n log n + b p log n): p points about each of b branches.
[[nodiscard]] std::vector<Finding>
branchesWithoutOwnPoints(const Skeleton& skeleton, const PointDistances& distances,
                         const SpatialIndex& index, double spacing, const CheckOptions& options,
                         const Progress& progress = {});

} // namespace espalier
