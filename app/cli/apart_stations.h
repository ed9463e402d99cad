#pragma once

#include "core/simulate/laser_scanner.h"

#include <string>
#include <vector>

namespace espalier {

/// How far the frame of each station but the first is off that of the plant.
struct Displacement {
  double shift = 0; // along x [L]
  double angle = 0; // about the upright axis through the middle of the plant [rad]
};

/// "SHIFT,DEGREES" as a displacement. @throws WrongUsage
[[nodiscard]] Displacement displacementIn(const std::string& text);

/// The files that writeApart() writes: PREFIX_1.ply and on, and PREFIX_pairs.csv.
[[nodiscard]] std::vector<std::string> filesApart(const std::string& prefix, std::size_t stations);

/// Writes the points of each station as a scan of its own, the first in the frame of the plant, the
/// others displaced, and four true pairs of targets for each of these.
/// @throws Error     if a station has no point, or a file cannot be written
/// @throws Cancelled if `progress` asks to stop
void writeApart(const std::string& prefix, const SimulatedScan& scan,
                const Displacement& displacement, const Progress& progress);

} // namespace espalier
