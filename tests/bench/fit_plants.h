#pragma once

#include "tests/bench/organ_scans.h"
#include "tests/bench/simulated_scans.h"

#include <cstdint>
#include <utility>

namespace espalier {

/// Two plants in three are of any kind, the third shows what its organs are.
[[nodiscard]] inline ScannedPlant plantForFit(std::uint64_t number) {
  if (number % 3 != 0) return scannedPlant(number);
  constexpr std::uint64_t unseen = 7000; // other plants than those that organs are fitted on
  OrganScan scan = organScan(unseen + number);
  return {
      .name = std::move(scan.kind), .truth = std::move(scan.truth), .cloud = std::move(scan.cloud)};
}

} // namespace espalier
