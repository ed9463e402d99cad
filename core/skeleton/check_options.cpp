#include "core/skeleton/check_options.h"

#include <algorithm>
#include <cmath>

namespace espalier {

CheckOptions atSensitivity(const CheckOptions& options) {
  const double by = options.sensitivity;
  CheckOptions limits = options;
  limits.sensitivity = 1;
  for (double CheckOptions::*turn :
       {&CheckOptions::sharpTurn, &CheckOptions::branchTurn, &CheckOptions::hiddenTurn})
    limits.*turn = 2 * std::atan(std::tan(options.*turn / 2) / by);
  for (double CheckOptions::*more :
       {&CheckOptions::shortEdge, &CheckOptions::duplicateShare, &CheckOptions::touch})
    limits.*more *= by;
  for (double CheckOptions::*less :
       {&CheckOptions::detour, &CheckOptions::thicker, &CheckOptions::pointReach,
        &CheckOptions::emptyReach, &CheckOptions::ownLength, &CheckOptions::fewestExpected,
        &CheckOptions::besideUnits, &CheckOptions::besideRadii, &CheckOptions::footSpacings,
        &CheckOptions::footRadii})
    limits.*less /= by;
  for (int CheckOptions::*count : {&CheckOptions::clusterSize, &CheckOptions::largeCluster})
    limits.*count = std::max(1, static_cast<int>(std::lround(options.*count / by)));
  return limits;
}

} // namespace espalier
