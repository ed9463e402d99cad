#pragma once

#include <Eigen/Core>

#include <functional>

namespace espalier {

/// As inPieces() of core/base/parallel.h, for sources that include Qt: what that header includes
/// does not compile after Qt's macros.
void runInPieces(Eigen::Index count, Eigen::Index grain,
                 const std::function<void(Eigen::Index, Eigen::Index)>& work);

} // namespace espalier
