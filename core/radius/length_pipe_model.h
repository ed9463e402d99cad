#pragma once

#include "core/radius/measured_radius.h"
#include "core/skeleton/skeleton.h"

#include <optional>
#include <vector>

namespace espalier {

/// A pipe model by length: r(v) = scale * (length(v) + tipLength)^exponent, where length(v) is what
/// v carries. Unlike the count of nodes, the length does not depend on how nodes are spaced.
struct LengthPipeModel {
  double scale = 0;     // [L^(1 - exponent)], > 0
  double tipLength = 0; // [L], > 0: what a tip would carry
  double exponent = 0;  // in [0, 1]; 1/3 to 1/2 in published structures
  double spread = 0;    // standard deviation of the logarithm of radii about it

  [[nodiscard]] double radius(double carried) const; // [L]
};

/// The model through two radii: that of the heaviest root and that of the tips, which carry a
/// median edge. All radii are 0 if the apex radius is. pre: rootRadius >= apexRadius >= 0 [L]
[[nodiscard]] LengthPipeModel lengthPipeThrough(const Skeleton& skeleton, double rootRadius,
                                                double apexRadius);

/// The model with the least sum of the absolute distances of logarithms to measured radii, in their
/// deviations, so that wrong ones do not pull it.
///
/// @param measured  by id
/// @return none if fewer than 8 nodes, or nodes that carry all the same, are measured
/// Deterministic. Time O(n).
/// Source: K. Shinozaki et al., "A quantitative analysis of plant form: the pipe model theory",
/// Jpn. J. Ecol. 14, 1964; E. J. Schlossmacher, "An iterative technique for absolute deviations
/// curve fitting", JASA 68, 1973.
[[nodiscard]] std::optional<LengthPipeModel>
fittedLengthPipe(const Skeleton& skeleton, const std::vector<MeasuredRadius>& measured);

/// The radii of a model, by id [L].
[[nodiscard]] std::vector<double> radiiOf(const Skeleton& skeleton, const LengthPipeModel& model);

/// The average-constrained pipe model: r(v) = root * (w(v) / w(root))^exponent, where w is
/// log(1 + length carried / median edge) + a share for tips, and the root radius follows from the
/// mean of all radii by w, which is `meanRadius`.
///
/// @param meanRadius  [L], > 0: the mean distance of the points to the skeleton
/// @param exponent    > 0
/// @return by id [L]
/// Time O(n). Source: PlantScan3D's pipe model of this name; Y. Livny et al., ACM Trans. Graph.
/// 29(6), 2010, with exponent 2.5. Differs: lengths are taken in median edges, so that the unit
/// does not matter, and a tip carries half of one, so that it has a radius.
[[nodiscard]] std::vector<double> averagePipeRadii(const Skeleton& skeleton, double meanRadius,
                                                   double exponent);

} // namespace espalier
