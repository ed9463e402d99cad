#pragma once

#include "core/base/progress.h"
#include "core/radius/assigned_radii.h"
#include "core/radius/cylinder_fit.h"
#include "core/skeleton/skeleton.h"

#include <optional>
#include <vector>

namespace espalier {

/// A radius taken from points, and how far it can be trusted.
struct MeasuredRadius {
  double radius = 0;    // [L]; 0: there is none
  double deviation = 0; // of the logarithm of the radius, about: 0.1 is 10 %
};

struct CylinderOptions {
  double leastCoverage = 0.3; // share of the way around that points must cover, in (0, 1]
  double length = 4;          // of the wood looked at, in radii, > 0
  double spacing = 0;         // [L] between neighboring points, >= 0
};

/// Cylinders fitted to the wood about each node, by id; none where points do not show one.
///
/// Each node that has points looks at those of the nodes next to it on its axis, too, as far as
/// options.length asks and until there are 24. A fit counts if its points cover enough of the way
/// around, two thirds of them lie on it, and their error is under 30 % of the radius.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Uses all threads. Time O(N length / node spacing).
/// Source: the surface-coverage filter of P. Raumonen et al., Remote Sens. 5, 2013.
[[nodiscard]] std::vector<std::optional<FittedCylinder>>
cylindersAbout(const Skeleton& skeleton, const AssignedPoints& points,
               const CylinderOptions& options, const Progress& progress = {});

/// The error of points across thick wood [L]: the median of those of cylinders at least 5 of their
/// errors thick of which half is seen; 0 if there are none.
[[nodiscard]] double pointError(const std::vector<std::optional<FittedCylinder>>& cylinders);

/// `cylinders` without those whose points scatter more than the points and wood itself do: by 1.5
/// times `error` and the 4 % of the radius that wood is no cylinder. They are of needles and leaves
/// around the wood, and too thick.
/// @param error [L] of the points, >= 0; 0, unknown: all stay
[[nodiscard]] std::vector<std::optional<FittedCylinder>>
withoutScattered(std::vector<std::optional<FittedCylinder>> cylinders, double error);

/// The radii of these cylinders, by id, less what the scatter of the points adds to a least-squares
/// fit: error^2 / (2 radius).
///
/// The deviation adds up, squared: 4 % that wood is no cylinder; the error of the points by their
/// number and by how far around they are; and a tenth of a spacing, by which a beam widens what it
/// grazes.
/// @param spacing [L] between neighboring points, >= 0
/// Source of the bias: A. Al-Sharadqah, N. Chernov, "Error analysis for circle fitting algorithms",
/// Electron. J. Stat. 3, 2009.
[[nodiscard]] std::vector<MeasuredRadius>
cylinderRadii(const std::vector<std::optional<FittedCylinder>>& cylinders, double spacing);

/// `measured` with radii, too, of nodes with at least 3 points that have none: wood too thin, or
/// too badly seen, for a cylinder.
///
/// Of distances to the axis scattered by `error`, those along the beam add to the radius and those
/// along the surface to its square. So the radius is h + sqrt((d + h)^2 - error^2), where d is the
/// distance that a tenth of them is below, and 2h = 1.28 errors is what that of normal ones lies
/// under their middle; it is h at least. The tenth is of the wood even if most points are of
/// needles or split beams. Nodes with fewer than 12 points take those of up to 4 nodes next to them
/// on either side. The deviation is 20 %.
/// @param error [L] of the points, >= 0
/// Deterministic. Time O(N log N).
[[nodiscard]] std::vector<MeasuredRadius> withThinRadii(const Skeleton& skeleton,
                                                        const AssignedPoints& points,
                                                        std::vector<MeasuredRadius> measured,
                                                        double error);

} // namespace espalier
