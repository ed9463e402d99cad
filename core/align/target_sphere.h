#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

struct TargetSphereOptions {
  std::optional<double> radius; // [L], > 0; none: it is found, up to half of the reach
  /// [L] from the picked place, > 0: how far points count. None: three radii, or 40 spacings of
  /// the points if the radius is not known.
  std::optional<double> reach;
};

/// A sphere that was put up as a target, as the points of one scan show it.
struct TargetSphere {
  Eigen::Vector3d center; // [L], frame of the file
  double radius;          // [L]
  double residual;        // root mean square distance of its points to it [L]
  Eigen::Index points;    // on it
};

/// The sphere that most points about a picked place lie on.
///
/// Spheres through points drawn about the place compete; that which explains the points within
/// its shell best is fitted to its points by least squares of their distances, again and again
/// without those that then lie off it (over three times the usual distance, a share of 0.005 to
/// 0.1 of the radius). The place may be off by a radius: on the sphere, in it or beside it.
///
/// @param index of the positions of the cloud
/// @param place [L], frame of the file
/// @throws Error     in one line, if an option is out of its range, or there is no sphere: under 12
///                   points lie on it, they show too little of it (a cap of 37 degrees about one
///                   side), or half of the points within 1.5 radii lie off it, as about a stem
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(points within reach); 2000 spheres are judged on 1000 of these at most.
/// Source: M. Fischler, R. Bolles, "Random sample consensus", CACM 24(6), 1981, with the truncated
/// squares of P. Torr, A. Zisserman, "MLESAC", CVIU 78, 2000.
[[nodiscard]] TargetSphere targetSphere(const PointCloud& cloud, const SpatialIndex& index,
                                        const Eigen::Vector3d& place,
                                        const TargetSphereOptions& options = {},
                                        const Progress& progress = {});

} // namespace espalier
