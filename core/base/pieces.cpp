#include "core/base/pieces.h"

#include "core/base/parallel.h"

namespace espalier {

void runInPieces(Eigen::Index count, Eigen::Index grain,
                 const std::function<void(Eigen::Index, Eigen::Index)>& work) {
  inPieces(count, grain, work);
}

} // namespace espalier
