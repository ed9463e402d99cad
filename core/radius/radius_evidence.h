#pragma once

#include "core/base/quadratic.h"
#include "core/radius/fused_radii.h"
#include "core/skeleton/skeleton.h"

#include <array>
#include <vector>

namespace espalier {

/// What is known of a radius besides itself. Lengths in point spacings.
struct RadiusEvidence {
  double radius = 0;       // as fused, > 0
  double measured = 0;     // that was taken from points; 0: none was
  double model = 0;        // that the model has here, > 0
  double share = 0;        // of measurements in the radius, in [0, 1]
  double deviation = 0;    // of its logarithm, as the fusion has it, > 0
  double modelSpread = 0;  // of logarithms of radii about the model, > 0
  double exponent = 0;     // of the model; 0: it is no pipe model
  double pointError = 0;   // of points across thick wood; 0: not known
  double meanDistance = 0; // of its points to the skeleton; 0: it has none
  double points = 0;       // that it has
  double carried = 0;      // length of the wood that it carries
};

/// What errors follow from.
[[nodiscard]] std::array<double, 11> featuresOf(const RadiusEvidence& evidence);

/// Where the true radius lies, as logarithms of its ratio to the one that was found: a twentieth of
/// all is below the first, half below the second, a twentieth above the last.
struct RadiusQuantiles {
  double low = 0;
  double middle = 0;
  double high = 0;
};

/// What gives them.
struct RadiusRegression {
  Quadratic<11> low;
  Quadratic<11> middle;
  Quadratic<11> high;

  [[nodiscard]] RadiusQuantiles of(const RadiusEvidence& evidence) const; // in rising order
};

/// The one that is fitted: by espalier_fit_radii (tests/bench/fit_radii.cpp) on simulated scans.
[[nodiscard]] const RadiusRegression& fittedRadiusRegression();

/// A radius and where it is from.
struct KnownRadius {
  double radius = 0; // [L]
  RadiusOrigin origin;
};

/// What is to be made of fused radii by what is known of them, by id.
///
/// Where a thin radius is uncertain it is corrected by the middle: wholly if the interval spans a
/// factor of e^0.9 and the radius is under 2 spacings, not at all below e^0.5 or over 3. The
/// quantiles are means along the axis, of a node and those
/// next to it, by 1 to 2 to 1.
/// @param evidence by id
/// @param spacing  of the points [L], > 0
/// Time O(n).
[[nodiscard]] std::vector<KnownRadius>
knownRadii(const Skeleton& skeleton, const std::vector<RadiusEvidence>& evidence, double spacing,
           const RadiusRegression& regression = fittedRadiusRegression());

} // namespace espalier
