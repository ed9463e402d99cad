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

/// Cylinders fitted to the wood about each node, by id; none where points do not tell.
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

/// The radii of these cylinders, by id.
///
/// The deviation adds up, squared: 4 % that wood is no cylinder; the error of the points by their
/// number and by how far around they are; and a tenth of a spacing, by which a beam widens what it
/// grazes.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<MeasuredRadius> cylinderRadii(const Skeleton& skeleton,
                                                        const AssignedPoints& points,
                                                        const CylinderOptions& options,
                                                        const Progress& progress = {});

/// `measured` with radii, too, of nodes with at least 3 points that have none: wood too thin, or
/// too badly seen, for a cylinder.
///
/// These are the mean distances of points to the skeleton, with a deviation of 20 %. (To take the
/// noise of the points off the distances makes them worse: a skeleton follows the points, noise and
/// all.)
/// Deterministic. Time O(N).
[[nodiscard]] std::vector<MeasuredRadius> withThinRadii(const Skeleton& skeleton,
                                                        const AssignedPoints& points,
                                                        std::vector<MeasuredRadius> measured);

} // namespace espalier
