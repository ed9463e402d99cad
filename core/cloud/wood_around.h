#pragma once

#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

/// What the points around a place show of the wood there.
struct WoodAround {
  /// [L], noise included: that of a ring with the second and third standard deviations of the
  /// points. Wood seen from one side looks up to a quarter thinner. None: it is thicker than can be
  /// seen in the largest ball, or other wood lies too near.
  std::optional<double> thickness;
  /// Standard deviation of the points normal to the surface [L]; none: too few points.
  std::optional<double> scatter;
  /// How far around the wood there are points [rad], in (0, 2 pi], to 1/16 of a turn; none where
  /// the wood is under 3 spacings thick, has under 48 points, or scatters over a third of its
  /// radius.
  std::optional<double> arc;
};

struct WoodLook {
  double farthest = 32; // [spacings], radius of the largest ball, up to 32
  /// Whether fewer than 24 points along a line must be so in the next ball, too: they may lie along
  /// one by chance.
  bool confirms = true;
};

/// Looks around a place in balls that grow from 2 spacings until the points in one lie along a
/// line: their second standard deviation at most 0.35 of the first. From 8 spacings on, only the
/// points count that cubes of 2 spacings join with the place: other wood often lies nearer.
///
/// Of points along a line, the scatter is that about the circle fitted to them across the line. Of
/// squared distances p from its center, the mean is r^2 + 2 s^2 and the variance 4 r^2 s^2 + 4 s^4
/// for a ring of radius r whose points scatter by s in both directions, which gives s however it
/// compares with r. Of points on a sheet, it is that about the paraboloid fitted to them.
///
/// @param index    of the points; finds those that count
/// @param spacing  of the points [L], > 0
/// Without noise, points scatter by up to 0.1 spacings all the same; by over some 3 spacings, up to
/// a third too little is found, as the outermost points are not joined with the others.
///
/// Source of the moments: S. O. Rice, "Mathematical analysis of random noise", Bell Syst. Tech. J.
/// 24, 1945.
[[nodiscard]] WoodAround woodAround(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                                    Eigen::Index place, double spacing, const WoodLook& look = {});

} // namespace espalier
