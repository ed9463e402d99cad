#pragma once

#include "core/base/progress.h"
#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"
#include "core/skeleton/point_distances.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// Where an axis lies beside its points: the wood would fit them better if it were moved aside.
///
/// Around each node, the points along some spacings or diameters of the axis say by how much, with
/// the radius as it is: those nearest to its edges there and some beyond, as points lie beside what
/// is as far along, but are nearest to where the axis comes back to them. A place is reported if
/// that is more than `besideUnits` times `exactness` and `besideRadii` radii, and if the points are
/// then less than half as far from its surface. Nodes in a row are one finding.
/// @param spacing   between neighboring points [L]
/// @param exactness of the skeleton (core/skeleton/checks_of_scan.h) [L]
/// @return parents before their children; `amount` is the farthest that any is to be moved [L]
/// @throws Cancelled if `progress` asks to stop
/// Uses all threads, deterministic. Time O(N + n w): points about w edges around each node.
[[nodiscard]] std::vector<Finding> axesBesidePoints(const Skeleton& skeleton,
                                                    const PointDistances& distances, double spacing,
                                                    double exactness, const CheckOptions& options,
                                                    const Progress& progress = {});

/// By how much a node is to be moved so that the points about it lie on the surface of its wood,
/// whose radius stays, or that it is amid them if they are a blade. None: they are too few, or as
/// near now.
/// @param near    points within some radii of the node, of any wood [L]
/// @param spacing between neighboring points [L], > 0
/// Time O((n + points) log n).
[[nodiscard]] std::optional<Eigen::Vector3d> shiftToPoints(const Skeleton& skeleton, NodeId id,
                                                           const std::vector<Eigen::Vector3d>& near,
                                                           double spacing);

} // namespace espalier
