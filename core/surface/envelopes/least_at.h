#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <functional>

namespace espalier {

/// Where a function is least, near a start: by a simplex that is reflected, stretched and shrunk.
///
/// @param steps how far the simplex reaches from the start, by coordinate; none is 0
/// @param most  evaluations of the function
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Ends when the simplex is 1e-7 of its first size.
/// Source: J. A. Nelder, R. Mead, "A simplex method for function minimization", The Computer
/// Journal 7, 1965.
[[nodiscard]] Eigen::VectorXd leastAt(const std::function<double(const Eigen::VectorXd&)>& function,
                                      const Eigen::VectorXd& start, const Eigen::VectorXd& steps,
                                      int most, const Progress& progress = {});

} // namespace espalier
